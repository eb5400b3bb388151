#include "core/simulation/command_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/units.h"
#include "core/kinematics/inverse.h"

namespace nineline::simulation {

namespace {

constexpr double kStandstill = 1e-12;             // mm or rad: smaller differences are no motion
constexpr double kMostSamples = 100000.0;         // of one motion
constexpr double kAssumedRapid = 10000.0 / 60.0;  // mm/s, where the machine file states none
constexpr double kAssumedTurn = kTurn;            // rad/s

unsigned linearJoints(const Machine& machine) {
  unsigned mask = 0;
  for (int i = 0; i < machine.jointCount(); ++i) {
    if (!machine.isRotary(i)) mask |= 1U << static_cast<unsigned>(i);
  }
  return mask;
}

/// Component 0 1 2 of the tip in W that the axis X Y Z states; −1 for any other axis.
int tipComponent(const AxisId& axis) {
  return axis.digit == 0 && axis.letter >= 'X' && axis.letter <= 'Z' ? axis.letter - 'X' : -1;
}

/// No joint carries the tip further from its axis than all lengths of the chains and linear positions
/// together.
double reachAt(const Machine& machine, const JointPositions& q) {
  double reach = machine.toolTip().lpNorm<1>();
  for (int i = 0; i < machine.jointCount(); ++i) {
    reach += machine.joint(i).offset.lpNorm<1>();
    if (!machine.isRotary(i)) reach += std::abs(q[static_cast<std::size_t>(i)]);
  }
  return reach;
}

/// Samples that the turning of rotary joints asks for: a chord over dφ at radius r leaves the arc by r dφ²/8.
/// Where the longest radius that there could be asks for one sample at most, that is the answer.
double rotarySamples(const Machine& machine, const JointPositions& start, const JointPositions& end,
                     double chord) {
  double turned = 0.0;
  for (int i = 0; i < machine.jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (machine.isRotary(i)) turned += std::abs(end[k] - start[k]);
  }
  if (turned == 0.0) return 0.0;
  const double reach = std::max(reachAt(machine, start), reachAt(machine, end));
  const double most = turned * std::sqrt(reach / (8.0 * chord));
  if (most <= 1.0) return most;
  kinematics::PoseJacobian at_start;
  kinematics::PoseJacobian at_end;
  static_cast<void>(forwardWithJacobian(machine, start, at_start));
  static_cast<void>(forwardWithJacobian(machine, end, at_end));
  double samples = 0.0;
  for (int i = 0; i < machine.jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double turn = std::abs(end[k] - start[k]);
    if (!machine.isRotary(i) || turn < kStandstill) continue;
    const double radius = std::max(at_start.col(i).head<3>().norm(), at_end.col(i).head<3>().norm());
    samples += turn * std::sqrt(radius / (8.0 * chord));
  }
  return samples;
}

double linearLength(const Machine& machine, const nc::Motion& motion) {
  double squares = 0.0;
  for (int i = 0; i < machine.jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const bool in_arc = motion.kind == nc::MotionKind::Arc && (i == motion.plane[0] || i == motion.plane[1]);
    if (machine.isRotary(i) || in_arc) continue;
    squares += (motion.end[k] - motion.start[k]) * (motion.end[k] - motion.start[k]);
  }
  if (motion.kind == nc::MotionKind::Arc) {
    const double radius =
        std::hypot(motion.start[static_cast<std::size_t>(motion.plane[0])] - motion.centre[0],
                   motion.start[static_cast<std::size_t>(motion.plane[1])] - motion.centre[1]);
    squares += radius * motion.sweep * radius * motion.sweep;
  }
  return std::sqrt(squares);
}

double rotaryLength(const Machine& machine, const nc::Motion& motion) {
  double squares = 0.0;
  for (int i = 0; i < machine.jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (machine.isRotary(i)) squares += (motion.end[k] - motion.start[k]) * (motion.end[k] - motion.start[k]);
  }
  return std::sqrt(squares);
}

double rapidDuration(const Machine& machine, const nc::Motion& motion) {
  double longest = 0.0;
  for (int i = 0; i < machine.jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double speed =
        machine.joint(i).rapid_speed.value_or(machine.isRotary(i) ? kAssumedTurn : kAssumedRapid);
    longest = std::max(longest, std::abs(motion.end[k] - motion.start[k]) / speed);
  }
  return longest;
}

}  // namespace

Result<JointPositions> jointsOf(const Machine& machine, const nc::AxisValues& values,
                                bool tool_centre_point) {
  if (!tool_centre_point) return values;
  kinematics::PoseTarget target;
  JointPositions q = values;
  for (int i = 0; i < machine.jointCount(); ++i) {
    const int component = machine.isRotary(i) ? -1 : tipComponent(machine.joint(i).axis);
    if (component >= 0) target.tip[component] = values[static_cast<std::size_t>(i)];
  }
  kinematics::StepOptions options;
  options.free = linearJoints(machine);
  kinematics::PoseJacobian jacobian;
  for (int iteration = 0; iteration < 3;
       ++iteration) {  // the tip is affine in the linear joints: the first step hits
    const kinematics::ToolPose pose = forwardWithJacobian(machine, q, jacobian);
    const JointPositions step = leastSquaresStep(machine, jacobian, residual(target, pose), target, options);
    for (std::size_t k = 0; k < q.size(); ++k) q[k] += step[k];
  }
  const double left = (forward(machine, q).tip - target.tip).norm();
  if (left > kNanometre) {
    return noAnswer(
        "simulation.tcp",
        fmt::format("With tool-centre-point control the linear axes cannot hold the tip: {:.6f} mm are left.",
                    left));
  }
  return q;
}

nc::AxisValues valuesOf(const Machine& machine, const JointPositions& q, bool tool_centre_point) {
  if (!tool_centre_point) return q;
  const Eigen::Vector3d tip = forward(machine, q).tip;
  nc::AxisValues values = q;
  for (int i = 0; i < machine.jointCount(); ++i) {
    const int component = machine.isRotary(i) ? -1 : tipComponent(machine.joint(i).axis);
    if (component >= 0) values[static_cast<std::size_t>(i)] = tip[component];
  }
  return values;
}

FeedMeaning feedMeaningOf(std::optional<nc::Dialect> stated) {
  return stated == nc::Dialect::Fanuc ? FeedMeaning::VectorSum : FeedMeaning::LinearPath;
}

double durationOf(const Machine& machine, const nc::Motion& motion, FeedMeaning meaning) {
  if (motion.kind == nc::MotionKind::Rapid) return rapidDuration(machine, motion);
  if (motion.feed <= 0.0) return 0.0;
  if (motion.feed_mode == nc::FeedMode::InverseTime) return 1.0 / motion.feed;
  double speed = motion.feed;
  if (motion.feed_mode == nc::FeedMode::PerRevolution) speed *= motion.spindle_speed / kTurn;
  if (speed <= 0.0) return 0.0;
  const double linear = linearLength(machine, motion);
  const double turned = rotaryLength(machine, motion);
  if (linear <= kStandstill) return turned / speed;
  const bool together = meaning == FeedMeaning::VectorSum && motion.kind == nc::MotionKind::Linear;
  return (together ? std::hypot(linear, degFromRad(turned) * motion.feed_unit) : linear) / speed;
}

void reversalFractions(const nc::Motion& motion, std::vector<double>& fractions) {
  fractions.clear();
  if (motion.kind != nc::MotionKind::Arc || motion.sweep == 0.0) return;
  const double from = std::atan2(motion.start[static_cast<std::size_t>(motion.plane[1])] - motion.centre[1],
                                 motion.start[static_cast<std::size_t>(motion.plane[0])] - motion.centre[0]);
  const double quarter = 0.5 * kPi;
  const double low = std::min(from, from + motion.sweep);
  const double high = std::max(from, from + motion.sweep);
  for (double k = std::ceil(low / quarter + 1e-9); k * quarter < high - 1e-9; k += 1.0) {
    fractions.push_back((k * quarter - from) / motion.sweep);
  }
  std::sort(fractions.begin(), fractions.end());
}

void sampleFractions(const ErrorModel& model, const nc::Motion& motion, const JointPositions& start,
                     const JointPositions& end, const std::array<std::int8_t, kMaxAxes>& approach,
                     double chord, std::vector<double>& fractions) {
  const Machine& machine = model.machine();
  double samples = rotarySamples(machine, start, end, chord);
  reversalFractions(motion, fractions);
  double arc_radius = 0.0;
  if (motion.kind == nc::MotionKind::Arc) {
    arc_radius = std::hypot(motion.start[static_cast<std::size_t>(motion.plane[0])] - motion.centre[0],
                            motion.start[static_cast<std::size_t>(motion.plane[1])] - motion.centre[1]);
    samples = std::max(samples, std::abs(motion.sweep) * std::sqrt(arc_radius / (8.0 * chord)));
  }
  for (int i = 0; i < machine.jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const bool in_arc = motion.kind == nc::MotionKind::Arc && (i == motion.plane[0] || i == motion.plane[1]);
    const double travel = in_arc ? std::abs(motion.sweep) * arc_radius : std::abs(end[k] - start[k]);
    if (travel < kStandstill) continue;
    samples = std::max(samples, 2.0 * travel / model.featureLength(i));
    const auto sense = static_cast<std::int8_t>(end[k] > start[k] ? 1 : -1);
    const double crossing = model.play(i) / travel;
    if (approach[k] == -sense && crossing > 0.0 && crossing < 1.0 && !in_arc) fractions.push_back(crossing);
  }
  const double count = std::min(std::max(std::ceil(samples), 1.0), kMostSamples);
  for (double k = 1.0; k <= count; k += 1.0) fractions.push_back(k / count);
  std::sort(fractions.begin(), fractions.end());
  fractions.erase(
      std::unique(fractions.begin(), fractions.end(), [](double a, double b) { return b - a < 1e-9; }),
      fractions.end());
  fractions.back() = 1.0;
}

namespace {

/// A program begins in equilibrium: no reversal before it counts.
constexpr JointPositions kNeverReversed = [] {
  JointPositions all{};
  all.fill(std::numeric_limits<double>::infinity());
  return all;
}();

}  // namespace

PathState::PathState(const ErrorModel& model, MachineState conditions, const JointPositions& start)
    : model_(&model), state_(std::move(conditions)) {
  state_.q = start;
  start_time_ = state_.time.value_or(0.0);
  state_.time = start_time_;
  before_ = state_;
  memory_ = model.startMemory(state_);
}

void PathState::moveTo(const JointPositions& q, double duration) {
  before_.q = state_.q;
  before_.approach = state_.approach;
  before_.time = state_.time;
  JointPositions velocity{};
  JointPositions since = state_.since_reversal.value_or(kNeverReversed);
  for (int i = 0; i < model_->machine().jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double travel = q[k] - state_.q[k];
    velocity[k] = duration > 0.0 ? travel / duration : 0.0;
    if (std::abs(travel) <= kStandstill) continue;
    const auto sense = static_cast<std::int8_t>(travel > 0.0 ? 1 : -1);
    const bool reverses = sense == -state_.approach[k];
    since[k] = reverses ? std::abs(travel) : since[k] + std::abs(travel);
    state_.approach[k] = sense;
  }
  state_.q = q;
  state_.since_reversal = since;
  state_.velocity = duration > 0.0 ? std::optional(velocity) : std::nullopt;
  state_.time = *state_.time + duration;
  if (!memory_.empty()) model_->advance(before_, state_, memory_);
}

}  // namespace nineline::simulation
