#include "core/kinematics/step_solver.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace nineline::kinematics {

namespace {

/// Pivots (of scaled columns) below this share of the largest send a matrix to the singular values.
constexpr double kSafePivot = 1e-3;

/// Scaled columns of the joints that move; the rows of the rotation are weighed.
using Tall = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, kMaxAxes>;
using Wide = Eigen::Matrix<double, Eigen::Dynamic, 6, 0, kMaxAxes, 6>;

template <int N>
bool invert(const Eigen::Matrix<double, N, N>& square, Eigen::Matrix<double, N, N>& inverse) {
  const Eigen::PartialPivLU<Eigen::Matrix<double, N, N>> lu(square);
  const auto pivots = lu.matrixLU().diagonal().cwiseAbs();
  if (!(pivots.minCoeff() > kSafePivot * pivots.maxCoeff())) return false;
  inverse = lu.inverse();
  return true;
}

bool invertTip(const Tall& A, Wide& inverse) {
  Eigen::Matrix3d result;
  if (!invert<3>(A.topRows<3>(), result)) return false;
  inverse.setZero(3, 6);
  inverse.leftCols<3>() = result;
  return true;
}

/// Five rows: the tip, and the turning about two directions square to the tool axis.
bool invertTipAndAxis(const Tall& A, const Vector3d& axis, Wide& inverse) {
  Eigen::Matrix<double, 5, 6> rows = Eigen::Matrix<double, 5, 6>::Zero();
  rows.topLeftCorner<3, 3>().setIdentity();
  rows.block<1, 3>(3, 3) = axis.unitOrthogonal().transpose();
  rows.block<1, 3>(4, 3) = axis.cross(axis.unitOrthogonal()).transpose();
  const Eigen::Matrix<double, 6, 5> tall = A;
  Eigen::Matrix<double, 5, 5> result;
  if (!invert<5>(rows * tall, result)) return false;
  inverse = result * rows;
  return true;
}

void invertBySingularValues(const Tall& A, double weakest, Wide& inverse) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(A, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Eigen::VectorXd& values = svd.singularValues();
  inverse.setZero(A.cols(), 6);
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (values[i] <= weakest * values[0]) break;
    inverse += svd.matrixV().col(i) * svd.matrixU().col(i).transpose() / values[i];
  }
}

}  // namespace

StepSolver::StepSolver(const Machine& machine, const PoseJacobian& jacobian, const PoseTarget& target,
                       const StepOptions& options) {
  const bool tip_only = target.rotation == PoseTarget::Rotation::None;
  const bool axis_only = target.rotation == PoseTarget::Rotation::Axis;
  Tall A(6, machine.jointCount());
  std::array<double, kMaxAxes> scale{};
  for (int i = 0; i < machine.jointCount(); ++i) {
    if ((options.free >> static_cast<unsigned>(i) & 1U) == 0) continue;
    const auto k = static_cast<std::size_t>(count_++);
    joints_[k] = i;
    scale[k] = machine.isRotary(i) ? 1.0 / options.rotary_length : 1.0;
    A.col(count_ - 1) = scale[k] * jacobian.col(i);
    A.col(count_ - 1).tail<3>() *= tip_only ? 0.0 : options.rotation_length;
  }
  if (count_ == 0) return;
  A.conservativeResize(6, count_);
  const bool direct = tip_only ? count_ == 3 && invertTip(A, inverse_)
                               : axis_only && count_ == 5 && invertTipAndAxis(A, target.axis, inverse_);
  if (!direct) {
    if (axis_only) A.bottomRows<3>() -= (target.axis * (target.axis.transpose() * A.bottomRows<3>())).eval();
    invertBySingularValues(A, options.weakest, inverse_);
  }
  inverse_.rightCols<3>() *= tip_only ? 0.0 : options.rotation_length;
  for (int c = 0; c < count_; ++c) {
    const auto k = static_cast<std::size_t>(c);
    inverse_.row(c) *= scale[k];
    if (machine.isRotary(joints_[k])) turn_gain_ = std::max(turn_gain_, inverse_.row(c).tail<3>().norm());
  }
}

JointPositions StepSolver::step(const PoseResidual& residual) const {
  JointPositions result{};
  for (int c = 0; c < count_; ++c)
    result[static_cast<std::size_t>(joints_[static_cast<std::size_t>(c)])] = inverse_.row(c).dot(residual);
  return result;
}

JointPositions leastSquaresStep(const Machine& machine, const PoseJacobian& jacobian,
                                const PoseResidual& residual, const PoseTarget& target,
                                const StepOptions& options) {
  return StepSolver(machine, jacobian, target, options).step(residual);
}

}  // namespace nineline::kinematics
