#include "core/kinematics/step_solver.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace nineline::kinematics {

namespace {

/// Columns (scaled) that span less than this share of a box of their lengths send a matrix to the singular
/// values.
constexpr double kSafePivot = 1e-3;

/// Scaled columns of the joints that move; the rows of the rotation are weighed.
using Tall = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, kMaxAxes>;
using Wide = Eigen::Matrix<double, Eigen::Dynamic, 6, 0, kMaxAxes, 6>;

/// The inverse of the matrix with these columns by cofactors; false where they are near one plane or one is
/// far shorter than another.
bool invertThree(const Vector3d& a, const Vector3d& b, const Vector3d& c, Matrix3d& inverse) {
  const Vector3d bc = b.cross(c);
  const double determinant = a.dot(bc);
  const Vector3d squares(a.squaredNorm(), b.squaredNorm(), c.squaredNorm());
  const double size = std::sqrt(squares[0] * squares[1] * squares[2]);
  if (!(squares.minCoeff() > kSafePivot * kSafePivot * squares.maxCoeff())) return false;
  if (!(std::abs(determinant) > kSafePivot * size)) return false;
  inverse.row(0) = bc / determinant;
  inverse.row(1) = c.cross(a) / determinant;
  inverse.row(2) = a.cross(b) / determinant;
  return true;
}

bool invertTip(const Tall& A, Wide& inverse) {
  Matrix3d result;
  if (!invertThree(A.col(0).head<3>(), A.col(1).head<3>(), A.col(2).head<3>(), result)) return false;
  inverse.setZero(3, 6);
  inverse.leftCols<3>() = result;
  return true;
}

/// Places of the columns that turn the tool and of those that do not; false where they are not two and three.
bool splitColumns(const Tall& A, std::array<int, 3>& linear, std::array<int, 2>& rotary) {
  std::size_t linears = 0;
  std::size_t rotaries = 0;
  for (int c = 0; c < 5; ++c) {
    const bool turns = !A.col(c).tail<3>().isZero(0.0);
    if ((turns ? rotaries : linears) == (turns ? rotary.size() : linear.size())) return false;
    (turns ? rotary[rotaries++] : linear[linears++]) = c;
  }
  return true;
}

/// Five joints that hold the tip and the tool axis. The two that turn are found first, from the turning about
/// two directions u, v square to the axis; the three others put the tip right.
bool invertTipAndAxis(const Tall& A, const Vector3d& axis, Wide& inverse) {
  std::array<int, 3> linear{};
  std::array<int, 2> rotary{};
  if (!splitColumns(A, linear, rotary)) return false;
  const Vector3d u = axis.unitOrthogonal();
  const Vector3d v = axis.cross(u);
  const Vector3d w0 = A.col(rotary[0]).tail<3>();
  const Vector3d w1 = A.col(rotary[1]).tail<3>();
  const double u0 = u.dot(w0), u1 = u.dot(w1), v0 = v.dot(w0), v1 = v.dot(w1);
  const double determinant = u0 * v1 - u1 * v0;
  const double largest = std::sqrt(std::max(u0 * u0 + v0 * v0, u1 * u1 + v1 * v1));
  if (!(largest > kSafePivot) || !(std::abs(determinant) > kSafePivot * largest)) return false;
  Matrix3d tip;
  if (!invertThree(A.col(linear[0]).head<3>(), A.col(linear[1]).head<3>(), A.col(linear[2]).head<3>(), tip))
    return false;
  const Vector3d turn0 = (v1 * u - u1 * v) / determinant;  // of the rotary joints for a rotation of the tool
  const Vector3d turn1 = (u0 * v - v0 * u) / determinant;
  const Vector3d lever0 = -(tip * A.col(rotary[0]).head<3>());
  const Vector3d lever1 = -(tip * A.col(rotary[1]).head<3>());
  inverse.setZero(5, 6);
  inverse.row(rotary[0]).tail<3>() = turn0;
  inverse.row(rotary[1]).tail<3>() = turn1;
  for (int i = 0; i < 3; ++i) {
    const int row = linear[static_cast<std::size_t>(i)];
    inverse.row(row).head<3>() = tip.row(i);
    inverse.row(row).tail<3>() = lever0[i] * turn0 + lever1[i] * turn1;
  }
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
  for (int c = 0; c < count_; ++c) {
    double sum = 0.0;
    for (int k = 0; k < 6; ++k) sum += inverse_(c, k) * residual[k];
    result[static_cast<std::size_t>(joints_[static_cast<std::size_t>(c)])] = sum;
  }
  return result;
}

JointPositions leastSquaresStep(const Machine& machine, const PoseJacobian& jacobian,
                                const PoseResidual& residual, const PoseTarget& target,
                                const StepOptions& options) {
  return StepSolver(machine, jacobian, target, options).step(residual);
}

}  // namespace nineline::kinematics
