#include "core/errors/reading_effect.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/errors/effect_factory.h"

namespace nineline::errors {

namespace {

constexpr double kReferenceTemperature = 20.0;  // °C
constexpr double kReferencePressure = 1013.25;  // hPa
constexpr double kAirByTemperature = 0.93e-6;  // 1/°C: what the length grows that a laser reads in warmer air
constexpr double kAirByPressure = -0.27e-6;    // 1/hPa
constexpr double kContacts = 3.0;              // of a touch probe

const Parameter* findParameter(std::span<const Parameter> parameters, std::string_view name) {
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [name](const Parameter& one) { return one.name == name; });
  return found == parameters.end() ? nullptr : &*found;
}

}  // namespace

/// One formula for each id of the table, discovery.md rows 53–62.
struct ReadingEffect::Formulas {
  static double cosine(const ReadingEffect& effect, const ReadingContext& context) {
    return -effect.value("k") * effect.travel(context);
  }

  /// Relative change of the air's optical length, against given conditions.
  static std::optional<double> air(const ReadingEffect& effect, const MachineState& state) {
    const std::optional<double> temperature = state.condition(effect.placement_.sensor);
    const std::optional<double> pressure = effect.placement_.sensor_2.empty()
                                               ? std::optional(kReferencePressure)
                                               : state.condition(effect.placement_.sensor_2);
    if (!temperature || !pressure) return std::nullopt;
    return kAirByTemperature * (*temperature - kReferenceTemperature) +
           kAirByPressure * (*pressure - kReferencePressure);
  }

  static double deadPath(const ReadingEffect& effect, const ReadingContext& context) {
    const std::optional<double> now = air(effect, context.state);
    const std::optional<double> before = air(effect, context.start);
    return now && before ? effect.value("k") * (*now - *before) : 0.0;
  }

  static double airWavelength(const ReadingEffect& effect, const ReadingContext& context) {
    return effect.value("k") * effect.travel(context) * air(effect, context.state).value_or(0.0);
  }

  static double material(const ReadingEffect& effect, const ReadingContext& context) {
    const std::optional<double> temperature = context.state.condition(effect.placement_.sensor);
    if (!temperature) return 0.0;
    return effect.value("k") * (*temperature - kReferenceTemperature) * effect.travel(context);
  }

  static double lobing(const ReadingEffect& effect, const ReadingContext& context) {
    if (!context.direction) return 0.0;
    return effect.value("amplitude") * std::cos(kContacts * *context.direction + effect.value("phase"));
  }

  static double stylus(const ReadingEffect& effect, const ReadingContext& context) {
    if (effect.placement_.joint < 0) return 0.0;
    return 0.5 * effect.value("shift") *
           context.state.approach[static_cast<std::size_t>(effect.placement_.joint)];
  }

  static double datum(const ReadingEffect& effect, const ReadingContext& context) {
    return context.state.time && *context.state.time >= effect.value("time") ? effect.value("shift") : 0.0;
  }

  static double clock(const ReadingEffect& effect, const ReadingContext& context) {
    return effect.value("tau") * context.rate.value_or(0.0);
  }

  static double arm(const ReadingEffect& effect, const ReadingContext& context) {
    const Eigen::Vector3d distance = effect.value("k") * Eigen::Vector3d::Unit(effect.placement_.row);
    return context.rotation.cross(distance).dot(context.sensitive);
  }

  static Formula of(std::string_view id) {
    static constexpr std::array<std::pair<std::string_view, Formula>, 9> kAll{
        {{"cosine", &cosine},
         {"dead_path", &deadPath},
         {"material_temperature", &material},
         {"air_wavelength", &airWavelength},
         {"probe_lobing", &lobing},
         {"stylus_radius", &stylus},
         {"datum_shift", &datum},
         {"time_shift", &clock},
         {"wrong_arm", &arm}}};
    const auto* found =
        std::find_if(kAll.begin(), kAll.end(), [id](const auto& one) { return one.first == id; });
    return found == kAll.end() ? nullptr : found->second;
  }
};

ReadingEffect::ReadingEffect(const EffectSpec& spec, ReadingPlacement placement,
                             std::vector<Parameter> parameters)
    : spec_(&spec),
      placement_(std::move(placement)),
      parameters_(std::move(parameters)),
      formula_(Formulas::of(spec.id)) {}

Result<ReadingEffect> ReadingEffect::make(const EffectSpec& spec, ReadingPlacement placement,
                                          std::span<const Parameter> values) {
  if (Formulas::of(spec.id) == nullptr) {
    return badInput("effect.placement", fmt::format("'{}' is no error of a measurement.", spec.id));
  }
  if (spec.sensors > 0 && placement.sensor.empty()) {
    return badInput("effect.placement", fmt::format("'{}' needs the column that it follows.", spec.id));
  }
  if (placement.row < 0 || placement.row > 2)
    return badInput("effect.placement", "the direction is none of x y z.");
  Result<std::vector<Parameter>> parameters = completeParameters(spec, unitChoice(placement), values);
  if (!parameters) return parameters.error();
  for (const ParameterSpec& rule : spec.parameters) {
    const Parameter* one = findParameter(*parameters, rule.name);
    if (rule.sign > 0 && one != nullptr && one->value < 0.0) {
      return badInput("effect.value",
                      fmt::format("'{}' of '{}' is {}, expected 0 or more.", rule.name, spec.id, one->value));
    }
  }
  return ReadingEffect(spec, std::move(placement), std::move(*parameters));
}

double ReadingEffect::value(std::string_view name) const {
  const Parameter* parameter = findParameter(parameters_, name);
  const ParameterSpec* rule = spec_->find(name);
  NL_EXPECTS(parameter != nullptr && rule != nullptr, name);
  return parameter->value * scaleOf(rule->quantity, unitChoice(placement_));
}

double ReadingEffect::travel(const ReadingContext& context) const {
  if (placement_.joint < 0) return 0.0;
  const auto k = static_cast<std::size_t>(placement_.joint);
  return context.state.q[k] - context.start.q[k];
}

double ReadingEffect::addition(const ReadingContext& context) const { return formula_(*this, context); }

std::vector<std::string> ReadingEffect::needs() const {
  std::vector<std::string> names;
  if (!placement_.sensor.empty()) names.push_back(placement_.sensor);
  if (!placement_.sensor_2.empty()) names.push_back(placement_.sensor_2);
  if ((spec_->covariates & kTime) != 0) names.emplace_back("t_s");
  return names;
}

UnitChoice unitChoice(const ReadingPlacement& placement) { return {.angular = placement.angular}; }

Result<std::vector<ReadingEffect>> readingBasis(const EffectSpec& spec, const ReadingPlacement& placement,
                                                std::span<const Parameter> nonlinear) {
  std::vector<ReadingEffect> basis;
  for (const auto& values : unitParameters(spec, unitChoice(placement), nonlinear)) {
    Result<ReadingEffect> effect = ReadingEffect::make(spec, placement, values);
    if (!effect) return effect.error();
    basis.push_back(std::move(*effect));
  }
  return basis;
}

}  // namespace nineline::errors
