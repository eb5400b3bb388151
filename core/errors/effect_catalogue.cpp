#include "core/errors/effect_catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/errors/parametric_effects.h"
#include "core/errors/table_effects.h"

namespace nineline::errors {

namespace {

using kinematics::Machine;

constexpr double kLargestError_um = 1000.0;
constexpr double kLargestError_arcsec = 2063.0;  // 0.01 rad
constexpr double kLargestRatio_um_m = 10000.0;
constexpr double kLargestGrowth_um_m_C = 1000.0;

/// What a parameter measures; with the component and the joint this decides its unit.
enum class Quantity {
  Error,     ///< of the component: um or arcsec
  Position,  ///< of the joint: mm or deg
  Phase,     ///< deg
  Ratio,     ///< um/m
  Growth     ///< um/m/C
};

/// A parameter of a known effect, and the value taken where the file says nothing (absent: must be stated).
struct ParameterRule {
  std::string_view name;
  Quantity quantity;
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
      {"scale", {{"k", Quantity::Ratio, {}}}, &makeEffect<ScaleEffect>},
      {"cyclic",
       {{"amplitude", Quantity::Error, {}},
        {"period", Quantity::Position, {}},
        {"phase", Quantity::Phase, 0.0}},
       &makeEffect<CyclicEffect>},
      {"backlash", {{"width", Quantity::Error, {}}}, &makeEffect<BacklashEffect>},
      {"thermal_screw",
       {{"k", Quantity::Growth, {}}, {"q_fixed", Quantity::Position, 0.0}},
       &makeThermalScrew},
  };
  return kRules;
}

const char* unitOf(Quantity quantity, bool angular, bool rotary) {
  switch (quantity) {
    case Quantity::Error:
      return angular ? "arcsec" : "um";
    case Quantity::Position:
      return rotary ? "deg" : "mm";
    case Quantity::Phase:
      return "deg";
    case Quantity::Ratio:
      return "um/m";
    case Quantity::Growth:
      break;
  }
  return "um/m/C";
}

/// Beyond this a value is a mistake of the unit (theory.md, 3.5).
double limitOf(std::string_view unit) {
  if (unit == "um") return kLargestError_um;
  if (unit == "arcsec") return kLargestError_arcsec;
  if (unit == "um/m") return kLargestRatio_um_m;
  if (unit == "um/m/C") return kLargestGrowth_um_m_C;
  return std::numeric_limits<double>::infinity();
}

void checkParameter(JsonReader& reader, std::string_view key, const Parameter& parameter) {
  if (std::abs(parameter.value) >= limitOf(parameter.unit)) {
    reader.fail(key, "model.size",
                fmt::format("parameter '{}' is {:.6g} {}, larger than any machine's (limit {}).",
                            parameter.name, parameter.value, parameter.unit, limitOf(parameter.unit)));
  }
  if (parameter.name == "period" && parameter.value <= 0.0) {
    reader.fail(key, "model.period",
                fmt::format("the period is {}, expected a number above 0.", parameter.value));
  }
  if (parameter.sigma && *parameter.sigma < 0.0) {
    reader.fail("sigma", "model.sigma", fmt::format("'sigma' is {}, expected 0 or more.", *parameter.sigma));
  }
}

/// `all`: the entry's member "parameters". A parameter is a number or an object with value, sigma and unit.
Result<Parameter> readParameter(JsonReader& all, const ParameterRule& rule, std::string unit) {
  Parameter parameter{std::string(rule.name), std::move(unit), rule.otherwise.value_or(0.0), std::nullopt};
  const Json* json = all.json().find(rule.name);
  if (json == nullptr) {
    if (rule.otherwise) return parameter;
    all.fail(rule.name, "model.parameter",
             fmt::format("'{}' is missing, expected a number in {}.", rule.name, parameter.unit));
    return all.error();
  }
  if (json->members() == nullptr) {
    parameter.value = all.number(rule.name);
    if (!all.failed()) checkParameter(all, rule.name, parameter);
    if (all.failed()) return all.error();
    return parameter;
  }
  JsonReader inner(*json, all.source(), fmt::format("parameter '{}'", rule.name));
  parameter.value = inner.number("value");
  if (inner.has("sigma")) parameter.sigma = inner.number("sigma");
  const std::string stated = inner.stringOr("unit", parameter.unit);
  if (!inner.failed() && stated != parameter.unit) {
    inner.fail("unit", "model.unit", fmt::format("the unit is '{}', expected '{}'.", stated, parameter.unit));
  }
  if (!inner.failed()) checkParameter(inner, "value", parameter);
  if (inner.failed()) return inner.error();
  return parameter;
}

Result<std::shared_ptr<Effect>> readParametric(JsonReader& reader, const EffectRule& rule,
                                               const Machine& machine, int joint, Component component) {
  static const Json kNone = Json::object();
  const Json* given = reader.json().find("parameters");
  JsonReader all(given != nullptr ? *given : kNone, reader.source(),
                 fmt::format("parameters of '{}'", rule.id));
  if (given == nullptr) {
    reader.fail("parameters", "json.missing", "'parameters' is missing, expected an object.");
    return reader.error();
  }
  if (all.failed()) return all.error();
  const bool rotary = machine.isRotary(joint);
  std::vector<Parameter> parameters;
  for (const ParameterRule& one : rule.parameters) {
    const bool per_length = one.quantity == Quantity::Ratio || one.quantity == Quantity::Growth;
    if (per_length && component.isAngular() != rotary) {
      reader.fail("component", "model.component",
                  fmt::format("'{}' in um/m has no meaning for {} of a {} axis.", rule.id, component.text(),
                              rotary ? "rotary" : "linear"));
      return reader.error();
    }
    Result<Parameter> parameter =
        readParameter(all, one, unitOf(one.quantity, component.isAngular(), rotary));
    if (!parameter) return parameter.error();
    parameters.push_back(std::move(*parameter));
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
