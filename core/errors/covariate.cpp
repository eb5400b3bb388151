#include "core/errors/covariate.h"

#include "core/base/units.h"

namespace nineline::errors {

Covariate::Covariate(const kinematics::Machine& machine, std::string name) : name_(std::move(name)) {
  for (int i = 0; i < machine.jointCount() && joint_ < 0; ++i) {
    const std::string letter = machine.joint(i).axis.text();
    const std::string unit = machine.isRotary(i) ? "_deg" : "_mm";
    if (name_ == letter + unit) {
      kind_ = Kind::Position;
    } else if (name_ == "approach_" + letter + "_1") {
      kind_ = Kind::Approach;
    } else if (name_ == "v_" + letter + unit + "_min") {
      kind_ = Kind::Velocity;
    } else {
      continue;
    }
    joint_ = i;
    rotary_ = machine.isRotary(i);
  }
}

std::optional<double> Covariate::value(const MachineState& state) const {
  const auto k = static_cast<std::size_t>(joint_ < 0 ? 0 : joint_);
  switch (kind_) {
    case Kind::Position:
      return state.q[k] * unitsPerPosition();
    case Kind::Approach:
      return static_cast<double>(state.approach[k]);
    case Kind::Velocity:
      if (!state.velocity) return std::nullopt;
      return perMinuteFromPerSecond((*state.velocity)[k]) * unitsPerPosition();
    case Kind::Condition:
      break;
  }
  return state.condition(name_);
}

}  // namespace nineline::errors
