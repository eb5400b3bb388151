#include "app/cli/thread_machine.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace nineline::cli {

namespace {

using kinematics::Joint;
using kinematics::Machine;
using thread_grinding::MachineLimits;

/// One of the axes that grind a thread, and the sense in which it moves the table (Z, C) or the wheel (X)
/// along its bed axis: +1 or -1.
struct GrindingAxis {
  const Joint* joint = nullptr;
  double sense = 1.0;
};

Result<GrindingAxis> findAxis(const Machine& machine, char letter, bool rotary, int bed_axis,
                              kinematics::Side home) {
  const int index = machine.find(AxisId{letter, 0});
  if (index < 0 || machine.isRotary(index) != rotary) {
    return badInput("thread.machine",
                    fmt::format("The machine '{}' has no {} axis {}, expected a thread grinder.",
                                machine.id(), rotary ? "rotary" : "linear", letter));
  }
  const Joint& joint = machine.joint(index);
  const double along = joint.direction[bed_axis];
  if (std::abs(std::abs(along) - 1.0) > 1e-9) {
    return badInput("thread.machine", fmt::format("Axis {} of the machine '{}' does not lie along {}.",
                                                  letter, machine.id(), bed_axis == 0 ? "x" : "z"));
  }
  const double side = machine.side(index) == home ? 1.0 : -1.0;
  return GrindingAxis{&joint, side * std::copysign(1.0, along)};
}

std::optional<MachineLimits::Range> rangeOf(const Joint& joint) {
  if (!joint.travel) return std::nullopt;
  return MachineLimits::Range{joint.travel->low, joint.travel->high};
}

}  // namespace

Result<void> takeLimits(const Machine& machine, thread_grinding::ThreadJob& job) {
  using kinematics::Side;
  const Result<GrindingAxis> x = findAxis(machine, 'X', false, 0, Side::Tool);
  if (!x) return x.error();
  const Result<GrindingAxis> z = findAxis(machine, 'Z', false, 2, Side::Workpiece);
  if (!z) return z.error();
  const Result<GrindingAxis> c = findAxis(machine, 'C', true, 2, Side::Workpiece);
  if (!c) return c.error();
  MachineLimits& limits = job.limits;
  if (!limits.x) limits.x = rangeOf(*x->joint);
  if (!limits.z) limits.z = rangeOf(*z->joint);
  if (!limits.z_speed) limits.z_speed = z->joint->rapid_speed;
  if (!limits.c_speed) limits.c_speed = c->joint->rapid_speed;
  thread_grinding::AxisConvention axes = job.parameters.axes;
  axes.x_sign = x->sense;
  axes.z_sign = z->sense;
  axes.c_sign = c->sense;
  axes.x_factor = x->joint->diameter ? 2.0 : 1.0;
  limits.axes = axes;
  return {};
}

}  // namespace nineline::cli
