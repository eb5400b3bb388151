#include "core/errors/dynamic_effects.h"

#include <cmath>

#include "core/base/units.h"

namespace nineline::errors {

double AccelerationEffect::amplitude(const MachineState& state, std::span<const double>) const {
  return state.acceleration ? k_ * (*state.acceleration)[static_cast<std::size_t>(joint())] : 0.0;
}

CounterweightEffect::CounterweightEffect(const EffectParts& parts)
    : ScalarEffect(parts), width_(parts.valueOr("width", 0.0)), k_(parts.valueOr("k", 0.0)) {}

double CounterweightEffect::amplitude(const MachineState& state, std::span<const double>) const {
  return -0.5 * width_ * approach(state) + k_ * velocity(state).value_or(0.0);
}

VibrationEffect::VibrationEffect(const EffectParts& parts)
    : ScalarEffect(parts),
      amplitude_(parts.value("amplitude")),
      rate_(kTurn * parts.value("frequency")),
      phase_(parts.valueOr("phase", 0.0)) {}

double VibrationEffect::amplitude(const MachineState& state, std::span<const double>) const {
  return state.time ? amplitude_ * std::sin(rate_ * *state.time + phase_) : 0.0;
}

}  // namespace nineline::errors
