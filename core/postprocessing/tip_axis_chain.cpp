#include "core/postprocessing/tip_axis_chain.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/kinematics/frame.h"

namespace nineline::postprocessing {

namespace {

/// Rotates vectors about one direction by one angle.
class Turn {
 public:
  Turn(int principal, double sign, const Vector3d& direction, double angle)
      : principal_(principal), direction_(&direction), cosine_(std::cos(angle)), sine_(std::sin(angle)) {
    if (principal >= 0) sine_ *= sign;
  }
  void apply(Vector3d& v) const {
    switch (principal_) {
      case 0:
        return mix(v[1], v[2]);
      case 1:
        return mix(v[2], v[0]);
      case 2:
        return mix(v[0], v[1]);
      default:  // Rodrigues
        v = (cosine_ * v + sine_ * direction_->cross(v) +
             ((1.0 - cosine_) * direction_->dot(v)) * *direction_)
                .eval();
    }
  }

 private:
  void mix(double& a, double& b) const {
    const double old = a;
    a = cosine_ * old - sine_ * b;
    b = sine_ * old + cosine_ * b;
  }
  int principal_;
  const Vector3d* direction_;
  double cosine_;
  double sine_;
};

}  // namespace

TipAxisChain::TipAxisChain(const Machine& machine)
    : count_(machine.jointCount()), tool_tip_(machine.toolTip()), tool_axis_(machine.toolAxis()) {
  const int workpiece_joints = machine.workpieceJointCount();
  Vector3d offset = Vector3d::Zero();  // gathered in front of the next link
  for (int i = 0; i < count_; ++i) {
    const bool inverted = i < workpiece_joints;
    const int index = inverted ? workpiece_joints - 1 - i : i;
    const kinematics::Joint& joint = machine.joint(index);
    Link& link = links_[static_cast<std::size_t>(i)];
    link.joint = index;
    link.rotary = machine.isRotary(index);
    link.direction = inverted ? Vector3d(-joint.direction) : joint.direction;
    link.principal = kinematics::principalAxis(link.direction);
    link.sign = link.principal >= 0 ? link.direction[link.principal] : 1.0;
    if (!inverted) offset += joint.offset;
    link.offset = offset;
    offset = inverted ? Vector3d(-joint.offset) : Vector3d(Vector3d::Zero());
  }
  if (count_ == workpiece_joints) tool_tip_ += offset;
}

template <bool WithJacobian>
TipAxis TipAxisChain::walk(const JointPositions& q, TipAxisJacobian* jacobian) const {
  TipAxis result{tool_tip_, tool_axis_};
  for (int i = count_ - 1; i >= 0; --i) {
    const Link& link = links_[static_cast<std::size_t>(i)];
    const auto joint = static_cast<std::size_t>(link.joint);
    if (link.rotary) {
      const Turn turn(link.principal, link.sign, link.direction, q[joint]);
      turn.apply(result.tip);
      turn.apply(result.axis);
      if constexpr (WithJacobian) {
        for (int k = i + 1; k < count_; ++k) {
          const Link& later = links_[static_cast<std::size_t>(k)];
          turn.apply(jacobian->tip[static_cast<std::size_t>(later.joint)]);
          if (later.rotary) turn.apply(jacobian->turn[static_cast<std::size_t>(later.joint)]);
        }
        jacobian->tip[joint] = link.direction.cross(result.tip);
        jacobian->turn[joint] = link.direction;
      }
    } else {
      result.tip += q[joint] * link.direction;
      if constexpr (WithJacobian) {
        jacobian->tip[joint] = link.direction;
        jacobian->turn[joint].setZero();
      }
    }
    result.tip += link.offset;
  }
  return result;
}

TipAxis TipAxisChain::at(const JointPositions& q) const { return walk<false>(q, nullptr); }
TipAxis TipAxisChain::at(const JointPositions& q, TipAxisJacobian& jacobian) const {
  return walk<true>(q, &jacobian);
}

}  // namespace nineline::postprocessing
