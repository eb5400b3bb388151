#include "core/errors/effect_catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/units.h"
#include "core/errors/effect_factory.h"
#include "core/errors/effect_makers.h"
#include "core/errors/nonparametric_effect.h"
#include "core/errors/parameter_file.h"
#include "core/errors/table_effects.h"

namespace nineline::errors {

namespace {

using kinematics::Machine;

/// "nut" means temp_nut_C; a name that ends in a unit of contract.md stands as it is.
std::string columnOf(std::string name) {
  for (const std::string_view ending : {"_1", "_kg", "_s", "_mm_min", "_um", "_mm", "_deg"}) {
    if (name.ends_with(ending)) return name;
  }
  if (!name.starts_with("temp_")) name = "temp_" + name;
  return name.ends_with("_C") ? name : name + "_C";
}

/// A text that stands beside the parameters or among them, bare or as {"value": …}.
std::string textOf(JsonReader& reader, std::string_view key) {
  std::string text = reader.stringOr(key, "");
  const Json* parameters = reader.json().find("parameters");
  const Json* value = parameters != nullptr ? parameters->find(key) : nullptr;
  if (!text.empty() || value == nullptr) return text;
  if (value->string() != nullptr) return *value->string();
  const Json* inner = value->find("value");
  return inner != nullptr && inner->string() != nullptr ? *inner->string() : text;
}

std::string standardSensor(const EffectSpec& spec, const AxisId& axis) {
  std::string name(spec.standard_sensor);
  if (const std::size_t place = name.find("{}"); place != std::string::npos) {
    name.replace(place, 2, axis.text());
  }
  return name;
}

Placement readPlacement(JsonReader& reader, const EffectSpec& spec, const Machine& machine, int joint,
                        const Component& component) {
  Placement placement{.joint = joint, .component = component};
  const bool rotary = machine.isRotary(joint);
  if (spec.sensors > 0) {
    const std::string sensor = textOf(reader, "sensor");
    const std::string second = textOf(reader, "sensor_2");
    placement.sensor = sensor.empty() ? standardSensor(spec, component.axis) : columnOf(sensor);
    if (!second.empty()) placement.sensor_2 = columnOf(second);
  }
  const std::string frame = reader.stringOr("frame", "moved");
  if (frame != "moved" && frame != "fixed") {
    reader.fail("frame", "model.frame", fmt::format("'frame' is '{}', expected 'moved' or 'fixed'.", frame));
  }
  placement.fixed_frame = frame == "fixed";
  const char* range_key = rotary ? "range_deg" : "range_mm";
  if (reader.has(range_key)) {
    const std::vector<double> range = reader.numbers(range_key, 2);
    if (!reader.failed()) {
      placement.range = rotary ? kinematics::Travel{radFromDeg(range[0]), radFromDeg(range[1])}
                               : kinematics::Travel{range[0], range[1]};
    }
  }
  if (const std::string along = reader.stringOr("along", ""); !along.empty()) {
    const std::optional<AxisId> axis = parseAxisId(along);
    placement.along = axis ? machine.find(*axis) : -1;
    if (placement.along < 0) {
      reader.fail("along", "model.joint",
                  fmt::format("the machine '{}' has no axis {}.", machine.id(), along));
    }
  }
  return placement;
}

Result<std::shared_ptr<Effect>> readParametric(JsonReader& reader, const EffectSpec& spec,
                                               const Machine& machine, int joint,
                                               const Component& component) {
  Placement placement = readPlacement(reader, spec, machine, joint, component);
  if (reader.failed()) return reader.error();
  if (Result<void> fits = checkPlacement(machine, spec, placement); !fits) {
    reader.fail(reader.has("component") ? "component" : "joint", "model.component", fits.error().text);
    return reader.error();
  }
  Result<std::vector<Parameter>> parameters = readParameters(reader, spec, unitChoice(machine, placement));
  if (!parameters) return parameters.error();
  Result<std::shared_ptr<Effect>> effect = makeShared(machine, spec, placement, *parameters);
  if (effect) return effect;
  reader.fail("parameters", "model.parameter", effect.error().text);
  return reader.error();
}

/// What `joint` alone means: its positioning, or the one component at which the effect acts.
std::optional<Component> standardComponent(JsonReader& reader, const Machine& machine, int joint,
                                           std::string_view effect) {
  const EffectSpec* spec = findEffectSpec(effect);
  const bool several = spec != nullptr && (spec->sites & (kLateral | kTilt)) != 0;
  std::vector<Component> found;
  if (spec != nullptr && !several) found = componentsOf(machine, joint, *spec);
  if (!found.empty()) return found.front();
  if (!several) return positioningOf(machine.joint(joint));
  reader.fail("component", "json.missing",
              fmt::format("'component' is missing, expected which error of axis {} the effect '{}' adds to.",
                          machine.joint(joint).axis.text(), effect));
  return std::nullopt;
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
  if (!component) component = standardComponent(reader, machine, index, effect);
  if (!component) return std::nullopt;
  if (!(component->axis == *axis)) {
    reader.fail("component", "model.component",
                fmt::format("component {} belongs to axis {}, but 'joint' is {}.", component->text(),
                            component->axis.text(), joint));
  } else if (effect == "table" ? component->location : !component->location && effect == "location") {
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
  if (id == "nonparametric") return NonparametricEffect::fromJson(reader, machine, joint, *component);
  if (id == "location") return LocationEffect::fromJson(reader, joint, *component);
  return readParametric(reader, *findEffectSpec(id), machine, joint, *component);
}

}  // namespace

std::vector<std::string> knownEffects() {
  std::vector<std::string> ids;
  for (const EffectSpec& spec : effectCatalogue()) {
    if (spec.kind != EffectKind::Measurement) ids.emplace_back(spec.id);
  }
  return ids;
}

Result<EffectPtr> effectFromJson(const Json& json, const std::string& source, std::size_t number,
                                 const Machine& machine) {
  JsonReader reader(json, source, fmt::format("effect {}", number));
  const std::string id = reader.string("effect");
  if (reader.failed()) return reader.error();
  if (const EffectSpec* spec = findEffectSpec(id); spec != nullptr && spec->kind == EffectKind::Measurement) {
    reader.fail("effect", "model.effect",
                fmt::format("'{}' is an error of a measurement and no part of a machine's model.", id));
    return reader.error();
  }
  const std::vector<std::string> known = knownEffects();
  if (std::find(known.begin(), known.end(), id) == known.end()) {
    reader.fail("effect", "model.effect",
                fmt::format("the effect '{}' is not known to this version, expected one of {}.", id,
                            fmt::join(known, ", ")));
    return reader.error();
  }
  Result<std::shared_ptr<Effect>> effect = readEffect(reader, machine, id);
  if (!effect) return effect.error();
  (*effect)->setActive(reader.booleanOr("active", (*effect)->isActive()));
  (*effect)->setProvenance({reader.stringOr("source", ""), reader.stringOr("when", "")});
  if (reader.failed()) return reader.error();
  return EffectPtr(std::move(*effect));
}

}  // namespace nineline::errors
