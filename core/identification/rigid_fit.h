#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/kinematics/chain.h"

namespace nineline::identification {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using kinematics::SmallMotion;

/// The rigid motion s → d + R s that carries targets nearest to where they were observed.
struct RigidFit {
  SmallMotion motion;                ///< d in mm and the rotation vector of R in rad; exact for any size
  std::vector<Vector3d> residuals;   ///< observed minus carried, mm
  double rms = 0.0;                  ///< of all 3 N components, mm
  SmallMotion standard_uncertainty;  ///< from the residuals with 3 N − 6 degrees of freedom
};

/// Least squares by Kabsch (theory.md, 2.3). Both lists in one frame, mm. Fails on fewer than three targets,
/// on lists of different lengths and on targets in one line, which leave the rotation about it open.
[[nodiscard]] Result<RigidFit> fitRigidMotion(std::span<const Vector3d> targets,
                                              std::span<const Vector3d> observed);

/// The same pose error of a rotary joint stated in the frame that turns with it (theory.md, 1.4):
/// E_body = R(−q) E_fixed R(q). `axis` is the joint's direction (unit), `angle` its position in rad.
[[nodiscard]] SmallMotion inTurningFrame(const SmallMotion& standing, const Vector3d& axis, double angle);
/// The way back: E_fixed = R(q) E_body R(−q).
[[nodiscard]] SmallMotion inStandingFrame(const SmallMotion& turning, const Vector3d& axis, double angle);

/// The same error referred to another point of the body: δ' = δ + (R(ε) − 1) (to − from), exact.
[[nodiscard]] SmallMotion atReferencePoint(const SmallMotion& motion, const Vector3d& from,
                                           const Vector3d& to);

}  // namespace nineline::identification
