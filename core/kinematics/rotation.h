#pragma once

#include <Eigen/Core>

namespace nineline::kinematics {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// How a small rotation becomes a matrix. FirstOrder exists only to reproduce the literature
/// (theory.md, 1.3).
enum class RotationModel { Exact, FirstOrder };

/// [w]×: skew(w) * p = w × p.
[[nodiscard]] Matrix3d skew(const Vector3d& w);

/// exp([w]×), w a rotation vector in rad (theory.md, 0).
[[nodiscard]] Matrix3d exponential(const Vector3d& w);

/// The rotation vector of R in rad, angle < π; at π itself the axis sign is arbitrary.
[[nodiscard]] Vector3d logarithm(const Matrix3d& R);

/// Left Jacobian Jl(w): d exp([w]×) = [Jl(w) dw]× exp([w]×).
[[nodiscard]] Matrix3d leftJacobian(const Vector3d& w);

/// Elementary rotation by `angle` rad about the unit vector `axis`, exact.
[[nodiscard]] Matrix3d rotationAbout(const Vector3d& axis, double angle);

}  // namespace nineline::kinematics
