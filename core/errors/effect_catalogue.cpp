#include "core/errors/effect_catalogue.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/errors/parametric_effects.h"
#include "core/errors/table_effects.h"

namespace nineline::errors {

namespace {

using kinematics::Machine;

/// A parameter of a known effect: its units for a linear and an angular component, and the value taken where
/// the file says nothing (absent: must be stated).
struct ParameterRule {
  std::string_view name;
  std::string_view linear_unit;
  std::string_view angular_unit;
  std::optional<double> otherwise;
};

struct EffectRule {
  std::string_view id;
  std::vector<ParameterRule> parameters;
  std::shared_ptr<Effect> (*make)(const Machine&, int, Component, std::vector<Parameter>, JsonReader&);
};

std::string sensorOf(JsonReader& reader, const Machine& machine, int joint) {
  const std::string standard = "temp_screw_" + machine.joint(joint).axis.text() + "_C";
  std::string sensor = reader.stringOr("sensor", "");
  if (const Json* parameters = reader.json().find("parameters"); sensor.empty() && parameters != nullptr) {
    if (const Json* value = parameters->find("sensor")) {
      if (value->string() != nullptr) sensor = *value->string();
      const Json* inner = value->find("value");
      if (inner != nullptr && inner->string() != nullptr) sensor = *inner->string();
    }
  }
  if (sensor.empty()) return standard;
  if (!sensor.starts_with("temp_")) sensor = "temp_" + sensor;
  return sensor.ends_with("_C") ? sensor : sensor + "_C";
}

template <typename T>
std::shared_ptr<Effect> makeEffect(const Machine& machine, int joint, Component component,
                                   std::vector<Parameter> parameters, JsonReader&) {
  return std::make_shared<T>(machine, joint, component, std::move(parameters));
}

std::shared_ptr<Effect> makeThermalScrew(const Machine& machine, int joint, Component component,
                                         std::vector<Parameter> parameters, JsonReader& reader) {
  return std::make_shared<ThermalScrewEffect>(machine, joint, component, std::move(parameters),
                                              sensorOf(reader, machine, joint));
}

const std::vector<EffectRule>& rules() {
  static const std::vector<EffectRule> kRules = {
      {"scale", {{"k", "um/m", "um/m", {}}}, &makeEffect<ScaleEffect>},
      {"cyclic",
       {{"amplitude", "um", "arcsec", {}}, {"period", "mm", "deg", {}}, {"phase", "deg", "deg", 0.0}},
       &makeEffect<CyclicEffect>},
      {"backlash", {{"width", "um", "arcsec", {}}}, &makeEffect<BacklashEffect>},
      {"thermal_screw", {{"k", "um/m/C", "um/m/C", {}}, {"q_fixed", "mm", "deg", 0.0}}, &makeThermalScrew},
  };
  return kRules;
}

std::optional<Parameter> readParameter(JsonReader& reader, const Json& all, const ParameterRule& rule,
                                       bool angular) {
  Parameter parameter{std::string(rule.name), std::string(angular ? rule.angular_unit : rule.linear_unit),
                      0.0, std::nullopt};
  const Json* json = all.find(rule.name);
  if (json == nullptr) {
    if (!rule.otherwise)
      reader.fail(
          "parameters", "model.parameter",
          fmt::format("parameter '{}' is missing, expected a number in {}.", rule.name, parameter.unit));
    parameter.value = rule.otherwise.value_or(0.0);
    return parameter;
  }
  if (json->number() != nullptr) {
    parameter.value = *json->number();
    return parameter;
  }
  JsonReader inner(*json, reader.source(), fmt::format("parameter '{}'", rule.name));
  parameter.value = inner.number("value");
  if (inner.has("sigma")) parameter.sigma = inner.number("sigma");
  const std::string unit = inner.stringOr("unit", parameter.unit);
  if (!inner.failed() && unit != parameter.unit) {
    inner.fail("unit", "model.unit", fmt::format("the unit is '{}', expected '{}'.", unit, parameter.unit));
  }
  if (inner.failed()) {
    reader.fail("parameters", inner.error().code, inner.error().text);
    return std::nullopt;
  }
  return parameter;
}

Result<std::shared_ptr<Effect>> readParametric(JsonReader& reader, const EffectRule& rule,
                                               const Machine& machine, int joint, Component component) {
  static const Json kNone = Json::object();
  const Json* all = reader.json().find("parameters");
  std::vector<Parameter> parameters;
  for (const ParameterRule& one : rule.parameters) {
    if (const auto parameter =
            readParameter(reader, all != nullptr ? *all : kNone, one, component.isAngular())) {
      parameters.push_back(*parameter);
    }
    if (reader.failed()) return reader.error();
    if (one.name == "period" && parameters.back().value <= 0.0) {
      reader.fail("parameters", "model.period",
                  fmt::format("the period is {}, expected a number above 0.", parameters.back().value));
      return reader.error();
    }
  }
  return rule.make(machine, joint, component, std::move(parameters), reader);
}

/// The joint and component of an entry: `component` alone is enough where it names the joint, `joint` alone
/// means the joint's positioning.
std::optional<Component> readComponent(JsonReader& reader, const Machine& machine, std::string_view effect) {
  std::optional<Component> component;
  if (reader.has("component")) {
    const std::string text = reader.string("component");
    component = parseComponent(text);
    if (!component && !reader.failed()) {
      reader.fail(
          "component", "model.component",
          fmt::format("'component' is '{}', expected a name of ISO 230-1 such as EZZ, EBX or B0X.", text));
    }
  } else if (!reader.has("joint") || effect == "table" || effect == "location") {
    reader.fail("component", "json.missing",
                "'component' is missing, expected a name of ISO 230-1 such as EZZ, EBX or B0X.");
  }
  if (reader.failed()) return std::nullopt;
  const std::string joint = reader.stringOr("joint", component ? component->axis.text() : "");
  const std::optional<AxisId> axis = parseAxisId(joint);
  const int index = axis ? machine.find(*axis) : -1;
  if (index < 0) {
    reader.fail(reader.has("joint") ? "joint" : "component", "model.joint",
                fmt::format("the machine '{}' has no axis {}.", machine.id(), joint));
    return std::nullopt;
  }
  if (!component) component = positioningOf(machine.joint(index));
  if (!(component->axis == *axis)) {
    reader.fail("component", "model.component",
                fmt::format("component {} belongs to axis {}, but 'joint' is {}.", component->text(),
                            component->axis.text(), joint));
  } else if (component->location != (effect == "location")) {
    reader.fail("component", "model.component",
                fmt::format("component {} does not fit the effect '{}'.", component->text(), effect));
  }
  return reader.failed() ? std::nullopt : component;
}

Result<std::shared_ptr<Effect>> readEffect(JsonReader& reader, const Machine& machine,
                                           const std::string& id) {
  const std::optional<Component> component = readComponent(reader, machine, id);
  if (!component) return reader.error();
  const int joint = machine.find(component->axis);
  if (id == "table") return TableEffect::fromJson(reader, machine, joint, *component);
  if (id == "location") return LocationEffect::fromJson(reader, joint, *component);
  for (const EffectRule& rule : rules()) {
    if (rule.id == id) return readParametric(reader, rule, machine, joint, *component);
  }
  return reader.error();
}

}  // namespace

std::vector<std::string> knownEffects() {
  std::vector<std::string> ids = {"table", "location"};
  for (const EffectRule& rule : rules()) ids.emplace_back(rule.id);
  return ids;
}

Result<EffectPtr> effectFromJson(const Json& json, const std::string& source, std::size_t number,
                                 const Machine& machine) {
  JsonReader reader(json, source, fmt::format("effect {}", number));
  const std::string id = reader.string("effect");
  if (reader.failed()) return reader.error();
  const std::vector<std::string> known = knownEffects();
  if (std::find(known.begin(), known.end(), id) == known.end()) {
    reader.fail("effect", "model.effect",
                fmt::format("the effect '{}' is not known to this version, expected one of {}.", id,
                            fmt::join(known, ", ")));
    return reader.error();
  }
  Result<std::shared_ptr<Effect>> effect = readEffect(reader, machine, id);
  if (!effect) return effect.error();
  (*effect)->setProvenance({reader.stringOr("source", ""), reader.stringOr("when", "")});
  if (reader.failed()) return reader.error();
  return EffectPtr(std::move(*effect));
}

}  // namespace nineline::errors
