#include "core/errors/parametric_effects.h"

#include <algorithm>

#include "core/errors/parameter_file.h"

namespace nineline::errors {

namespace {

const Parameter* findParameter(const std::vector<Parameter>& parameters, std::string_view name) {
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [name](const Parameter& one) { return one.name == name; });
  return found == parameters.end() ? nullptr : &*found;
}

Slot slotOf(const Placement& placement) {
  if (placement.component.location) return Slot::Located;
  return placement.fixed_frame ? Slot::Standing : Slot::Moved;
}

}  // namespace

bool EffectParts::has(std::string_view name) const { return findParameter(parameters, name) != nullptr; }

double EffectParts::value(std::string_view name) const {
  const Parameter* parameter = findParameter(parameters, name);
  const ParameterSpec* rule = spec.find(name);
  NL_EXPECTS(parameter != nullptr && rule != nullptr, name);
  return parameter->value * scaleOf(rule->quantity, unitChoice(machine, placement));
}

double EffectParts::valueOr(std::string_view name, double otherwise) const {
  return has(name) ? value(name) : otherwise;
}

ParametricEffect::ParametricEffect(EffectParts parts)
    : Effect(parts.placement.joint, parts.placement.component, slotOf(parts.placement)),
      spec_(parts.spec),
      placement_(std::move(parts.placement)),
      parameters_(std::move(parts.parameters)) {
  setActive(spec_.isActiveByDefault());
}

std::optional<double> ParametricEffect::velocity(const MachineState& state) const {
  if (!state.velocity) return std::nullopt;
  return (*state.velocity)[static_cast<std::size_t>(joint())];
}

Json ParametricEffect::toJson(const kinematics::Machine& machine) const {
  const bool rotary = machine.isRotary(joint());
  Json json = Json::object();
  json.set("effect", id())
      .set("joint", machine.joint(joint()).axis.text())
      .set("component", component().text())
      .set("parameters", parametersToJson(parameters_));
  if (!placement_.sensor.empty()) json.set("sensor", placement_.sensor);
  if (!placement_.sensor_2.empty()) json.set("sensor_2", placement_.sensor_2);
  if (placement_.fixed_frame) json.set("frame", "fixed");
  if (placement_.along >= 0) json.set("along", machine.joint(placement_.along).axis.text());
  if (placement_.range) {
    const auto shown = [rotary](double value) { return rotary ? degFromRad(value) : value; };
    json.set(rotary ? "range_deg" : "range_mm",
             Json(Json::Array{Json(shown(placement_.range->low)), Json(shown(placement_.range->high))}));
  }
  return json;
}

ScalarEffect::ScalarEffect(EffectParts parts)
    : ParametricEffect(parts), unit_(unitMotion(parts.joint(), parts.placement.component)) {}

void ScalarEffect::addMotion(const MachineState& state, std::span<const double> memory,
                             SmallMotion& sum) const {
  addScaled(amplitude(state, memory), unit_, sum);
}

void ScalarEffect::addSlope(const MachineState& state, SmallMotion& sum) const {
  addScaled(amplitudeSlope(state), unit_, sum);
}

}  // namespace nineline::errors
