#include "core/errors/effect_spec.h"

#include <algorithm>
#include <iterator>

#include "core/base/units.h"
#include "core/errors/effect_specs.h"

namespace nineline::errors {

namespace {

constexpr double kMillimetresPerMetre = 1e3;
constexpr double kSecondsPerHour = 3600.0;
constexpr double kSecondsPerMillisecond = 1e-3;

std::vector<EffectSpec> allSpecs() {
  std::vector<EffectSpec> all;
  for (auto part : {&positionSpecs, &rotarySpecs, &reversalSpecs, &dynamicSpecs, &thermalSpecs, &loadSpecs,
                    &measurementSpecs}) {
    std::vector<EffectSpec> specs = part();
    std::move(specs.begin(), specs.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace

const ParameterSpec* EffectSpec::find(std::string_view name) const {
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [name](const ParameterSpec& one) { return one.name == name; });
  return found == parameters.end() ? nullptr : &*found;
}

bool EffectSpec::isActiveByDefault() const { return kind == EffectKind::Machine && id != "nonparametric"; }

bool EffectSpec::isCorrectable() const {
  const bool by_motion = (covariates & (kVelocity | kAcceleration)) != 0;
  return kind != EffectKind::Measurement && id != "vibration" && id != "reversal_spike" && !by_motion;
}

const std::vector<EffectSpec>& effectCatalogue() {
  static const std::vector<EffectSpec> kAll = allSpecs();
  return kAll;
}

const EffectSpec* findEffectSpec(std::string_view id) {
  const std::vector<EffectSpec>& all = effectCatalogue();
  const auto found =
      std::find_if(all.begin(), all.end(), [id](const EffectSpec& one) { return one.id == id; });
  return found == all.end() ? nullptr : &*found;
}

std::string_view unitOf(Quantity quantity, const UnitChoice& choice) {
  const bool angular = choice.angular;
  const bool rotary = choice.rotary;
  switch (quantity) {
    case Quantity::Error:
      return angular ? "arcsec" : "um";
    case Quantity::Position:
      return rotary ? "deg" : "mm";
    case Quantity::Length:
      return "mm";
    case Quantity::Phase:
      return "deg";
    case Quantity::Ratio:
      return "um/m";
    case Quantity::Growth:
      return "um/m/C";
    case Quantity::Number:
      return "1";
    case Quantity::Frequency:
      return "Hz";
    case Quantity::Speed:
      return rotary ? "deg/s" : "mm/s";
    case Quantity::Delay:
      return "ms";
    case Quantity::Duration:
      return "s";
    case Quantity::PerAcceleration:
      return "um/(m/s²)";
    case Quantity::PerSpeed:
      if (choice.of_other_than_feed) return angular ? "arcsec/1" : "um/1";
      return angular ? "arcsec/(m/min)" : "um/(m/min)";
    case Quantity::PerTemperature:
      return angular ? "arcsec/C" : "um/C";
    case Quantity::Temperature:
      return "C";
    case Quantity::PerLoad:
      return angular ? "arcsec/kg" : "um/kg";
    case Quantity::PerHour:
      return angular ? "arcsec/h" : "um/h";
    case Quantity::PerPass:
      return angular ? "arcsec/pass" : "um/pass";
    case Quantity::PerArea:
      break;
  }
  return "um/m²";
}

double scaleOf(Quantity quantity, const UnitChoice& choice) {
  const bool rotary = choice.rotary;
  const double error = choice.angular ? radFromArcsec(1.0) : mmFromUm(1.0);
  switch (quantity) {
    case Quantity::Error:
    case Quantity::PerTemperature:
    case Quantity::PerLoad:
    case Quantity::PerPass:
      return error;
    case Quantity::Position:
    case Quantity::Speed:
      return rotary ? radFromDeg(1.0) : 1.0;
    case Quantity::Phase:
      return radFromDeg(1.0);
    case Quantity::Ratio:
    case Quantity::Growth:
    case Quantity::PerAcceleration:
      return mmFromUm(1.0) / kMillimetresPerMetre;
    case Quantity::Delay:
      return kSecondsPerMillisecond;
    case Quantity::PerSpeed:
      return choice.of_other_than_feed ? error : error / perSecondFromPerMinute(kMillimetresPerMetre);
    case Quantity::PerHour:
      return error / kSecondsPerHour;
    case Quantity::PerArea:
      return mmFromUm(1.0) / (kMillimetresPerMetre * kMillimetresPerMetre);
    case Quantity::Length:
    case Quantity::Number:
    case Quantity::Frequency:
    case Quantity::Duration:
    case Quantity::Temperature:
      break;
  }
  return 1.0;
}

}  // namespace nineline::errors
