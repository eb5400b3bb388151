#pragma once

#include <Eigen/Geometry>

#include "core/kinematics/machine.h"
#include "core/kinematics/rotation.h"

namespace nineline::kinematics {

/// A small rigid motion: translation δ in mm and rotation vector ε in rad, x → δ + R(ε) x.
struct SmallMotion {
  Vector3d translation = Vector3d::Zero();
  Vector3d rotation = Vector3d::Zero();
  [[nodiscard]] bool isZero() const { return translation.isZero(0.0) && rotation.isZero(0.0); }
};

/// How one joint deviates: T_FD = Trans(offset) · Located · Standing · Motion(q) · Moved.
/// Located: location errors, rotation Rx(a) Ry(b) Rz(c) (theory.md, 1.3). Standing: errors stated in the
/// frame that does not turn (rotary tables with "frame": "fixed"). Moved: errors in the frame that moves
/// along (the default).
struct JointDisplacement {
  SmallMotion located;
  SmallMotion standing;
  SmallMotion moved;
};
using JointDisplacements = std::array<JointDisplacement, kMaxAxes>;

/// Pose of the tool in the workpiece frame W. With first-order matrices `R_WP` is not quite a rotation.
struct ToolPose {
  Vector3d tip = Vector3d::Zero();  ///< p_WP, mm
  Matrix3d R_WP = Matrix3d::Identity();
  Vector3d axis = Vector3d::UnitZ();  ///< unit vector from the tip towards the holder, in W
};

/// Derivatives of the tool's pose with respect to the joint positions; column i belongs to joint i.
/// Rows 0…2: d tip / dq (mm per mm or rad); rows 3…5: angular velocity of the tool relative to W, in W.
using PoseJacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, kMaxAxes>;

/// Pose of the ideal tool at q: no errors.
[[nodiscard]] ToolPose forward(const Machine& machine, const JointPositions& q);

/// Pose of a tool whose joints are displaced. The same chain as `forward`, which is the case of zero
/// displacements.
[[nodiscard]] ToolPose forward(const Machine& machine, const JointPositions& q,
                               const JointDisplacements& displacements,
                               RotationModel model = RotationModel::Exact);

/// Pose and analytic Jacobian of the ideal tool (product of exponentials, theory.md, 4.1 eq. 10).
[[nodiscard]] ToolPose forwardWithJacobian(const Machine& machine, const JointPositions& q,
                                           PoseJacobian& jacobian);

/// Pose and Jacobian of the displaced tool with the displacements held constant.
[[nodiscard]] ToolPose forwardWithJacobian(const Machine& machine, const JointPositions& q,
                                           const JointDisplacements& displacements, PoseJacobian& jacobian,
                                           RotationModel model = RotationModel::Exact);

/// Derivatives of the displacements of one joint with respect to its own position, per mm or rad.
struct DisplacementSlope {
  SmallMotion standing;
  SmallMotion moved;
};
using DisplacementSlopes = std::array<DisplacementSlope, kMaxAxes>;

/// Adds to `jacobian` (of forwardWithJacobian at the same arguments, exact rotations) what the change of the
/// displacements with the joint positions contributes (theory.md, 1.6: E' p = Jl(ε) ε' × R p + δ').
void addSlopes(const Machine& machine, const JointPositions& q, const JointDisplacements& displacements,
               const DisplacementSlopes& slopes, PoseJacobian& jacobian);

/// Poses in the bed frame M at q of every joint's moved body (D), in joint order; for drawings and for
/// instruments that stand on the bed.
using BodyPoses = std::array<Eigen::Isometry3d, kMaxAxes>;
[[nodiscard]] BodyPoses bodyPoses(const Machine& machine, const JointPositions& q,
                                  const JointDisplacements& displacements = {});

}  // namespace nineline::kinematics
