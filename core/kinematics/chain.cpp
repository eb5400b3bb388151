#include "core/kinematics/chain.h"

#include <cmath>

namespace nineline::kinematics {

namespace {

/// A pose under construction, kept as rotation and translation so that a step costs no 4×4 product.
struct Frame {
  Matrix3d R = Matrix3d::Identity();
  Vector3d p = Vector3d::Zero();

  void translate(const Vector3d& by) { p.noalias() += R * by; }

  void rotate(const Vector3d& w, RotationModel model) {
    if (w.isZero(0.0)) return;
    const Matrix3d by =
        model == RotationModel::Exact ? exponential(w) : Matrix3d(Matrix3d::Identity() + skew(w));
    R = R * by;
  }

  /// Turns about a joint direction; columns alone change where it is an axis of the frame.
  void turn(const Vector3d& direction, double angle) {
    for (int k = 0; k < 3; ++k) {
      const int a = (k + 1) % 3;
      const int b = (k + 2) % 3;
      if (direction[a] != 0.0 || direction[b] != 0.0) continue;
      const double c = std::cos(angle);
      const double s = std::sin(angle) * direction[k];
      const Vector3d column = R.col(a);
      R.col(a) = c * column + s * R.col(b);
      R.col(b) = c * R.col(b) - s * column;
      return;
    }
    R = R * rotationAbout(direction, angle);
  }

  void apply(const SmallMotion& motion, RotationModel model) {
    if (!motion.translation.isZero(0.0)) translate(motion.translation);
    rotate(motion.rotation, model);
  }
};

/// Location errors turn about fixed axes in the order Rx(a) Ry(b) Rz(c) (theory.md, 1.3).
void applyLocated(Frame& frame, const SmallMotion& located, RotationModel model) {
  if (!located.translation.isZero(0.0)) frame.translate(located.translation);
  if (located.rotation.isZero(0.0)) return;
  if (model == RotationModel::FirstOrder) return frame.rotate(located.rotation, model);
  for (int k = 0; k < 3; ++k) {
    if (located.rotation[k] != 0.0) frame.turn(Vector3d::Unit(k), located.rotation[k]);
  }
}

/// Direction and a point of each joint's axis in the bed frame.
struct Screw {
  Vector3d direction;
  Vector3d point;
};
using Screws = std::array<Screw, kMaxAxes>;

void advance(Frame& frame, const Joint& joint, double q, const JointDisplacement* displacement,
             RotationModel model, Screw* screw) {
  frame.translate(joint.offset);
  if (displacement != nullptr) {
    applyLocated(frame, displacement->located, model);
    frame.apply(displacement->standing, model);
  }
  if (screw != nullptr) *screw = {frame.R * joint.direction, frame.p};
  if (joint.type == JointType::Linear) {
    frame.translate(q * joint.direction);
  } else {
    frame.turn(joint.direction, q);
  }
  if (displacement != nullptr) frame.apply(displacement->moved, model);
}

ToolPose evaluate(const Machine& machine, const JointPositions& q, const JointDisplacements* displacements,
                  RotationModel model, PoseJacobian* jacobian) {
  Screws screws;
  Frame workpiece;
  Frame tool;
  for (int i = 0; i < machine.jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    Frame& frame = machine.side(i) == Side::Workpiece ? workpiece : tool;
    advance(frame, machine.joint(i), q[k], displacements != nullptr ? &(*displacements)[k] : nullptr, model,
            jacobian != nullptr ? &screws[k] : nullptr);
  }
  const Vector3d tip = tool.p + tool.R * machine.toolTip();
  const bool skewed = model == RotationModel::FirstOrder && displacements != nullptr;
  const Matrix3d R_WM = skewed ? Matrix3d(workpiece.R.inverse()) : Matrix3d(workpiece.R.transpose());
  ToolPose pose;
  pose.tip = R_WM * (tip - workpiece.p);
  pose.R_WP = R_WM * tool.R;
  pose.axis = (pose.R_WP * machine.toolAxis()).normalized();
  if (jacobian == nullptr) return pose;
  jacobian->resize(6, machine.jointCount());
  for (int i = 0; i < machine.jointCount(); ++i) {
    const Screw& screw = screws[static_cast<std::size_t>(i)];
    const double sign = machine.side(i) == Side::Workpiece ? -1.0 : 1.0;
    const bool rotary = machine.isRotary(i);
    const Vector3d velocity = rotary ? Vector3d(screw.direction.cross(tip - screw.point)) : screw.direction;
    jacobian->col(i).head<3>() = sign * (R_WM * velocity);
    jacobian->col(i).tail<3>() = rotary ? Vector3d(sign * (R_WM * screw.direction)) : Vector3d::Zero();
  }
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
    applyLocated(located, displacements[k].located, RotationModel::Exact);
    standing[k] = located;
    advance(frame, joint, q[k], &displacements[k], RotationModel::Exact, nullptr);
    moved[k] = located;
    moved[k].apply(displacements[k].standing, RotationModel::Exact);
    if (joint.type == JointType::Linear) {
      moved[k].translate(q[k] * joint.direction);
    } else {
      moved[k].turn(joint.direction, q[k]);
    }
  }
  const Vector3d tip = tool.p + tool.R * machine.toolTip();
  const Matrix3d R_WM = workpiece.R.transpose();
  for (int i = 0; i < machine.jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double sign = machine.side(i) == Side::Workpiece ? -1.0 : 1.0;
    const auto add = [&](const Frame& frame, const SmallMotion& motion, const SmallMotion& slope) {
      if (slope.isZero()) return;
      const Vector3d turning = frame.R * (leftJacobian(motion.rotation) * slope.rotation);
      const Vector3d arm = tip - frame.p - frame.R * motion.translation;
      jacobian.col(i).head<3>() += sign * (R_WM * (frame.R * slope.translation + turning.cross(arm)));
      jacobian.col(i).tail<3>() += sign * (R_WM * turning);
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
    poses[k].linear() = frame.R;
    poses[k].translation() = frame.p;
  }
  return poses;
}

}  // namespace nineline::kinematics
