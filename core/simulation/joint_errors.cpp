#include "core/simulation/joint_errors.h"

#include <algorithm>
#include <cmath>

#include "core/simulation/deviation_statistics.h"

namespace nineline::simulation {

using kinematics::PoseTarget;

namespace {
constexpr unsigned kAllJoints = (1U << kMaxAxes) - 1U;
}

PoseTarget::Rotation solvableRotation(const Machine& machine, unsigned free) {
  int linear = 0;
  int rotary = 0;
  for (int i = 0; i < machine.jointCount(); ++i) {
    if ((free >> static_cast<unsigned>(i) & 1U) == 0) continue;
    ++(machine.isRotary(i) ? rotary : linear);
  }
  if (linear == 0) return PoseTarget::Rotation::Full;
  return rotary >= 2 && linear + rotary >= 5 ? PoseTarget::Rotation::Axis : PoseTarget::Rotation::None;
}

PoseTarget targetOf(const ToolPose& pose, PoseTarget::Rotation rotation) {
  return {pose.tip, pose.axis, pose.R_WP, rotation};
}

JointErrorSolver::JointErrorSolver(const Machine& machine, const JointPositions& q, const ToolPose& ideal,
                                   const kinematics::PoseJacobian& jacobian)
    : machine_(machine),
      q_(q),
      ideal_(ideal),
      rotation_(solvableRotation(machine, kAllJoints)),
      solver_(machine, jacobian, targetOf(ideal, rotation_), {}) {}

JointPositions JointErrorSolver::errorsOf(const ToolPose& actual) const {
  constexpr int kMostSteps = 8;
  constexpr double kSmallStep = 1e-11;
  const PoseTarget target = targetOf(actual, rotation_);
  JointPositions position = q_;
  ToolPose pose = ideal_;
  for (int iteration = 0; iteration < kMostSteps; ++iteration) {
    if (iteration > 0) pose = forward(machine_, position);
    const JointPositions step = solver_.step(residual(target, pose));
    double largest = 0.0;
    for (std::size_t k = 0; k < position.size(); ++k) {
      position[k] += step[k];
      largest = std::max(largest, std::abs(step[k]));
    }
    if (largest < kSmallStep) break;
  }
  JointPositions error{};
  for (std::size_t k = 0; k < error.size(); ++k) error[k] = position[k] - q_[k];
  return error;
}

JointPositions jointErrors(const Machine& machine, const JointPositions& q, const ToolPose& actual) {
  kinematics::PoseJacobian jacobian;
  const ToolPose ideal = forwardWithJacobian(machine, q, jacobian);
  return JointErrorSolver(machine, q, ideal, jacobian).errorsOf(actual);
}

Deviation deviationOf(const Machine& machine, const JointPositions& q, const ToolPose& ideal,
                      const ToolPose& actual) {
  Deviation deviation;
  deviation.tip = actual.tip - ideal.tip;
  deviation.rotation = kinematics::logarithm(actual.R_WP * ideal.R_WP.transpose());
  deviation.joints = jointErrors(machine, q, actual);
  return deviation;
}

}  // namespace nineline::simulation
