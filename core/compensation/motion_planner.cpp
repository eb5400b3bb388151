#include "core/compensation/motion_planner.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/units.h"
#include "core/simulation/command_path.h"

namespace nineline::compensation {

using nc::AxisValues;
using nc::Motion;
using nc::MotionKind;
using simulation::jointsOf;
using simulation::valuesOf;

namespace {

constexpr double kStandstill = 1e-12;
constexpr int kDeepest = 14;                         // a block becomes 2^14 pieces at most
constexpr double kRotaryFeature = radFromDeg(15.0);  // errors turn with a rotary joint: theory.md, 1.8
constexpr double kSmallestArc = radFromDeg(1.0);
constexpr int kMostInner = 32;

AxisValues between(const AxisValues& a, const AxisValues& b, double u) {
  AxisValues values;
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = a[k] + u * (b[k] - a[k]);
  return values;
}

bool isInPlane(const Motion& motion, int axis) {
  return motion.kind == MotionKind::Arc && (axis == motion.plane[0] || axis == motion.plane[1]);
}

double radiusOf(const Motion& motion) {
  return std::hypot(motion.start[static_cast<std::size_t>(motion.plane[0])] - motion.centre[0],
                    motion.start[static_cast<std::size_t>(motion.plane[1])] - motion.centre[1]);
}

}  // namespace

MotionPlanner::MotionPlanner(const ErrorModel& model, const ProgramSetup& setup,
                             const CompensationOptions& options)
    : model_(model), machine_(model.machine()), options_(options), solver_(model, options) {
  solver_.conditions() = setup.state;
  turned_.fill(std::numeric_limits<double>::infinity());
  for (int i = 0; i < machine_.jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    follows_sense_ = follows_sense_ || model_.followsSense(i);
    if (model_.play(i) == 0.0) continue;
    // What a change of sense moves along the joint's own direction, at this point and so everywhere.
    errors::MachineState state = setup.state;
    std::array<double, 2> along{};
    for (const int side : {0, 1}) {
      state.approach[k] = side == 0 ? -1 : 1;
      kinematics::JointDisplacements displacements;
      model_.displacements(state, {}, displacements);
      const kinematics::SmallMotion& moved = displacements[k].moved;
      along[static_cast<std::size_t>(side)] =
          machine_.joint(i).direction.dot(machine_.isRotary(i) ? moved.rotation : moved.translation);
    }
    play_[k] = along[0] - along[1];
    has_play_ = has_play_ || play_[k] != 0.0;
  }
}

void MotionPlanner::setResolution(double linear, double rotary) {
  options_.tolerance = std::max(options_.tolerance, 0.5 * linear);
  options_.angle_tolerance = std::max(options_.angle_tolerance, 0.5 * rotary);
  rotary_step_ = rotary;
}

void MotionPlanner::pass(const Motion& motion) {
  updateSenses(motion, 0.0, 1.0);
  now_ = senses_;
  last_.reset();
}

void MotionPlanner::updateSenses(const Motion& motion, double from, double to) {
  const AxisValues a = positionAt(motion, machine_.jointCount(), from);
  const AxisValues b = positionAt(motion, machine_.jointCount(), to);
  const Result<JointPositions> qa = jointsOf(machine_, a, motion.tool_centre_point);
  const Result<JointPositions> qb = jointsOf(machine_, b, motion.tool_centre_point);
  if (!qa || !qb) return;
  turned_ = travelSinceReversal(*qa);
  section_ = *qa;
  for (std::size_t k = 0; k < senses_.size(); ++k) {
    const double travel = (*qb)[k] - (*qa)[k];
    if (std::abs(travel) <= kStandstill) continue;
    const std::int8_t sense = travel > 0.0 ? 1 : -1;
    if (sense == -senses_[k]) turned_[k] = 0.0;
    senses_[k] = sense;
  }
}

JointPositions MotionPlanner::travelSinceReversal(const JointPositions& ideal) const {
  JointPositions travel = turned_;
  for (std::size_t k = 0; k < travel.size(); ++k) travel[k] += std::abs(ideal[k] - section_[k]);
  return travel;
}

/// d z / d φ of the ideal tool point about the work spindle, by central differences of the exact chain.
std::optional<double> MotionPlanner::advanceAt(const Motion& motion, double fraction) const {
  if (options_.mode != Mode::Thread) return std::nullopt;
  constexpr double kStep = 1e-4;
  const double low = std::max(0.0, fraction - kStep);
  const double high = std::min(1.0, fraction + kStep);
  const auto tipAt = [&](double t) {
    return forward(machine_, positionAt(motion, machine_.jointCount(), t)).tip;
  };
  const Eigen::Vector3d axis = machine_.joint(machine_.workpieceJointCount() - 1).direction;
  const Eigen::Vector3d a = tipAt(low);
  const Eigen::Vector3d b = tipAt(high);
  const Eigen::Vector3d across_a = a - axis * axis.dot(a);
  const Eigen::Vector3d across_b = b - axis * axis.dot(b);
  const double turned = std::atan2(axis.dot(across_a.cross(across_b)), across_a.dot(across_b));
  if (std::abs(turned) < 1e-9) return std::nullopt;
  return axis.dot(b - a) / turned;
}

Result<MotionPlanner::Node> MotionPlanner::solveAt(const Motion& motion, double fraction) {
  Node node;
  node.fraction = fraction;
  const Result<JointPositions> ideal =
      jointsOf(machine_, positionAt(motion, machine_.jointCount(), fraction), motion.tool_centre_point);
  if (!ideal) return ideal.error();
  node.ideal = *ideal;
  JointPositions guess = node.ideal;
  for (std::size_t k = 0; k < guess.size(); ++k) {
    if (((free_ | scope_.held) >> k & 1U) != 0) guess[k] += correction_[k];
  }
  solver_.conditions().since_reversal = travelSinceReversal(node.ideal);
  Result<JointPositions> corrected =
      solver_.solve({node.ideal, senses_, free_, advanceAt(motion, fraction)}, guess);
  if (!corrected) return corrected.error();
  node.corrected = *corrected;
  for (std::size_t k = 0; k < guess.size(); ++k) correction_[k] = node.corrected[k] - node.ideal[k];
  if (Result<void> fine = checkLimits(node, motion); !fine) return fine.error();
  if (!has_play_) return node;
  for (std::size_t k = 0; k < guess.size(); ++k) {
    if (isFree(k)) node.corrected[k] -= 0.5 * senses_[k] * play_[k];
  }
  return node;
}

Result<void> MotionPlanner::checkLimits(const Node& node, const Motion& motion) const {
  for (int i = 0; i < machine_.jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const bool rotary = machine_.isRotary(i);
    const double size = std::abs(node.corrected[k] - node.ideal[k]);
    const double limit = rotary ? options_.largest_angle_correction : options_.largest_correction;
    if (size <= limit) continue;
    return noAnswer("compensation.limit",
                    fmt::format("Line {}: the correction of {} is {:.6g} {}, above the limit of {:.6g}.",
                                motion.line, machine_.joint(i).axis.text(), rotary ? degFromRad(size) : size,
                                rotary ? "deg" : "mm", rotary ? degFromRad(limit) : limit),
                    {}, motion.line);
  }
  if (const int joint = machine_.firstOutsideTravel(node.corrected); joint >= 0) {
    const double q = node.corrected[static_cast<std::size_t>(joint)];
    return noAnswer(
        "travel",
        fmt::format("Line {}: the corrected command {}{:.4f} lies outside the travel.", motion.line,
                    machine_.joint(joint).axis.text(), machine_.isRotary(joint) ? degFromRad(q) : q),
        {}, motion.line);
  }
  return {};
}

Result<void> MotionPlanner::plan(const Motion& motion, const Scope& scope, const AxisValues& from,
                                 std::vector<Piece>& pieces) {
  pieces.clear();
  exceeded_ = false;
  scope_ = scope;
  scope_.may_split = scope.may_split && !options_.keep_block_count && motion.role == nc::MotionRole::Block;
  free_ = solver_.freeJoints(scope.free);
  for (std::size_t k = 0; k < correction_.size(); ++k) correction_[k] = from[k] - motion.start[k];
  if (motion.tool_centre_point) correction_.fill(0.0);
  if (Result<void> started = startFrom(motion, from); !started) return started;
  std::vector<double> cuts;
  if (scope_.may_split && follows_sense_) {
    simulation::reversalFractions(motion, cuts);
    std::erase_if(cuts, [&](double fraction) {  // only where an error of the axis follows its sense
      const AxisValues at = positionAt(motion, machine_.jointCount(), fraction);
      const auto first = static_cast<std::size_t>(motion.plane[0]);
      const auto second = static_cast<std::size_t>(motion.plane[1]);
      const bool first_reverses =
          std::abs(at[second] - motion.centre[1]) < std::abs(at[first] - motion.centre[0]);
      return !model_.followsSense(first_reverses ? motion.plane[0] : motion.plane[1]);
    });
  }
  double begin = 0.0;
  cuts.push_back(1.0);
  for (const double end : cuts) {
    if (Result<void> planned = planSection(motion, begin, end, pieces); !planned) return planned;
    begin = end;
  }
  return {};
}

Result<void> MotionPlanner::planSection(const Motion& motion, double from, double to,
                                        std::vector<Piece>& pieces) {
  updateSenses(motion, from, from + 0.5 * (to - from));
  for (std::size_t k = 0; k < now_.size(); ++k) {
    if (!isFree(k)) now_[k] = senses_[k];
  }
  const Result<JointPositions> ideal =
      jointsOf(machine_, positionAt(motion, machine_.jointCount(), from), motion.tool_centre_point);
  if (!ideal) return ideal.error();
  // The corrected program stands where its last block put it; its rounding is no reason to subdivide.
  Node start{from, *ideal, stands_};
  for (std::size_t k = 0; k < stands_.size(); ++k) start.corrected[k] -= followed_[k];
  const Result<Node> end = solveAt(motion, to);
  if (!end) return end.error();
  for (std::size_t k = 0; k < largest_.size(); ++k)
    largest_[k] = std::max(largest_[k], std::abs(end->corrected[k] - end->ideal[k]));
  if (motion.kind == MotionKind::Rapid) {
    emit(motion, *end, Piece{}, pieces);
  } else if (Result<void> refined = refine(motion, start, *end, 0, pieces); !refined) {
    return refined;
  }
  for (std::size_t k = 0; k < now_.size(); ++k) {
    if (isFree(k) && now_[k] != 0) senses_[k] = now_[k];
  }
  last_ = end->ideal;
  return {};
}

Result<void> MotionPlanner::refine(const Motion& motion, const Node& a, const Node& b, int depth,
                                   std::vector<Piece>& pieces) {
  Piece piece;
  piece.from = a.fraction;
  piece.to = b.fraction;
  piece.end = valuesOf(machine_, b.corrected, motion.tool_centre_point);
  const Result<bool> fits =
      motion.kind == MotionKind::Arc ? arcFits(motion, a, b, piece) : lineFits(motion, a, b);
  if (!fits) return fits.error();
  const bool too_short =
      motion.kind == MotionKind::Arc && std::abs(motion.sweep) * (b.fraction - a.fraction) < kSmallestArc;
  if (*fits || depth >= kDeepest || too_short || !scope_.may_split) {
    exceeded_ = exceeded_ || !*fits;
    emit(motion, b, piece, pieces);
    return {};
  }
  const Result<Node> middle = solveAt(motion, 0.5 * (a.fraction + b.fraction));
  if (!middle) return middle.error();
  if (Result<void> left = refine(motion, a, *middle, depth + 1, pieces); !left) return left;
  return refine(motion, *middle, b, depth + 1, pieces);
}

double MotionPlanner::distance(const JointPositions& a, const JointPositions& b, double& tilt) {
  const ToolPose pose_a = forward(machine_, a);
  const ToolPose pose_b = forward(machine_, b);
  tilt = pose_a.axis.cross(pose_b.axis).norm();
  return (pose_a.tip - pose_b.tip).norm();
}

int MotionPlanner::innerSamples(const Motion& motion, const Node& a, const Node& b) const {
  double features = 0.0;
  for (int i = 0; i < machine_.jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double travel = isInPlane(motion, i)
                              ? std::abs(motion.sweep) * (b.fraction - a.fraction) * radiusOf(motion)
                              : std::abs(b.ideal[k] - a.ideal[k]);
    if (travel < kStandstill) continue;
    const double feature =
        machine_.isRotary(i) ? std::min(model_.featureLength(i), kRotaryFeature) : model_.featureLength(i);
    features = std::max(features, travel / feature);
  }
  return std::clamp(static_cast<int>(std::ceil(2.0 * features)), 1, kMostInner);
}

/// A block that is short against every feature of the errors cannot bend: its bow is below |correction| ·
/// (ℓ/L)²/2.
bool MotionPlanner::isSmooth(const Motion& motion, const Node& a, const Node& b) const {
  constexpr double kShort = 0.25;  // of a feature: the errors cannot rise and fall again within it
  double bow = 0.0;
  double correction = 0.0;
  for (int i = 0; i < machine_.jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double weight = machine_.isRotary(i) ? 100.0 : 1.0;
    correction = std::max({correction, weight * std::abs(b.corrected[k] - b.ideal[k]),
                           weight * std::abs(a.corrected[k] - a.ideal[k])});
    const double feature =
        machine_.isRotary(i) ? std::min(model_.featureLength(i), kRotaryFeature) : model_.featureLength(i);
    const double travel =
        isInPlane(motion, i) ? std::abs(motion.sweep) * radiusOf(motion) : std::abs(b.ideal[k] - a.ideal[k]);
    bow += travel / feature;
  }
  return bow < kShort && correction * bow * bow < 0.1 * options_.tolerance;
}

Result<bool> MotionPlanner::lineFits(const Motion& motion, const Node& a, const Node& b) {
  if (isSmooth(motion, a, b)) return true;
  const int inner = innerSamples(motion, a, b);
  const AxisValues from = valuesOf(machine_, a.corrected, motion.tool_centre_point);
  const AxisValues to = valuesOf(machine_, b.corrected, motion.tool_centre_point);
  for (int i = 1; i <= inner; ++i) {
    const double u = static_cast<double>(i) / (inner + 1);
    const Result<Node> node = solveAt(motion, a.fraction + u * (b.fraction - a.fraction));
    if (!node) return node.error();
    const Result<JointPositions> on_line = jointsOf(machine_, between(from, to, u), motion.tool_centre_point);
    if (!on_line) return on_line.error();
    double tilt = 0.0;
    const double off = distance(*on_line, node->corrected, tilt);
    if (off > options_.tolerance || tilt > options_.angle_tolerance) return false;
  }
  return true;
}

}  // namespace nineline::compensation
