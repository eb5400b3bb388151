#pragma once

#include "core/kinematics/inverse.h"

namespace nineline::simulation {

/// How much of a pose the joints of `free` (bit i: joint i) can hold: with two rotary and at least five
/// joints the tip and the tool axis, with rotary joints alone the whole orientation, otherwise the tip.
[[nodiscard]] kinematics::PoseTarget::Rotation solvableRotation(const kinematics::Machine& machine,
                                                                unsigned free);

/// A target that asks for as much of `pose` as `rotation` says.
[[nodiscard]] kinematics::PoseTarget targetOf(const kinematics::ToolPose& pose,
                                              kinematics::PoseTarget::Rotation rotation);

}  // namespace nineline::simulation
