#pragma once

#include <array>

#include "core/kinematics/machine.h"

namespace nineline::postprocessing {

using Eigen::Vector3d;
using kinematics::JointPositions;
using kinematics::Machine;

/// Tool tip (mm) and unit tool axis, tip towards holder, in the workpiece frame.
struct TipAxis {
  Vector3d tip = Vector3d::Zero();
  Vector3d axis = Vector3d::UnitZ();
};

/// Derivatives with respect to the joint positions, one entry for each joint of the machine, in W.
struct TipAxisJacobian {
  std::array<Vector3d, kMaxAxes> tip;   ///< of the tip: mm per mm or rad
  std::array<Vector3d, kMaxAxes> turn;  ///< angular velocity of the tool: zero for a linear joint
};

/// A machine as one chain from the workpiece to the tool, work-side motions inverted: ∏ Trans(L_i) J_i(q_i)
/// Trans(tool) (theory.md, 4.1). Because all frames are parallel at zero, only directions and offsets remain.
/// The chain is walked from the tool back, so that no rotation matrix is formed.
class TipAxisChain {
 public:
  explicit TipAxisChain(const Machine& machine);
  [[nodiscard]] int jointCount() const { return count_; }
  [[nodiscard]] TipAxis at(const JointPositions& q) const;
  [[nodiscard]] TipAxis at(const JointPositions& q, TipAxisJacobian& jacobian) const;

 private:
  struct Link {
    int joint = 0;  // of the machine
    bool rotary = false;
    int principal = -1;  // the frame axis that the direction lies along, −1 where along none
    double sign = 1.0;   // along it
    Vector3d direction;
    Vector3d offset;
  };
  template <bool WithJacobian>
  TipAxis walk(const JointPositions& q, TipAxisJacobian* jacobian) const;
  std::array<Link, kMaxAxes> links_;
  int count_ = 0;
  Vector3d tool_tip_;
  Vector3d tool_axis_;
};

}  // namespace nineline::postprocessing
