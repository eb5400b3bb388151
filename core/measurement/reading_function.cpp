#include "core/measurement/reading_function.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/units.h"
#include "core/kinematics/rotation.h"

namespace nineline::measurement {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using kinematics::JointDisplacements;
using kinematics::Side;
using kinematics::SmallMotion;

namespace {

struct Pose {
  Matrix3d R = Matrix3d::Identity();
  Vector3d p = Vector3d::Zero();

  [[nodiscard]] Vector3d operator*(const Vector3d& point) const { return R * point + p; }
};

/// The three elementary rotations of a location error, in their order.
Matrix3d locatedRotation(const Vector3d& angles) {
  Matrix3d R = Matrix3d::Identity();
  for (int k = 0; k < 3; ++k) {
    if (angles[k] != 0.0) R = R * kinematics::rotationAbout(Vector3d::Unit(k), angles[k]);
  }
  return R;
}

void apply(const SmallMotion& motion, Pose& pose) {
  pose.p += pose.R * motion.translation;
  if (!motion.rotation.isZero(0.0)) pose.R = pose.R * kinematics::exponential(motion.rotation);
}

void applyLocated(const SmallMotion& motion, Pose& pose) {
  pose.p += pose.R * motion.translation;
  if (!motion.rotation.isZero(0.0)) pose.R = pose.R * locatedRotation(motion.rotation);
}

Matrix3d inverseLeftJacobian(const Vector3d& w) {
  return w.isZero(0.0) ? Matrix3d::Identity() : Matrix3d(kinematics::leftJacobian(w).inverse());
}

}  // namespace

/// Frames in M of one pose of the machine: of every joint and slot before the slot's own small motion, and of
/// the bodies.
struct ReadingFunction::Chain {
  std::array<Pose, kMaxAxes> located;
  std::array<Pose, kMaxAxes> standing;
  std::array<Pose, kMaxAxes> moved;
  std::array<Pose, kMaxAxes> body;
  Pose workpiece;
  Pose tool;
  Vector3d tip_M = Vector3d::Zero();
  Vector3d tip_W = Vector3d::Zero();

