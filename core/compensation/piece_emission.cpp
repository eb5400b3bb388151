// From where the joints have to stand to what is commanded: play is crossed, words are rounded.
#include <algorithm>
#include <cmath>

#include "core/compensation/motion_planner.h"
#include "core/simulation/command_path.h"

namespace nineline::compensation {

using nc::AxisValues;
using nc::Motion;
using nc::MotionKind;
using simulation::jointsOf;
using simulation::valuesOf;

namespace {

constexpr double kStandstill = 1e-12;
constexpr double kSmallShift = 0.05;  // of the tolerance

}  // namespace

/// How far a joint may be from its place before it turns back for it: what the tolerance allows at its lever.
void MotionPlanner::setHolding(const Motion& motion) {
  kinematics::PoseJacobian jacobian;
  const Result<JointPositions> at = jointsOf(machine_, motion.end, motion.tool_centre_point);
  static_cast<void>(forwardWithJacobian(machine_, at ? *at : motion.end, jacobian));
  for (int i = 0; i < machine_.jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    holding_[k] = options_.tolerance;
    if (!machine_.isRotary(i)) continue;
    const double lever = std::max(1.0, jacobian.col(i).head<3>().norm());
    holding_[k] = std::min(options_.angle_tolerance, options_.tolerance / lever);
  }
}

/// Sets `stands_` and `held_` to where the corrected program is before the motion.
Result<void> MotionPlanner::startFrom(const Motion& motion, const AxisValues& at) {
  if (has_play_) setHolding(motion);
  const Result<JointPositions> ideal = jointsOf(machine_, motion.start, motion.tool_centre_point);
  if (!ideal) return ideal.error();
  if (last_ && *last_ == *ideal) return {};
  const Result<JointPositions> q = jointsOf(machine_, at, motion.tool_centre_point);
  if (!q) return q.error();
  held_ = stands_ = *q;
  followed_.fill(0.0);
  for (std::size_t k = 0; k < stands_.size(); ++k) {
    if (isFree(k)) stands_[k] -= offsetOf(k);
  }
  return {};
}

bool MotionPlanner::holds(std::size_t joint, double travel) const {
  return now_[joint] * travel <= 0.0 && std::abs(travel) <= std::max(holding_[joint], kStandstill);
}

bool MotionPlanner::turnsBack(std::size_t joint, double travel) const {
  return play_[joint] != 0.0 && isFree(joint) && now_[joint] * travel < 0.0 && !holds(joint, travel);
}

/// Rotary words are coarse at a long lever: the linear joints take up what their rounding does to the tip.
void MotionPlanner::followRotaryWords(const Node& b, JointPositions& places) {
  followed_.fill(0.0);
  if (rotary_step_ <= 0.0) return;
  JointPositions rounding{};
  unsigned linear = 0;
  bool any = false;
  for (int i = 0; i < machine_.jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (!isFree(k)) continue;
    if (!machine_.isRotary(i)) {
      linear |= 1U << static_cast<unsigned>(i);
      continue;
    }
    const double q = places[k] + offsetOf(k) - scope_.grid[k];
    rounding[k] = std::round(q / rotary_step_) * rotary_step_ - q;
    any = true;
  }
  if (!any || linear == 0) return;
  kinematics::PoseJacobian jacobian;
  static_cast<void>(forwardWithJacobian(machine_, b.ideal, jacobian));
  kinematics::PoseResidual shift = kinematics::PoseResidual::Zero();
  for (int i = 0; i < machine_.jointCount(); ++i)
    shift.head<3>() -= rounding[static_cast<std::size_t>(i)] * jacobian.col(i).head<3>();
  if (shift.norm() < kSmallShift * options_.tolerance) return;
  kinematics::StepOptions step;
  step.free = linear;
  const JointPositions by = leastSquaresStep(machine_, jacobian, shift, kinematics::PoseTarget{}, step);
  for (std::size_t k = 0; k < by.size(); ++k) {  // no joint turns back through its play for a rounding
    const double travel = places[k] - stands_[k];
    if (turnsBack(k, travel + by[k]) && !turnsBack(k, travel)) return;
  }
  for (std::size_t k = 0; k < by.size(); ++k) places[k] += by[k];
  followed_ = by;
}

/// Commands that bring the joints to their places, and those that cross the play of joints that turn back;
/// true where they have to cross it first, because others move meanwhile.
bool MotionPlanner::command(const JointPositions& places, JointPositions& q, JointPositions& crossing) {
  int turned = 0;
  bool others = false;
  for (std::size_t k = 0; k < q.size(); ++k) {
    const double travel = places[k] - stands_[k];
    q[k] = places[k];
    if (play_[k] == 0.0 || !isFree(k)) {
      const bool rotary = machine_.isRotary(static_cast<int>(k));
      others = others || std::abs(travel) > (rotary ? options_.angle_tolerance : options_.tolerance);
      stands_[k] = places[k];
      continue;
    }
    if (holds(k, travel)) {
      q[k] = held_[k];
      continue;
    }
    const auto sense = static_cast<std::int8_t>(travel > 0.0 ? 1 : -1);
    if (now_[k] != 0 && sense != now_[k]) {
      crossing[k] += sense * play_[k];
      ++turned;
    } else {
      others = true;
    }
    now_[k] = sense;
    q[k] += offsetOf(k);
    stands_[k] = places[k];
  }
  return turned > 1 || (turned == 1 && others);
}

/// A whole turn ends where it starts, whatever was rounded there.
void MotionPlanner::closeTurn(const Motion& motion, const Piece& piece, const JointPositions& from,
                              JointPositions& q) {
  const AxisValues start = positionAt(motion, machine_.jointCount(), piece.from);
  const AxisValues end = positionAt(motion, machine_.jointCount(), piece.to);
  for (const int axis : motion.plane) {
    const auto k = static_cast<std::size_t>(axis);
    q[k] = from[k] + end[k] - start[k];
    stands_[k] = q[k] - (isFree(k) ? offsetOf(k) : 0.0);
  }
}

void MotionPlanner::emit(const Motion& motion, const Node& b, Piece piece, std::vector<Piece>& pieces) {
  JointPositions places = b.corrected;
  followRotaryWords(b, places);
  JointPositions q{};
  JointPositions crossing = held_;
  const bool crosses = command(places, q, crossing) && motion.kind != MotionKind::Rapid;
  if (crosses && !scope_.may_split) exceeded_ = true;
  if (crosses && scope_.may_split) {
    Piece take_up;
    take_up.end = valuesOf(machine_, crossing, motion.tool_centre_point);
    take_up.from = take_up.to = piece.from;
    take_up.take_up = true;
    pieces.push_back(take_up);
  }
  if (piece.closes && !motion.tool_centre_point) closeTurn(motion, piece, crossing, q);
  held_ = q;
  const AxisValues fitted = piece.end;
  piece.end = valuesOf(machine_, q, motion.tool_centre_point);
  if (piece.arc) {  // the circle moves with the offset of the play
    for (std::size_t side = 0; side < 2; ++side) {
      const auto k = static_cast<std::size_t>(motion.plane[side]);
      piece.centre[side] += piece.end[k] - fitted[k];
    }
  }
  pieces.push_back(piece);
}

}  // namespace nineline::compensation
