#include "core/kinematics/chain.h"

#include "core/kinematics/frame.h"

namespace nineline::kinematics {

namespace {

/// Direction and a point of each joint's axis in the bed frame.
struct Screw {
  Vector3d direction;
  Vector3d point;
};
using Screws = std::array<Screw, kMaxAxes>;

void advance(Frame& frame, const Joint& joint, double q, const JointDisplacement* displacement,
             RotationModel model, Screw* screw) {
  if (!isNothing(joint.offset)) frame.translate(joint.offset);
  if (displacement != nullptr) {
    if (!isNothing(displacement->located)) frame.applyLocated(displacement->located, model);
    if (!isNothing(displacement->standing)) frame.apply(displacement->standing, model);
  }
  if (screw != nullptr) *screw = {frame.times(joint.direction), frame.position()};
  frame.move(joint, q);
  if (displacement != nullptr && !isNothing(displacement->moved)) frame.apply(displacement->moved, model);
}

void fillJacobian(const Machine& machine, const Screws& screws, const Vector3d& tip, const Frame& workpiece,
                  PoseJacobian& jacobian) {
  jacobian.resize(6, machine.jointCount());
  for (int i = 0; i < machine.jointCount(); ++i) {
    const Screw& screw = screws[static_cast<std::size_t>(i)];
    const double sign = machine.side(i) == Side::Workpiece ? -1.0 : 1.0;
    double* const column = jacobian.data() + 6 * i;
    const bool rotary = machine.isRotary(i);
    const Vector3d direction = workpiece.transposedTimes(screw.direction);
    const Vector3d velocity =
        rotary ? workpiece.transposedTimes(Vector3d(screw.direction.cross(tip - screw.point))) : direction;
    for (int row = 0; row < 3; ++row) {
      column[row] = sign * velocity[row];
      column[3 + row] = rotary ? sign * direction[row] : 0.0;
    }
  }
}

ToolPose evaluate(const Machine& machine, const JointPositions& q, const JointDisplacements* displacements,
                  RotationModel model, PoseJacobian* jacobian) {
  Screws screws;
  Frame workpiece;
  Frame tool;
  const int workpiece_joints = machine.workpieceJointCount();
  for (int i = 0; i < machine.jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    advance(i < workpiece_joints ? workpiece : tool, machine.joint(i), q[k],
            displacements != nullptr ? &(*displacements)[k] : nullptr, model,
            jacobian != nullptr ? &screws[k] : nullptr);
  }
  const bool skewed = model == RotationModel::FirstOrder && displacements != nullptr;
  if (skewed) workpiece.invertSkewed();
  const Vector3d tip = tool.at(machine.toolTip());
  ToolPose pose;
  pose.tip = workpiece.transposedTimes(Vector3d(tip - workpiece.position()));
  pose.R_WP = workpiece.transposedTimes(tool);
  const Vector3d& axis = machine.toolAxis();
  for (int i = 0; i < 3; ++i)
    pose.axis[i] = pose.R_WP(i, 0) * axis[0] + pose.R_WP(i, 1) * axis[1] + pose.R_WP(i, 2) * axis[2];
  if (skewed) pose.axis.normalize();
  if (jacobian != nullptr) fillJacobian(machine, screws, tip, workpiece, *jacobian);
  return pose;
}

}  // namespace

ToolPose forward(const Machine& machine, const JointPositions& q) {
  return evaluate(machine, q, nullptr, RotationModel::Exact, nullptr);
}

ToolPose forward(const Machine& machine, const JointPositions& q, const JointDisplacements& displacements,
                 RotationModel model) {
  return evaluate(machine, q, &displacements, model, nullptr);
}

ToolPose forwardWithJacobian(const Machine& machine, const JointPositions& q, PoseJacobian& jacobian) {
  return evaluate(machine, q, nullptr, RotationModel::Exact, &jacobian);
}

ToolPose forwardWithJacobian(const Machine& machine, const JointPositions& q,
                             const JointDisplacements& displacements, PoseJacobian& jacobian,
                             RotationModel model) {
  return evaluate(machine, q, &displacements, model, &jacobian);
}

void addSlopes(const Machine& machine, const JointPositions& q, const JointDisplacements& displacements,
               const DisplacementSlopes& slopes, PoseJacobian& jacobian) {
  // The pose of every deviating frame in M first: a small motion there moves all that it carries.
  std::array<Frame, kMaxAxes> standing;
  std::array<Frame, kMaxAxes> moved;
  Frame workpiece;
  Frame tool;
  for (int i = 0; i < machine.jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    Frame& frame = machine.side(i) == Side::Workpiece ? workpiece : tool;
    const Joint& joint = machine.joint(i);
    Frame located = frame;
    located.translate(joint.offset);
    located.applyLocated(displacements[k].located, RotationModel::Exact);
    standing[k] = located;
    advance(frame, joint, q[k], &displacements[k], RotationModel::Exact, nullptr);
    moved[k] = located;
    moved[k].apply(displacements[k].standing, RotationModel::Exact);
    moved[k].move(joint, q[k]);
  }
  const Vector3d tip = tool.at(machine.toolTip());
  for (int i = 0; i < machine.jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double sign = machine.side(i) == Side::Workpiece ? -1.0 : 1.0;
    const auto add = [&](const Frame& frame, const SmallMotion& motion, const SmallMotion& slope) {
      if (slope.isZero()) return;
      const Vector3d turning = frame.times(leftJacobian(motion.rotation) * slope.rotation);
      const Vector3d arm = tip - frame.at(motion.translation);
      const Vector3d velocity = frame.times(slope.translation) + turning.cross(arm);
      jacobian.col(i).head<3>() += sign * workpiece.transposedTimes(velocity);
      jacobian.col(i).tail<3>() += sign * workpiece.transposedTimes(turning);
    };
    add(standing[k], displacements[k].standing, slopes[k].standing);
    add(moved[k], displacements[k].moved, slopes[k].moved);
  }
}

BodyPoses bodyPoses(const Machine& machine, const JointPositions& q,
                    const JointDisplacements& displacements) {
  BodyPoses poses;
  poses.fill(Eigen::Isometry3d::Identity());
  Frame workpiece;
  Frame tool;
  for (int i = 0; i < machine.jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    Frame& frame = machine.side(i) == Side::Workpiece ? workpiece : tool;
    advance(frame, machine.joint(i), q[k], &displacements[k], RotationModel::Exact, nullptr);
    poses[k].linear() = frame.rotation();
    poses[k].translation() = frame.position();
  }
  return poses;
}

}  // namespace nineline::kinematics