  Chain(const Machine& machine, const JointPositions& q, const JointDisplacements& displacements) {
    for (int i = 0; i < machine.jointCount(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      const kinematics::Joint& joint = machine.joint(i);
      Pose& pose = machine.side(i) == Side::Workpiece ? workpiece : tool;
      pose.p += pose.R * joint.offset;
      located[k] = pose;
      applyLocated(displacements[k].located, pose);
      standing[k] = pose;
      apply(displacements[k].standing, pose);
      if (joint.type == kinematics::JointType::Linear) {
        pose.p += pose.R * (q[k] * joint.direction);
      } else {
        pose.R = pose.R * kinematics::rotationAbout(joint.direction, q[k]);
      }
      moved[k] = pose;
      apply(displacements[k].moved, pose);
      body[k] = pose;
    }
    tip_M = tool * machine.toolTip();
    tip_W = workpiece.R.transpose() * (tip_M - workpiece.p);
  }
};

/// One reading and what it is sensitive to: d reading = force · velocity(at) + torque · ω, in M, for a motion
/// of the body under test, or of the tool relative to the workpiece.
struct ReadingFunction::Sight {
  double reading = 0.0;
  Vector3d at = Vector3d::Zero();
  Vector3d force = Vector3d::Zero();
  Vector3d torque = Vector3d::Zero();
};

ReadingFunction::ReadingFunction(const Machine& machine, const Instrument& instrument,
                                 std::vector<Channel> channels)
    : machine_(&machine), instrument_(instrument), channels_(std::move(channels)) {
  if (instrument.needsAxis()) {
    NL_EXPECTS(instrument.axis.has_value());
    joint_ = machine.find(*instrument.axis);
    NL_EXPECTS(joint_ >= 0, instrument.axis->text());
  }
  const Chain zero(machine, {}, {});
  point_M_ = zero.workpiece * instrument.point;
  point_B_ = joint_ < 0 ? point_M_ : Vector3d(point_M_ - zero.body[static_cast<std::size_t>(joint_)].p);
}

void ReadingFunction::read(const JointPositions& q, const JointDisplacements& displacements,
                           std::span<double> readings) const {
  evaluate(q, displacements, readings, nullptr);
}

void ReadingFunction::readWithGradient(const JointPositions& q, const JointDisplacements& displacements,
                                       std::span<double> readings, std::span<double> gradient) const {
  NL_EXPECTS(gradient.size() == channelCount() * gradientSize(), gradient.size());
  std::fill(gradient.begin(), gradient.end(), 0.0);
  evaluate(q, displacements, readings, gradient.data());
}

void ReadingFunction::evaluate(const JointPositions& q, const JointDisplacements& displacements,
                               std::span<double> readings, double* gradient) const {
  NL_EXPECTS(readings.size() == channelCount(), readings.size());
  if (instrument_.kind == InstrumentKind::Joint) {
    for (double& reading : readings) reading = ownPositioning(displacements, gradient);
    return;
  }
  const Chain actual(*machine_, q, displacements);
  const Chain ideal(*machine_, q, {});
  for (std::size_t k = 0; k < channels_.size(); ++k) {
    const Sight sight = sightOf(channels_[k], actual, ideal);
    readings[k] = sight.reading;
    if (gradient != nullptr) spread(sight, actual, displacements, gradient + k * gradientSize());
  }
}

ReadingFunction::Sight ReadingFunction::sightOf(const Channel& channel, const Chain& actual,
                                                const Chain& ideal) const {
  return joint_ >= 0 ? bodySight(actual, ideal) : toolSight(channel, actual, ideal);
}

ReadingFunction::Sight ReadingFunction::bodySight(const Chain& actual, const Chain& ideal) const {
  const auto k = static_cast<std::size_t>(joint_);
  const Pose& body = actual.body[k];
  const Pose& ideal_body = ideal.body[k];
  Sight sight;
  if (instrument_.kind == InstrumentKind::LaserAngular) {
    const Vector3d w = kinematics::logarithm(body.R * ideal_body.R.transpose());
    sight.reading = w[instrument_.about];
    sight.torque = inverseLeftJacobian(w).row(instrument_.about);
    return sight;
  }
  Vector3d nominal = ideal_body * point_B_;
  sight.at = body * point_B_;
  if (instrument_.kind == InstrumentKind::Dial) {
    nominal = point_M_;
    sight.at = body * (ideal_body.R.transpose() * (point_M_ - ideal_body.p));
  }
  sight.force = instrument_.kind == InstrumentKind::LaserLinear
                    ? Vector3d(ideal.standing[k].R * machine_->joint(joint_).direction)
                    : Vector3d(Vector3d::Unit(instrument_.sensitive));
  sight.reading = (sight.at - nominal).dot(sight.force);
  return sight;
}

namespace {

/// The gradient of a reading with respect to the tool's position and rotation, in W.
struct ToolGradient {
  double reading = 0.0;
  Vector3d position = Vector3d::Zero();
  Vector3d rotation = Vector3d::Zero();
};

ToolGradient leadReading(double lead, const Vector3d& p, const Vector3d& p_ideal, const Matrix3d& R_dev) {
  const double per_radian = lead / kTurn;
  const double radius = p_ideal.head<2>().norm();
  ToolGradient result;
  result.position = Vector3d::UnitZ();
  double angle = 0.0;
  if (radius < kNanometre || p.head<2>().norm() < kNanometre) {
    const Vector3d w = kinematics::logarithm(R_dev);
    angle = w.z();
    result.rotation = -per_radian * inverseLeftJacobian(w).row(2).transpose();
  } else {
    angle = std::atan2(p_ideal.x() * p.y() - p_ideal.y() * p.x(), p_ideal.head<2>().dot(p.head<2>()));
    result.position += per_radian / p.head<2>().squaredNorm() * Vector3d(p.y(), -p.x(), 0.0);
  }
  result.reading = p.z() - p_ideal.z() - per_radian * angle;
  return result;
}

}  // namespace

ReadingFunction::Sight ReadingFunction::toolSight(const Channel& channel, const Chain& actual,
                                                  const Chain& ideal) const {
  ToolGradient tool;
  const auto deviationRotation = [&]() -> Matrix3d {
    return actual.workpiece.R.transpose() * actual.tool.R * ideal.tool.R.transpose() * ideal.workpiece.R;
  };
  if (instrument_.kind == InstrumentKind::Lead) {
    tool = leadReading(instrument_.lead(), actual.tip_W, ideal.tip_W, deviationRotation());
  } else if (instrument_.kind == InstrumentKind::Ballbar) {
    const Vector3d arm = actual.tip_W - instrument_.centre;
    const double length = arm.norm();
    tool.reading = length - instrument_.radius;
    if (length > 0.0) tool.position = arm / length;
  } else if (channel.isAngular()) {
    const int row = static_cast<int>(channel.quantity) - static_cast<int>(Quantity::RotX);
    const Vector3d w = kinematics::logarithm(deviationRotation());
    tool.reading = w[row];
    tool.rotation = inverseLeftJacobian(w).row(row);
  } else {
    const int row = static_cast<int>(channel.quantity) - static_cast<int>(Quantity::DevX);
    tool.reading = actual.tip_W[row] - ideal.tip_W[row];
    tool.position = Vector3d::Unit(row);
  }
  const Matrix3d& R_MW = actual.workpiece.R;
  return {tool.reading, actual.tip_M, R_MW * tool.position, R_MW * tool.rotation};
}

void ReadingFunction::spread(const Sight& sight, const Chain& chain, const JointDisplacements& displacements,
                             double* gradient) const {
  const bool of_body = joint_ >= 0;
  for (int i = 0; i < machine_->jointCount(); ++i) {
    if (of_body && (machine_->side(i) != machine_->side(joint_) || i > joint_)) continue;
    const double sign = !of_body && machine_->side(i) == Side::Workpiece ? -1.0 : 1.0;
    const auto k = static_cast<std::size_t>(i);
    double* out = gradient + k * kGradientPerJoint;
    const auto put = [&](const Pose& pose, const SmallMotion& motion, double* six) -> Vector3d {
      const Vector3d arm = sight.at - pose.p - pose.R * motion.translation;
      const Vector3d force = sign * (pose.R.transpose() * sight.force);
      const Vector3d torque = sign * (pose.R.transpose() * (arm.cross(sight.force) + sight.torque));
      for (int c = 0; c < 3; ++c) six[c] = force[c];
      return torque;
    };
    const auto putRotation = [](const Vector3d& rotation, double* six) {
      for (int c = 0; c < 3; ++c) six[3 + c] = rotation[c];
    };
    const kinematics::JointDisplacement& displacement = displacements[k];
    Vector3d torque = put(chain.located[k], displacement.located, out);
    const Vector3d& angles = displacement.located.rotation;
    Matrix3d axes = Matrix3d::Identity();  // the axes of Rx, Ry, Rz as each finds them
    if (!angles.isZero(0.0)) {
      const Matrix3d Rx = kinematics::rotationAbout(Vector3d::UnitX(), angles.x());
      axes.col(1) = Rx.col(1);
      axes.col(2) = Rx * kinematics::rotationAbout(Vector3d::UnitY(), angles.y()).col(2);
    }
    putRotation(axes.transpose() * torque, out);
    const auto putExponential = [&](const Pose& pose, const SmallMotion& motion, double* six) {
      torque = put(pose, motion, six);
      if (!motion.rotation.isZero(0.0)) {
        torque = kinematics::leftJacobian(motion.rotation).transpose() * torque;
      }
      putRotation(torque, six);
    };
    putExponential(chain.standing[k], displacement.standing, out + 6);
    putExponential(chain.moved[k], displacement.moved, out + 12);
  }
}

double ReadingFunction::ownPositioning(const JointDisplacements& displacements, double* gradient) const {
  const auto k = static_cast<std::size_t>(joint_);
  const Vector3d& direction = machine_->joint(joint_).direction;
  const bool rotary = machine_->isRotary(joint_);
  if (gradient != nullptr) {
    double* out = gradient + k * kGradientPerJoint + (rotary ? 3 : 0);
    for (int c = 0; c < 3; ++c) out[6 + c] = out[12 + c] = direction[c];
  }
  const kinematics::JointDisplacement& own = displacements[k];
  return direction.dot(rotary ? Vector3d(own.standing.rotation + own.moved.rotation)
                              : Vector3d(own.standing.translation + own.moved.translation));
}

}  // namespace nineline::measurement
