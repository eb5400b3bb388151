#pragma once

#include "core/kinematics/chain.h"

namespace nineline::kinematics {

/// What the tool should reach in W, and how much of it is asked for.
struct PoseTarget {
  enum class Rotation {
    None,  ///< the tip alone
    Axis,  ///< the tip and the tool axis; the spin about the axis is free
    Full   ///< the whole orientation
  };
  Vector3d tip = Vector3d::Zero();       ///< mm
  Vector3d axis = Vector3d::UnitZ();     ///< unit vector (Axis)
  Matrix3d R_WP = Matrix3d::Identity();  ///< (Full)
  Rotation rotation = Rotation::None;
};

/// Target minus pose: rows 0…2 mm, rows 3…5 the rotation vector in W that turns the pose into the target, rad
/// (zero for Rotation::None).
using PoseResidual = Eigen::Matrix<double, 6, 1>;
[[nodiscard]] PoseResidual residual(const PoseTarget& target, const ToolPose& pose);

/// One linearised step: the smallest joint motion dq (rotary joints weighed by `rotary_length`) that removes
/// the residual in the least-squares sense, restricted to the joints of `free`. Directions that the joints
/// reach only with a lever below `weakest` of the best one are left alone, so that a singular pose asks for
/// no wild motion. Source: theory.md, 4.2 and 4.6.
struct StepOptions {
  double rotary_length = 100.0;    ///< mm: what one rad of a rotary joint weighs
  double rotation_length = 100.0;  ///< mm: what one rad of the pose weighs
  double weakest = 1e-4;
  unsigned free = (1U << kMaxAxes) - 1U;  ///< bit i: joint i may move
};
[[nodiscard]] JointPositions leastSquaresStep(const Machine& machine, const PoseJacobian& jacobian,
                                              const PoseResidual& residual, const PoseTarget& target,
                                              const StepOptions& options);

struct InverseOptions {
  double position_tolerance = 1e-9;   ///< mm
  double rotation_tolerance = 1e-11;  ///< rad
  int most_iterations = 50;
  int most_starts = 60;  ///< further starts over the travel, when the given one fails
};

/// Joint positions that put the ideal tool on the target, by damped Newton steps from `start`; further starts
/// over the travel are tried when that fails. Rotary joints come out as near to `start` as whole turns allow.
/// Fails with NoAnswer and the last residual when the target is outside what the machine reaches.
[[nodiscard]] Result<JointPositions> inverse(const Machine& machine, const PoseTarget& target,
                                             const JointPositions& start, const InverseOptions& options = {});

/// The same for a full pose T_WP from the middle of the travel.
[[nodiscard]] Result<JointPositions> inverse(const Machine& machine, const Eigen::Isometry3d& T_WP);

}  // namespace nineline::kinematics
