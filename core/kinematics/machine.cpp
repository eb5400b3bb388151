#include "core/kinematics/machine.h"

#include <fmt/format.h>

#include <cmath>

namespace nineline::kinematics {

namespace {

constexpr double kTravelSlack = 1e-9;

Result<void> normalise(Vector3d& direction, const std::string& of) {
  const double length = direction.norm();
  if (!std::isfinite(length) || std::abs(length - 1.0) > 1e-3) {
    return badInput(
        "machine.direction",
        fmt::format("The direction of {} has length {:.6g}, expected a unit vector.", of, length));
  }
  direction /= length;
  return {};
}

Result<void> checkJoint(Joint& joint) {
  const std::string name = joint.axis.text();
  if (!isAxisLetter(joint.axis.letter)) {
    return badInput(
        "machine.axis",
        fmt::format("'{}' is no axis name, expected one of X Y Z U V W A B C, with a digit where it repeats.",
                    name));
  }
  if (Result<void> unit = normalise(joint.direction, "axis " + name); !unit) return unit;
  if (!joint.offset.allFinite())
    return badInput("machine.offset", fmt::format("The offset of axis {} is not finite.", name));
  if (joint.continuous && joint.type == JointType::Linear) {
    return badInput("machine.continuous", fmt::format("Axis {} is linear and cannot be continuous.", name));
  }
  if (joint.diameter && joint.type == JointType::Rotary) {
    return badInput("machine.diameter", fmt::format("Axis {} is rotary and has no diameter words.", name));
  }
  if (joint.rapid_speed && !(*joint.rapid_speed > 0.0 && std::isfinite(*joint.rapid_speed))) {
    return badInput("machine.rapid", fmt::format("The rapid speed of axis {} is not above 0.", name));
  }
  if (joint.travel && !(joint.travel->low < joint.travel->high)) {
    return badInput(
        "machine.travel",
        fmt::format(
            "The travel of axis {} ends where it starts or below: its lower end must be below its upper end.",
            name));
  }
  return {};
}

}  // namespace

Result<Machine> Machine::make(Description description) {
  Machine machine;
  machine.id_ = std::move(description.id);
  machine.name_ = std::move(description.name);
  machine.workpiece_joints_ = static_cast<int>(description.workpiece_chain.size());
  machine.joints_ = std::move(description.workpiece_chain);
  machine.joints_.insert(machine.joints_.end(), description.tool_chain.begin(), description.tool_chain.end());
  machine.tool_tip_ = description.tool_tip;
  machine.tool_axis_ = description.tool_axis;
  if (machine.joints_.empty() || machine.joints_.size() > kMaxAxes) {
    return badInput("machine.joints",
                    fmt::format("A machine has 1 to {} axes, found {}.", kMaxAxes, machine.joints_.size()));
  }
  for (std::size_t i = 0; i < machine.joints_.size(); ++i) {
    if (Result<void> fine = checkJoint(machine.joints_[i]); !fine) return fine.error();
    for (std::size_t k = 0; k < i; ++k) {
      if (machine.joints_[k].axis == machine.joints_[i].axis) {
        return badInput("machine.axis", fmt::format("Axis {} occurs twice; give one of them a digit.",
                                                    machine.joints_[i].axis.text()));
      }
    }
  }
  if (Result<void> unit = normalise(machine.tool_axis_, "the tool"); !unit) return unit.error();
  if (!machine.tool_tip_.allFinite()) return badInput("machine.tool", "The tool tip is not finite.");
  return machine;
}

int Machine::find(AxisId axis) const {
  for (int i = 0; i < jointCount(); ++i) {
    if (joint(i).axis == axis) return i;
  }
  return -1;
}

int Machine::firstOutsideTravel(const JointPositions& q) const {
  for (int i = 0; i < jointCount(); ++i) {
    const std::optional<Travel>& travel = joint(i).travel;
    const double position = q[static_cast<std::size_t>(i)];
    if (!std::isfinite(position)) return i;
    if (travel && !joint(i).continuous &&
        (position < travel->low - kTravelSlack || position > travel->high + kTravelSlack))
      return i;
  }
  return -1;
}

Machine::Description Machine::description() const {
  Description result;
  result.id = id_;
  result.name = name_;
  const auto middle = joints_.begin() + workpiece_joints_;
  result.workpiece_chain.assign(joints_.begin(), middle);
  result.tool_chain.assign(middle, joints_.end());
  result.tool_tip = tool_tip_;
  result.tool_axis = tool_axis_;
  return result;
}

}  // namespace nineline::kinematics
