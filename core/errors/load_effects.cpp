#include "core/errors/load_effects.h"

#include <cmath>

#include "core/base/units.h"

namespace nineline::errors {

namespace {

constexpr double kPiecesOfABeam = 16.0;
constexpr double kBeamPeak = 16.0;  // 1 / (ζ²(1 − ζ)²) in the middle

}  // namespace

LoadEffect::LoadEffect(const EffectParts& parts) : ScalarEffect(parts), k_(parts.value("k")) {
  if (parts.spec.id != "workpiece_bending") return;
  between_ = parts.placement.range ? parts.placement.range : parts.joint().travel;
  NL_EXPECTS(between_.has_value());
}

double LoadEffect::featureLength() const {
  return between_ ? (between_->high - between_->low) / kPiecesOfABeam
                  : std::numeric_limits<double>::infinity();
}

double LoadEffect::amplitude(const MachineState& state, std::span<const double>) const {
  const double full = k_ * state.load.value_or(0.0);
  if (!between_) return full;
  const double z = (position(state) - between_->low) / (between_->high - between_->low);
  if (z <= 0.0 || z >= 1.0) return 0.0;
  const double arch = z * (1.0 - z);
  return full * kBeamPeak * arch * arch;
}

double LoadEffect::amplitudeSlope(const MachineState& state) const {
  if (!between_) return 0.0;
  const double length = between_->high - between_->low;
  const double z = (position(state) - between_->low) / length;
  if (z <= 0.0 || z >= 1.0) return 0.0;
  const double arch = z * (1.0 - z);
  return k_ * state.load.value_or(0.0) * kBeamPeak * 2.0 * arch * (1.0 - 2.0 * z) / length;
}

WearEffect::WearEffect(const EffectParts& parts) : ScalarEffect(parts), rate_(parts.value("rate")) {
  if (parts.has("passes")) passes_ = parts.value("passes");
}

double WearEffect::amplitude(const MachineState& state, std::span<const double>) const {
  const double pass = state.pass.value_or(0.0);
  return rate_ * (passes_ ? -*passes_ * std::expm1(-pass / *passes_) : pass);
}

DeflectionEffect::DeflectionEffect(const EffectParts& parts) : ScalarEffect(parts), k_(parts.value("k")) {
  if (parts.has("passes")) passes_ = parts.value("passes");
}

std::vector<std::string> DeflectionEffect::needs() const {
  std::vector<std::string> names{placement().sensor};
  if (passes_) names.emplace_back("pass_1");
  return names;
}

double DeflectionEffect::amplitude(const MachineState& state, std::span<const double>) const {
  std::optional<double> cause = state.condition(placement().sensor);
  if (cause && placement().sensor.ends_with("_mm_min")) cause = perSecondFromPerMinute(*cause);
  const double fade = passes_ ? std::exp(-state.pass.value_or(0.0) / *passes_) : 1.0;
  return k_ * cause.value_or(0.0) * fade;
}

}  // namespace nineline::errors
