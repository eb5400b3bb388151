#include "core/kinematics/inverse.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace nineline::kinematics {

namespace {

constexpr double kLargestTurn = 0.3;  // rad per step, theory.md 4.3
constexpr double kWeakest = 1e-11;    // weak directions are walked: the cap keeps their steps tame (4.6)

/// Rotation vector that turns the unit vector `from` into `to`.
Vector3d turnBetween(const Vector3d& from, const Vector3d& to) {
  const Vector3d cross = from.cross(to);
  const double cosine = from.dot(to);
  const double squared = cross.squaredNorm();
  // asin(s)/s = 1 + s²/6 + 3 s⁴/40 + 5 s⁶/112: exact to a double's last digit below a hundredth of a rad.
  if (squared < 1e-4 && cosine > 0.0)
    return cross * (1.0 + squared * (1.0 / 6.0 + squared * (3.0 / 40.0 + squared * (5.0 / 112.0))));
  const double sine = std::sqrt(squared);
  if (sine > 1e-300) return cross * (std::atan2(sine, cosine) / sine);
  return kPi * from.unitOrthogonal();
}

struct Attempt {
  JointPositions q{};
  double tip_error = 0.0;
  double turn_error = 0.0;
  bool converged = false;
};

double weigh(const PoseResidual& r) { return std::hypot(r.head<3>().norm(), 100.0 * r.tail<3>().norm()); }

/// Shortens a step so that no rotary joint turns by more than kLargestTurn.
void capTurns(const Machine& machine, JointPositions& step) {
  double factor = 1.0;
  for (int i = 0; i < machine.jointCount(); ++i) {
    const double turn = std::abs(step[static_cast<std::size_t>(i)]);
    if (machine.isRotary(i) && turn * factor > kLargestTurn) factor = kLargestTurn / turn;
  }
  for (double& value : step) value *= factor;
}

Attempt solveFrom(const Machine& machine, const PoseTarget& target, const JointPositions& start,
                  const InverseOptions& options) {
  Attempt attempt;
  attempt.q = start;
  PoseJacobian jacobian;
  ToolPose pose = forwardWithJacobian(machine, attempt.q, jacobian);
  PoseResidual r = residual(target, pose);
  StepOptions step_options;
  step_options.weakest = kWeakest;
  for (int iteration = 0; iteration < options.most_iterations; ++iteration) {
    attempt.tip_error = r.head<3>().norm();
    attempt.turn_error = r.tail<3>().norm();
    attempt.converged =
        attempt.tip_error <= options.position_tolerance && attempt.turn_error <= options.rotation_tolerance;
    if (attempt.converged) return attempt;
    JointPositions step = leastSquaresStep(machine, jacobian, r, target, step_options);
    capTurns(machine, step);
    double fraction = 1.0;
    const double before = weigh(r);
    const JointPositions q_before = attempt.q;
    for (int halving = 0; halving < 8; ++halving, fraction *= 0.5) {
      for (std::size_t k = 0; k < attempt.q.size(); ++k) attempt.q[k] = q_before[k] + fraction * step[k];
      pose = forwardWithJacobian(machine, attempt.q, jacobian);
      r = residual(target, pose);
      if (weigh(r) < before || before < 1e-6) break;
    }
  }
  attempt.tip_error = r.head<3>().norm();
  attempt.turn_error = r.tail<3>().norm();
  attempt.converged =
      attempt.tip_error <= options.position_tolerance && attempt.turn_error <= options.rotation_tolerance;
  return attempt;
}

/// Whole turns that bring rotary joints next to the start, while they stay inside the travel.
void unwind(const Machine& machine, const JointPositions& start, JointPositions& q) {
  for (int i = 0; i < machine.jointCount(); ++i) {
    if (!machine.isRotary(i)) continue;
    const auto k = static_cast<std::size_t>(i);
    const double near = q[k] - kTurn * std::rint((q[k] - start[k]) / kTurn);
    const std::optional<Travel>& travel = machine.joint(i).travel;
    const auto inside = [&](double value) {
      return !travel || (value >= travel->low - 1e-9 && value <= travel->high + 1e-9);
    };
    q[k] = near;
    if (machine.joint(i).continuous || inside(near)) continue;
    const double other = near > travel->high ? near - kTurn : near + kTurn;
    if (inside(other)) q[k] = other;
  }
}

/// A start inside the travel from a low-discrepancy sequence, so that the search is the same every time.
JointPositions startNumber(const Machine& machine, const JointPositions& first, int number) {
  static constexpr std::array<double, kMaxAxes> kSteps = {0.6180339887, 0.7548776662, 0.5698402910,
                                                          0.8191725134, 0.6710436067, 0.5497004779,
                                                          0.8566748838, 0.7338918566, 0.6287067210};
  JointPositions start = first;
  for (int i = 0; i < machine.jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (!machine.isRotary(i)) continue;
    const Travel range = machine.joint(i).travel && !machine.joint(i).continuous ? *machine.joint(i).travel
                                                                                 : Travel{-kPi, kPi};
    const double u = std::fmod(0.5 + kSteps[k] * number, 1.0);
    start[k] = range.low + u * (range.high - range.low);
  }
  return start;
}

}  // namespace

PoseResidual residual(const PoseTarget& target, const ToolPose& pose) {
  PoseResidual r = PoseResidual::Zero();
  r.head<3>() = target.tip - pose.tip;
  if (target.rotation == PoseTarget::Rotation::Axis) r.tail<3>() = turnBetween(pose.axis, target.axis);
  if (target.rotation == PoseTarget::Rotation::Full)
    r.tail<3>() = logarithm(target.R_WP * pose.R_WP.transpose());
  return r;
}

Result<JointPositions> inverse(const Machine& machine, const PoseTarget& target, const JointPositions& start,
                               const InverseOptions& options) {
  Attempt best;
  best.tip_error = std::numeric_limits<double>::infinity();
  std::optional<JointPositions> outside;
  for (int number = 0; number <= options.most_starts; ++number) {
    Attempt attempt =
        solveFrom(machine, target, number == 0 ? start : startNumber(machine, start, number), options);
    if (attempt.converged) {
      unwind(machine, start, attempt.q);
      if (machine.firstOutsideTravel(attempt.q) < 0) return attempt.q;
      if (!outside) outside = attempt.q;
    } else if (attempt.tip_error < best.tip_error) {
      best = attempt;
    }
  }
  if (outside) {
    const int joint = machine.firstOutsideTravel(*outside);
    return noAnswer("kinematics.travel",
                    fmt::format("Axis {} would have to leave its travel.", machine.joint(joint).axis.text()));
  }
  return noAnswer("kinematics.inverse",
                  fmt::format("No joint positions reach the pose: {:.3g} mm and {:.3g} rad are left.",
                              best.tip_error, best.turn_error));
}

Result<JointPositions> inverse(const Machine& machine, const Eigen::Isometry3d& T_WP) {
  PoseTarget target;
  target.tip = T_WP.translation();
  target.R_WP = T_WP.linear();
  target.rotation = PoseTarget::Rotation::Full;
  JointPositions start{};
  for (int i = 0; i < machine.jointCount(); ++i) {
    const std::optional<Travel>& travel = machine.joint(i).travel;
    if (travel) start[static_cast<std::size_t>(i)] = 0.5 * (travel->low + travel->high);
  }
  return inverse(machine, target, start);
}

}  // namespace nineline::kinematics
