#include "core/smoothing/axis_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/units.h"
#include "core/kinematics/step_solver.h"

namespace nineline::smoothing {

namespace {

unsigned bit(int joint) { return 1U << static_cast<unsigned>(joint); }

bool isTipAxis(const AxisId& axis) { return axis.digit == 0 && axis.letter >= 'X' && axis.letter <= 'Z'; }

/// Length of the lever with which a rotary joint moves the tip.
double largestLever(const Machine& machine, const JointPositions& q) {
  kinematics::PoseJacobian jacobian;
  static_cast<void>(forwardWithJacobian(machine, q, jacobian));
  double lever = 0.0;
  for (int i = 0; i < machine.jointCount(); ++i) {
    if (machine.isRotary(i)) lever = std::max(lever, jacobian.col(i).head<3>().norm());
  }
  return lever;
}

}  // namespace

Result<AxisMotion> AxisMotion::make(const Machine& machine, const PathSection& section) {
  AxisMotion motion(machine);
  motion.tool_centre_point_ = section.tool_centre_point;
  unsigned linear = 0;
  unsigned tip_axes = 0;
  int linear_count = 0;
  bool other_moves = false;
  for (int i = 0; i < machine.jointCount(); ++i) {
    const bool moves = nc::contains(section.moving, i);
    if (machine.isRotary(i)) {
      if (moves) motion.rotary_.push_back(i);
      continue;
    }
    ++linear_count;
    linear |= bit(i);
    if (isTipAxis(machine.joint(i).axis)) {
      tip_axes |= bit(i);
    } else {
      other_moves = other_moves || moves;
    }
  }
  const bool uses_tip_axes = linear_count > 3 || section.tool_centre_point;
  motion.free_ = uses_tip_axes ? tip_axes : linear;
  int free_count = 0;
  for (int i = 0; i < machine.jointCount(); ++i) free_count += (motion.free_ & bit(i)) != 0 ? 1 : 0;
  const bool undetermined = (uses_tip_axes && other_moves) || (motion.hasRotary() && free_count < 3);
  if (undetermined || static_cast<int>(motion.rotary_.size()) > kMostCoordinates - 3) {
    return badInput("smoothing.chain",
                    "The linear axes do not determine the tip for any turn of the rotary axes here.", {},
                    section.first_line);
  }
  motion.words_ = section.moving;
  if (motion.hasRotary() && !section.tool_centre_point)
    motion.words_ = static_cast<nc::AxisMask>(motion.words_ | motion.free_);
  return motion;
}

PointRows AxisMotion::rowsOf(const PathSection& section) const {
  PointRows rows(static_cast<Eigen::Index>(section.points.size()),
                 3 + static_cast<Eigen::Index>(rotary_.size()));
  for (std::size_t j = 0; j < section.points.size(); ++j) {
    const PathPoint& point = section.points[j];
    const auto row = static_cast<Eigen::Index>(j);
    rows.row(row).head<3>() = point.tip.transpose();
    for (std::size_t k = 0; k < rotary_.size(); ++k)
      rows(row, 3 + static_cast<Eigen::Index>(k)) = point.values[static_cast<std::size_t>(rotary_[k])];
  }
  return rows;
}

Result<nc::AxisValues> AxisMotion::valuesAt(const CurvePoint& point, const nc::AxisValues& near) const {
  nc::AxisValues q = near;
  for (std::size_t k = 0; k < rotary_.size(); ++k)
    q[static_cast<std::size_t>(rotary_[k])] = point[3 + static_cast<Eigen::Index>(k)];
  if (tool_centre_point_) {
    for (int i = 0; i < machine_->jointCount(); ++i) {
      if ((free_ & bit(i)) != 0) q[static_cast<std::size_t>(i)] = point[machine_->joint(i).axis.letter - 'X'];
    }
    return q;
  }
  kinematics::PoseTarget target;
  target.tip = point.head<3>();
  kinematics::StepOptions options;
  options.free = free_;
  kinematics::PoseJacobian jacobian;
  double left = 0.0;
  for (int iteration = 0; iteration < 4; ++iteration) {  // the tip is affine in the linear joints
    const kinematics::ToolPose pose = forwardWithJacobian(*machine_, q, jacobian);
    left = (target.tip - pose.tip).norm();
    if (left < 1e-11) break;
    const kinematics::StepSolver solver(*machine_, jacobian, target, options);
    const JointPositions step = solver.step(residual(target, pose));
    for (std::size_t k = 0; k < q.size(); ++k) q[k] += step[k];
  }
  left = (target.tip - forward(*machine_, q).tip).norm();
  if (!(left <= kNanometre))
    return noAnswer("smoothing.tip",
                    fmt::format("The linear axes cannot hold the smoothed tip: {:.6f} mm are left.", left));
  if (const int joint = machine_->firstOutsideTravel(q); joint >= 0)
    return noAnswer("smoothing.travel", fmt::format("The smoothed path leaves the travel of {}.",
                                                    machine_->joint(joint).axis.text()));
  return q;
}

Vector3d AxisMotion::tipAt(const nc::AxisValues& values) const {
  return tipOf(*machine_, values, tool_centre_point_);
}

double AxisMotion::boundBend(const nc::AxisValues& a, const nc::AxisValues& b) const {
  if (tool_centre_point_ || rotary_.empty()) return 0.0;
  double turns = 0.0;
  double slides = 0.0;
  for (int i = 0; i < machine_->jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    (machine_->isRotary(i) ? turns : slides) += std::abs(b[k] - a[k]);
  }
  if (turns > 0.5) return std::numeric_limits<double>::infinity();
  // A lever changes by the turns times a lever, and by the slides, at most.
  const double lever = (largestLever(*machine_, a) + slides) / (1.0 - turns);
  return turns * turns * lever + 2.0 * turns * slides;
}

}  // namespace nineline::smoothing
