#include "core/identification/rigid_fit.h"

#include <fmt/format.h>

#include <Eigen/Dense>

#include "core/kinematics/rotation.h"

namespace nineline::identification {

namespace {

Vector3d meanOf(std::span<const Vector3d> points) {
  Vector3d sum = Vector3d::Zero();
  for (const Vector3d& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

Result<void> checkTargets(std::span<const Vector3d> targets, std::span<const Vector3d> observed) {
  if (targets.size() != observed.size() || targets.size() < 3) {
    return badInput("rigid_fit.count",
                    fmt::format("A rigid motion needs three targets and where each was seen; there "
                                "are {} targets and {} observations.",
                                targets.size(), observed.size()));
  }
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (targets[i].allFinite() && observed[i].allFinite()) continue;
    return badInput("rigid_fit.number", fmt::format("Target {} has a coordinate that is no number.", i + 1));
  }
  return {};
}

/// True when the targets span less than a plane, so that a turn about their line moves none of them.
bool areInLine(std::span<const Vector3d> targets, const Vector3d& centre) {
  Matrix3d scatter = Matrix3d::Zero();
  for (const Vector3d& target : targets) scatter += (target - centre) * (target - centre).transpose();
  const Vector3d spread = Eigen::SelfAdjointEigenSolver<Matrix3d>(scatter).eigenvalues();
  return spread(1) <= 1e-12 * spread(2);
}

Matrix3d bestRotation(std::span<const Vector3d> targets, std::span<const Vector3d> observed,
                      const Vector3d& target_mean, const Vector3d& observed_mean) {
  Matrix3d H = Matrix3d::Zero();
  for (std::size_t i = 0; i < targets.size(); ++i) {
    H += (targets[i] - target_mean) * (observed[i] - observed_mean).transpose();
  }
  const Eigen::JacobiSVD<Matrix3d> svd(H, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double handedness = (svd.matrixV() * svd.matrixU().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  return svd.matrixV() * Vector3d(1.0, 1.0, handedness).asDiagonal() * svd.matrixU().transpose();
}

/// Standard uncertainties of d and of a further small turn w: residual = d + w × (R s).
SmallMotion uncertaintyOf(std::span<const Vector3d> targets, const Matrix3d& R, double squares) {
  Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
  for (const Vector3d& target : targets) {
    Eigen::Matrix<double, 3, 6> row;
    row << Matrix3d::Identity(), -kinematics::skew(R * target);
    normal += row.transpose() * row;
  }
  const double freedom = static_cast<double>(3 * targets.size()) - 6.0;
  const Eigen::Matrix<double, 6, 1> sigma =
      (normal.inverse().diagonal() * (squares / freedom)).cwiseMax(0.0).cwiseSqrt();
  return {sigma.head<3>(), sigma.tail<3>()};
}

}  // namespace

Result<RigidFit> fitRigidMotion(std::span<const Vector3d> targets, std::span<const Vector3d> observed) {
  if (const Result<void> checked = checkTargets(targets, observed); !checked) return checked.error();
  const Vector3d target_mean = meanOf(targets), observed_mean = meanOf(observed);
  if (areInLine(targets, target_mean)) {
    return noAnswer("rigid_fit.line", "The targets lie in one line; the rotation about it cannot be found.");
  }
  const Matrix3d R = bestRotation(targets, observed, target_mean, observed_mean);
  RigidFit result;
  result.motion = {observed_mean - R * target_mean, kinematics::logarithm(R)};
  double squares = 0.0;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Vector3d carried = R * (targets[i] - target_mean);
    result.residuals.push_back((observed[i] - observed_mean) - carried);
    squares += result.residuals.back().squaredNorm();
  }
  result.rms = std::sqrt(squares / static_cast<double>(3 * targets.size()));
  result.standard_uncertainty = uncertaintyOf(targets, R, squares);
  return result;
}

SmallMotion inTurningFrame(const SmallMotion& standing, const Vector3d& axis, double angle) {
  const Matrix3d R = kinematics::rotationAbout(axis, -angle);
  return {R * standing.translation, R * standing.rotation};
}

SmallMotion inStandingFrame(const SmallMotion& turning, const Vector3d& axis, double angle) {
  return inTurningFrame(turning, axis, -angle);
}

SmallMotion atReferencePoint(const SmallMotion& motion, const Vector3d& from, const Vector3d& to) {
  const Vector3d arm = to - from;
  return {motion.translation + kinematics::exponential(motion.rotation) * arm - arm, motion.rotation};
}

}  // namespace nineline::identification
