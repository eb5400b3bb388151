#pragma once

#include "core/compensation/compensation.h"
#include "core/kinematics/step_solver.h"

namespace nineline::compensation {

using errors::MachineState;
using kinematics::ToolPose;

/// Finds the command that puts the actual tool on an ideal pose: Newton's method on the exact model
/// (theory.md, 1.6).
class PointSolver {
 public:
  PointSolver(const ErrorModel& model, const CompensationOptions& options);

  /// What a point asks for.
  struct Request {
    JointPositions ideal{};                        ///< command whose ideal pose is wanted
    std::array<std::int8_t, kMaxAxes> approach{};  ///< senses in which the joints arrive
    unsigned free = 0;                             ///< joints that may move, bit i: joint i
    /// Thread mode: advance of the thread along its axis for one rad of turning, d z / d φ in W; absent where
    /// the path does not turn about the workpiece axis.
    std::optional<double> advance;
  };

  /// The corrected command; joints that are not free stay where `guess` has them. Directions in which the
  /// free joints cannot move the tool keep their deviation. Fails with NoAnswer when Newton's method does not
  /// converge within 12 steps or wants a step above 5 mm or 0.1 rad.
  [[nodiscard]] Result<JointPositions> solve(const Request& request, const JointPositions& guess);

  /// Pose of the actual tool at a command, for a single instant.
  [[nodiscard]] ToolPose actualPose(const JointPositions& q,
                                    const std::array<std::int8_t, kMaxAxes>& approach);

  [[nodiscard]] MachineState& conditions() { return state_; }
  /// Joints that a mode lets move, of those that the program has positioned.
  [[nodiscard]] unsigned freeJoints(unsigned positioned) const;

 private:
  [[nodiscard]] JointPositions threadStep(const kinematics::PoseJacobian& jacobian,
                                          const kinematics::PoseResidual& left,
                                          const kinematics::PoseTarget& target, const Request& request) const;
  const ErrorModel& model_;
  Mode mode_;
  MachineState state_;
};

/// True where the last workpiece joint is rotary: the machine can grind threads.
[[nodiscard]] bool hasWorkSpindle(const kinematics::Machine& machine);

}  // namespace nineline::compensation
