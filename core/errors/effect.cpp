#include "core/errors/effect.h"

#include <cmath>

namespace nineline::errors {

Component positioningOf(const kinematics::Joint& joint) {
  Eigen::Index row = 0;
  joint.direction.cwiseAbs().maxCoeff(&row);
  return {joint.axis, static_cast<int>(row) + (joint.type == kinematics::JointType::Rotary ? 3 : 0), false};
}

SmallMotion unitMotion(const kinematics::Joint& joint, const Component& component) {
  SmallMotion unit;
  const bool own = component == positioningOf(joint);
  const Eigen::Vector3d direction = own ? joint.direction : Eigen::Vector3d::Unit(component.row % 3);
  (component.isAngular() ? unit.rotation : unit.translation) = direction;
  return unit;
}

void addScaled(double factor, const SmallMotion& unit, SmallMotion& sum) {
  sum.translation += factor * unit.translation;
  sum.rotation += factor * unit.rotation;
}

}  // namespace nineline::errors
