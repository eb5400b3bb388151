#include "core/errors/thermal_effects.h"

#include <algorithm>
#include <cmath>

namespace nineline::errors {

namespace {

constexpr double kReferenceTemperature = 20.0;  // °C, ISO 1
constexpr double kPiecesOfAGradient = 8.0;

/// (1 − e^(−x)) / x, for x ≥ 0.
double meanOfDecay(double x) { return x < 1e-12 ? 1.0 : -std::expm1(-x) / x; }

}  // namespace

GrowthEffect::GrowthEffect(const EffectParts& parts)
    : ScalarEffect(parts), k_(parts.value("k")), fixed_(parts.valueOr("q_fixed", 0.0)) {
  if (parts.has("preload")) preload_ = parts.value("preload");
  if (parts.placement.sensor_2.empty()) return;
  const std::optional<kinematics::Travel>& travel =
      parts.placement.range ? parts.placement.range : parts.joint().travel;
  NL_EXPECTS(travel.has_value());
  range_ = *travel;
}

std::vector<std::string> GrowthEffect::needs() const {
  if (placement().sensor_2.empty()) return {placement().sensor};
  return {placement().sensor, placement().sensor_2};
}

double GrowthEffect::featureLength() const {
  return placement().sensor_2.empty() ? std::numeric_limits<double>::infinity()
                                      : (range_.high - range_.low) / kPiecesOfAGradient;
}

std::optional<std::pair<double, double>> GrowthEffect::excess(const MachineState& state) const {
  const std::optional<double> low = state.condition(placement().sensor);
  const std::optional<double> high =
      placement().sensor_2.empty() ? low : state.condition(placement().sensor_2);
  if (!low || !high) return std::nullopt;
  const auto above = [this](double temperature) {
    return preload_ ? std::max(0.0, temperature - *preload_) : temperature - kReferenceTemperature;
  };
  return std::pair(above(*low), above(*high));
}

double GrowthEffect::amplitudeSlope(const MachineState& state) const {
  const auto ends = excess(state);
  if (!ends) return 0.0;
  if (placement().sensor_2.empty()) return k_ * ends->first;
  const double x = (position(state) - range_.low) / (range_.high - range_.low);
  return k_ * std::lerp(ends->first, ends->second, x);
}

double GrowthEffect::amplitude(const MachineState& state, std::span<const double>) const {
  const auto ends = excess(state);
  if (!ends) return 0.0;
  const double travel = position(state) - fixed_;
  if (placement().sensor_2.empty()) return k_ * ends->first * travel;
  // The integral of a straight line is its value in the middle times the length.
  const double x = (0.5 * (position(state) + fixed_) - range_.low) / (range_.high - range_.low);
  return k_ * travel * std::lerp(ends->first, ends->second, x);
}

LagEffect::LagEffect(const EffectParts& parts)
    : ScalarEffect(parts),
      k_(parts.value("k")),
      tau_(parts.valueOr("tau", 0.0)),
      zero_(parts.placement.sensor.ends_with("_C") ? kReferenceTemperature : 0.0) {}

std::optional<double> LagEffect::input(const MachineState& state) const {
  const std::optional<double> value = state.condition(placement().sensor);
  return value ? std::optional(*value - zero_) : std::nullopt;
}

double LagEffect::amplitude(const MachineState& state, std::span<const double> memory) const {
  return k_ * (memory.empty() ? input(state).value_or(0.0) : memory[0]);
}

void LagEffect::start(const MachineState& state, std::span<double> memory) const {
  memory[0] = input(state).value_or(0.0);
}

void LagEffect::advance(const MachineState& from, const MachineState& to, std::span<double> memory) const {
  const std::optional<double> before = input(from);
  const std::optional<double> after = input(to);
  if (!after) return;
  if (!before || tau_ <= 0.0 || !from.time || !to.time) {
    memory[0] = *after;
    return;
  }
  const double x = std::max(0.0, *to.time - *from.time) / tau_;
  memory[0] = *after - (*after - *before) * meanOfDecay(x) + (memory[0] - *before) * std::exp(-x);
}

std::vector<std::string> DifferenceEffect::needs() const {
  if (placement().sensor_2.empty()) return {placement().sensor};
  return {placement().sensor, placement().sensor_2};
}

double DifferenceEffect::amplitude(const MachineState& state, std::span<const double>) const {
  const std::optional<double> first = state.condition(placement().sensor);
  const std::optional<double> second = placement().sensor_2.empty() ? std::optional(kReferenceTemperature)
                                                                    : state.condition(placement().sensor_2);
  return first && second ? k_ * (*first - *second) : 0.0;
}

}  // namespace nineline::errors
