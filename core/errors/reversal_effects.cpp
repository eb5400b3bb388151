#include "core/errors/reversal_effects.h"

#include <algorithm>
#include <cmath>

namespace nineline::errors {

double BacklashEffect::amplitude(const MachineState& state, std::span<const double> memory) const {
  if (!memory.empty()) return memory[0];
  return -0.5 * width_ * approach(state);
}

double BacklashEffect::play() const { return std::abs(width_); }

void BacklashEffect::start(const MachineState& state, std::span<double> memory) const {
  memory[0] = amplitude(state, {});
}

void BacklashEffect::advance(const MachineState& from, const MachineState& to,
                             std::span<double> memory) const {
  if (approach(from) == 0.0) {  // nothing is known of the past: the first motion finds the play taken up
    memory[0] = amplitude(to, {});
    return;
  }
  // The offset follows the command backwards until an edge of the band is reached. A negative width is a
  // control that over-compensates: the mirror image.
  const double sense = width_ < 0.0 ? -1.0 : 1.0;
  const double half = 0.5 * std::abs(width_);
  memory[0] = sense * std::clamp(sense * memory[0] + position(from) - position(to), -half, half);
}

SideEffect::SideEffect(const EffectParts& parts)
    : ScalarEffect(parts),
      width_(parts.valueOr("width", 0.0)),
      per_position_(parts.valueOr("k", 0.0)),
      per_load_(parts.valueOr("kappa", 0.0)) {}

std::vector<std::string> SideEffect::needs() const {
  return spec().find("kappa") != nullptr ? std::vector<std::string>{"load_kg"} : std::vector<std::string>{};
}

double SideEffect::amplitude(const MachineState& state, std::span<const double>) const {
  const double width = width_ + per_position_ * position(state) + per_load_ * state.load.value_or(0.0);
  return -0.5 * width * approach(state);
}

double SideEffect::amplitudeSlope(const MachineState& state) const {
  return -0.5 * per_position_ * approach(state);
}

HysteresisEffect::HysteresisEffect(const EffectParts& parts)
    : ScalarEffect(parts), width_(parts.value("width")), length_(parts.value("length")) {}

double HysteresisEffect::amplitude(const MachineState& state, std::span<const double> memory) const {
  if (!memory.empty()) return memory[0];
  const double left = state.since_reversal
                          ? std::exp(-(*state.since_reversal)[static_cast<std::size_t>(joint())] / length_)
                          : 0.0;  // nothing is known of a reversal: equilibrium
  return -0.5 * width_ * approach(state) * (1.0 - 2.0 * left);
}

void HysteresisEffect::start(const MachineState& state, std::span<double> memory) const {
  memory[0] = amplitude(state, {});
}

void HysteresisEffect::advance(const MachineState& from, const MachineState& to,
                               std::span<double> memory) const {
  const double end = -0.5 * width_ * approach(to);
  const double left =
      approach(from) == 0.0 ? 0.0 : std::exp(-std::abs(position(to) - position(from)) / length_);
  memory[0] = end + (memory[0] - end) * left;
}

SpikeEffect::SpikeEffect(const EffectParts& parts)
    : ScalarEffect(parts), height_(parts.value("height")), length_(parts.value("length")) {}

double SpikeEffect::amplitude(const MachineState& state, std::span<const double>) const {
  if (!state.since_reversal) return 0.0;
  const bool stands = state.velocity && std::all_of(state.velocity->begin(), state.velocity->end(),
                                                    [](double speed) { return speed == 0.0; });
  if (stands) return 0.0;
  const double since = (*state.since_reversal)[static_cast<std::size_t>(joint())];
  return -height_ * approach(state) * std::exp(-since / length_);
}

FrictionEffect::FrictionEffect(const EffectParts& parts)
    : ScalarEffect(parts),
      width_(parts.valueOr("width", 0.0)),
      height_(parts.value("height")),
      speed_(parts.value("speed")) {}

double FrictionEffect::amplitude(const MachineState& state, std::span<const double>) const {
  const std::optional<double> speed = velocity(state);
  if (!speed) return 0.0;
  const double ratio = *speed / speed_;
  return -approach(state) * (0.5 * width_ + height_ * std::exp(-ratio * ratio));
}

}  // namespace nineline::errors
