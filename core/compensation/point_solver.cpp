#include "core/compensation/point_solver.h"

#include <fmt/format.h>

#include <cmath>

#include "core/simulation/joint_errors.h"

namespace nineline::compensation {

using kinematics::Machine;
using kinematics::PoseJacobian;
using kinematics::PoseResidual;
using kinematics::PoseTarget;

namespace {

constexpr int kMostIterations = 12;
constexpr int kExactFrom = 5;
constexpr double kSmallStep = 1e-8;   // mm
constexpr double kSmallTurn = 1e-10;  // rad
constexpr double kLargestStep = 5.0;  // mm, theory.md 1.6
constexpr double kLargestTurn = 0.1;  // rad

/// Near a singular pose a rotary joint would have to turn this much more than the tool tilts: there the tool
/// keeps its tilt, a few arc seconds, and the tip alone is corrected.
constexpr double kMostTurnGain = 20.0;

unsigned linearJoints(const Machine& machine, unsigned of) {
  for (int i = 0; i < machine.jointCount(); ++i) {
    if (machine.isRotary(i)) of &= ~(1U << static_cast<unsigned>(i));
  }
  return of;
}

struct StepSize {
  double linear = 0.0;
  double rotary = 0.0;
};

StepSize sizeOf(const Machine& machine, const JointPositions& step) {
  StepSize size;
  for (int i = 0; i < machine.jointCount(); ++i) {
    double& largest = machine.isRotary(i) ? size.rotary : size.linear;
    largest = std::max(largest, std::abs(step[static_cast<std::size_t>(i)]));
  }
  return size;
}

}  // namespace

bool hasWorkSpindle(const Machine& machine) {
  return machine.workpieceJointCount() > 0 && machine.isRotary(machine.workpieceJointCount() - 1);
}

PointSolver::PointSolver(const ErrorModel& model, const CompensationOptions& options)
    : model_(model), mode_(options.mode) {}

unsigned PointSolver::freeJoints(unsigned positioned) const {
  const Machine& machine = model_.machine();
  unsigned linear = 0;
  int linear_count = 0;
  for (int i = 0; i < machine.jointCount(); ++i) {
    const unsigned bit = 1U << static_cast<unsigned>(i);
    if ((positioned & bit) == 0 || machine.isRotary(i)) continue;
    linear |= bit;
    ++linear_count;
  }
  const bool linear_only = mode_ == Mode::Thread || (mode_ == Mode::TipOnly && linear_count >= 3);
  return linear_only ? linear : positioned;
}

ToolPose PointSolver::actualPose(const JointPositions& q, const std::array<std::int8_t, kMaxAxes>& approach) {
  state_.q = q;
  state_.approach = approach;
  return model_.actualPose(state_);
}

JointPositions PointSolver::threadStep(const PoseJacobian& jacobian, const PoseResidual& left,
                                       const PoseTarget& target, const Request& request) const {
  const Machine& machine = model_.machine();
  // The work spindle's axis passes through the origin of W; only the radius and the lead of the groove count
  // (theory.md, 1.7, eq. 6).
  const Eigen::Vector3d axis = machine.joint(machine.workpieceJointCount() - 1).direction;
  const Eigen::Vector3d across = target.tip - axis * axis.dot(target.tip);
  const double radius = across.norm();
  Eigen::Matrix<double, 2, 3> rows;
  const Eigen::Vector3d radial = radius > 0.0 ? Eigen::Vector3d(across / radius) : axis.unitOrthogonal();
  rows.row(0) = radial.transpose();
  rows.row(1) =
      (axis - (request.advance && radius > 0.0 ? *request.advance / radius : 0.0) * axis.cross(radial))
          .transpose();
  // The shortest motion of the free joints that removes both: Aᵀ (A Aᵀ)⁻¹ b.
  Eigen::Matrix<double, 2, Eigen::Dynamic, 0, 2, kMaxAxes> A(2, machine.jointCount());
  for (int i = 0; i < machine.jointCount(); ++i) {
    const bool free = (request.free >> static_cast<unsigned>(i) & 1U) != 0;
    A.col(i) = free ? Eigen::Vector2d(rows * jacobian.col(i).head<3>()) : Eigen::Vector2d::Zero();
  }
  const Eigen::Vector3d actual = target.tip - left.head<3>();
  const Eigen::Vector3d actual_across = actual - axis * axis.dot(actual);
  const double turn = std::atan2(axis.dot(actual_across.cross(across)), actual_across.dot(across));
  const Eigen::Vector2d b(radius - actual_across.norm(),
                          axis.dot(left.head<3>()) - request.advance.value_or(0.0) * turn);
  const double n00 = A.row(0).squaredNorm();
  const double n01 = A.row(0).dot(A.row(1));
  const double n11 = A.row(1).squaredNorm();
  const double determinant = n00 * n11 - n01 * n01;
  if (!(determinant > 1e-8 * (n00 + n11) * (n00 + n11))) return {};
  const Eigen::Vector2d y((n11 * b[0] - n01 * b[1]) / determinant, (n00 * b[1] - n01 * b[0]) / determinant);
  JointPositions result{};
  for (int i = 0; i < machine.jointCount(); ++i) result[static_cast<std::size_t>(i)] = A.col(i).dot(y);
  return result;
}

Result<JointPositions> PointSolver::solve(const Request& request, const JointPositions& guess) {
  const Machine& machine = model_.machine();
  PoseJacobian jacobian;
  const ToolPose wanted = forwardWithJacobian(machine, request.ideal, jacobian);
  PoseTarget::Rotation rotation = simulation::solvableRotation(machine, request.free);
  if (mode_ != Mode::Auto && rotation == PoseTarget::Rotation::Axis) rotation = PoseTarget::Rotation::None;
  PoseTarget target = simulation::targetOf(wanted, rotation);
  kinematics::StepOptions step_options;
  step_options.free = request.free;
  std::optional<kinematics::StepSolver> solver;
  if (mode_ != Mode::Thread) solver.emplace(machine, jacobian, target, step_options);
  if (solver && rotation == PoseTarget::Rotation::Axis && solver->turnGain() > kMostTurnGain) {
    target.rotation = PoseTarget::Rotation::None;
    step_options.free = linearJoints(machine, request.free);
    solver.emplace(machine, jacobian, target, step_options);
  }
  JointPositions q = guess;
  for (std::size_t k = 0; k < q.size(); ++k) {  // tip alone: rotary joints that are free stay as programmed
    if (((request.free & ~step_options.free) >> k & 1U) != 0) q[k] = request.ideal[k];
  }
  PoseResidual left = PoseResidual::Zero();
  for (int iteration = 0; iteration < kMostIterations; ++iteration) {
    // The ideal Jacobian differs from the actual one by the slopes of the errors, 1e-4 to 1e-2: each step
    // gains two to four digits, and the last one leaves less than 1e-10 mm. Should that be too slow, the
    // exact one takes over.
    left = residual(target, actualPose(q, request.approach));
    if (iteration == kExactFrom) {
      static_cast<void>(model_.actualPoseWithJacobian(state_, {}, jacobian));
      if (solver) solver.emplace(machine, jacobian, target, step_options);
    }
    const JointPositions dq = solver ? solver->step(left) : threadStep(jacobian, left, target, request);
    const StepSize size = sizeOf(machine, dq);
    if (!(size.linear <= kLargestStep) || !(size.rotary <= kLargestTurn)) {
      return noAnswer(
          "compensation.step",
          fmt::format(
              "No command puts the tool on the ideal point: a step of {:.3g} mm and {:.3g} rad would be "
              "needed. Is the tool near an axis about which it should turn?",
              size.linear, size.rotary));
    }
    for (std::size_t k = 0; k < q.size(); ++k) q[k] += dq[k];
    if (size.linear <= kSmallStep && size.rotary <= kSmallTurn) return q;
  }
  return noAnswer(
      "compensation.convergence",
      fmt::format("The correction does not converge: {:.3g} mm and {:.3g} rad are left after {} steps.",
                  left.head<3>().norm(), left.tail<3>().norm(), kMostIterations));
}

}  // namespace nineline::compensation
