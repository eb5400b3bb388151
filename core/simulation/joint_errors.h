#pragma once

#include "core/kinematics/step_solver.h"

namespace nineline::simulation {

/// How much of a pose the joints of `free` (bit i: joint i) can hold: with two rotary and at least five
/// joints the tip and the tool axis, with rotary joints alone the whole orientation, otherwise the tip.
[[nodiscard]] kinematics::PoseTarget::Rotation solvableRotation(const kinematics::Machine& machine,
                                                                unsigned free);

/// A target that asks for as much of `pose` as `rotation` says.
[[nodiscard]] kinematics::PoseTarget targetOf(const kinematics::ToolPose& pose,
                                              kinematics::PoseTarget::Rotation rotation);

/// Errors of the joints for several poses about one command: the Jacobian is decomposed once
/// (theory.md, 1.5).
class JointErrorSolver {
 public:
  /// `ideal`: the ideal pose at q, with its Jacobian.
  JointErrorSolver(const kinematics::Machine& machine, const kinematics::JointPositions& q,
                   const kinematics::ToolPose& ideal, const kinematics::PoseJacobian& jacobian);
  /// Joint motion that the ideal machine would need to stand at `actual` instead of at q.
  [[nodiscard]] kinematics::JointPositions errorsOf(const kinematics::ToolPose& actual) const;

 private:
  const kinematics::Machine& machine_;
  const kinematics::JointPositions& q_;
  const kinematics::ToolPose& ideal_;
  kinematics::PoseTarget::Rotation rotation_;
  kinematics::StepSolver solver_;
};

}  // namespace nineline::simulation
