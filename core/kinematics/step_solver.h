#pragma once

#include "core/kinematics/inverse.h"

namespace nineline::kinematics {

/// `leastSquaresStep` for several residuals of one Jacobian: the matrix is inverted once. Three joints that
/// hold the tip, and three linear and two rotary ones that hold tip and tool axis, are inverted directly
/// while the pose is far from singular; every other case through its singular values.
class StepSolver {
 public:
  StepSolver(const Machine& machine, const PoseJacobian& jacobian, const PoseTarget& target,
             const StepOptions& options);
  [[nodiscard]] JointPositions step(const PoseResidual& residual) const;
  /// The largest turn of a rotary joint that a rotation of the tool by 1 rad asks for; large near a singular
  /// pose.
  [[nodiscard]] double turnGain() const { return turn_gain_; }

 private:
  double turn_gain_ = 0.0;
  int count_ = 0;                       // joints that move
  std::array<int, kMaxAxes> joints_{};  // their indices
  Eigen::Matrix<double, Eigen::Dynamic, 6, 0, kMaxAxes, 6>
      inverse_;  // joint steps for a unit of each residual row
};

}  // namespace nineline::kinematics
