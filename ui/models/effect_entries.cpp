#include "ui/models/effect_entries.h"

#include <cmath>

#include "core/base/units.h"

namespace nineline::models {

namespace {

using errors::Component;
using kinematics::Machine;

constexpr std::size_t kNewLinearCount = 21;
constexpr std::size_t kNewRotaryCount = 24;
constexpr double kNewLinearLength = 400.0;  // mm, where the travel is not stated

std::string textOf(const Json& entry, const char* key) {
  const Json* found = entry.find(key);
  return found != nullptr && found->string() != nullptr ? *found->string() : std::string();
}

bool isEntryOf(const Json& entry, const Component& component) {
  if (textOf(entry, "effect") != (component.location ? "location" : "table")) return false;
  return errors::parseComponent(textOf(entry, "component")) == component;
}

std::string locationKey(const Component& component) {
  return component.isAngular() ? "value_arcsec" : "value_um";
}

}  // namespace

TableKeys tableKeys(const Component& component, const Machine& machine) {
  const int joint = machine.find(component.axis);
  const bool rotary = joint >= 0 && machine.isRotary(joint);
  return {rotary ? "start_deg" : "start_mm", rotary ? "spacing_deg" : "spacing_mm",
          component.isAngular() ? "values_arcsec" : "values_um"};
}

std::optional<std::size_t> findEntry(const Json& effects, const Component& component) {
  if (effects.items() == nullptr) return std::nullopt;
  for (std::size_t i = 0; i < effects.items()->size(); ++i) {
    if (isEntryOf((*effects.items())[i], component)) return i;
  }
  return std::nullopt;
}

std::vector<std::size_t> otherEntries(const Json& effects) {
  std::vector<std::size_t> others;
  if (effects.items() == nullptr) return others;
  for (std::size_t i = 0; i < effects.items()->size(); ++i) {
    const std::string id = textOf((*effects.items())[i], "effect");
    if (id != "table" && id != "location") others.push_back(i);
  }
  return others;
}

Json tableEntry(const Json& effects, const Component& component, const Machine& machine) {
  if (const auto index = findEntry(effects, component)) return (*effects.items())[*index];
  const int joint = machine.find(component.axis);
  const TableKeys keys = tableKeys(component, machine);
  const bool rotary = machine.isRotary(joint);
  const auto& travel = machine.joint(joint).travel;
  const std::size_t count = rotary ? kNewRotaryCount : kNewLinearCount;
  double start = 0.0;
  double spacing =
      rotary ? 360.0 / static_cast<double>(count) : kNewLinearLength / static_cast<double>(count - 1);
  if (travel && !rotary) {
    start = travel->low;
    spacing = (travel->high - travel->low) / static_cast<double>(count - 1);
  } else if (travel) {
    start = degFromRad(travel->low);
    spacing = degFromRad(travel->high - travel->low) / static_cast<double>(count - 1);
  }
  Json entry = Json::object();
  entry.set("effect", "table");
  entry.set("joint", component.axis.text());
  entry.set("component", component.text());
  entry.set(keys.start, start);
  entry.set(keys.spacing, spacing);
  entry.set(keys.values, Json(Json::Array(count, Json(0.0))));
  entry.set("interpolation", "cubic");
  entry.set("source", "typed in");
  return entry;
}

Json withCount(Json entry, const TableKeys& keys, std::size_t count) {
  const Json* found = entry.find(keys.values);
  Json::Array values = found != nullptr && found->items() != nullptr ? *found->items() : Json::Array{};
  values.resize(count, Json(0.0));
  entry.set(keys.values, Json(std::move(values)));
  return entry;
}

Json withEntry(Json effects, const Component& component, Json entry) {
  if (const auto index = findEntry(effects, component)) {
    (*effects.items())[*index] = std::move(entry);
  } else {
    effects.push(std::move(entry));
  }
  return effects;
}

Json withoutEntry(Json effects, const Component& component) {
  if (const auto index = findEntry(effects, component)) return withoutEntryAt(std::move(effects), *index);
  return effects;
}

Json withEntryAt(Json effects, std::size_t index, Json entry) {
  NL_EXPECTS(effects.items() != nullptr && index < effects.items()->size(), index);
  (*effects.items())[index] = std::move(entry);
  return effects;
}

Json withoutEntryAt(Json effects, std::size_t index) {
  NL_EXPECTS(effects.items() != nullptr && index < effects.items()->size(), index);
  effects.items()->erase(effects.items()->begin() + static_cast<std::ptrdiff_t>(index));
  return effects;
}

Json effectsFor(const Machine& machine, const Json& effects) {
  Json kept = Json::array();
  if (effects.items() == nullptr) return kept;
  for (const Json& entry : *effects.items()) {
    const auto component = errors::parseComponent(textOf(entry, "component"));
    const auto joint = parseAxisId(textOf(entry, "joint"));
    const std::optional<AxisId> axis =
        joint ? joint : (component ? std::optional(component->axis) : std::nullopt);
    if (axis && machine.find(*axis) >= 0) kept.push(entry);
  }
  return kept;
}

Json withLocation(Json effects, const Component& component, const Json& value) {
  if (value.isNull()) return withoutEntry(std::move(effects), component);
  Json entry = Json::object();
  if (const auto index = findEntry(effects, component)) {
    entry = (*effects.items())[*index];
  } else {
    entry.set("effect", "location");
    entry.set("component", component.text());
    entry.set("source", "typed in");
  }
  entry.set(locationKey(component), value);
  return withEntry(std::move(effects), component, std::move(entry));
}

Json locationValue(const Json& effects, const Component& component) {
  const auto index = findEntry(effects, component);
  if (!index) return {};
  const Json* value = (*effects.items())[*index].find(locationKey(component));
  return value != nullptr ? *value : Json();
}

Json newEffect(const std::string& id, const Machine& machine, int joint) {
  Json parameters = Json::object();
  const bool rotary = machine.isRotary(joint);
  if (id == "scale") parameters.set("k", 0.0);
  if (id == "backlash") parameters.set("width", 0.0);
  if (id == "cyclic") {
    parameters.set("amplitude", 0.0);
    parameters.set("period", rotary ? 360.0 : 10.0);
    parameters.set("phase", 0.0);
  }
  if (id == "thermal_screw") {
    parameters.set("k", 0.0);
    parameters.set("q_fixed", 0.0);
  }
  Json entry = Json::object();
  entry.set("effect", id);
  entry.set("joint", machine.joint(joint).axis.text());
  entry.set("parameters", std::move(parameters));
  entry.set("source", "typed in");
  return entry;
}

Json withParameter(Json entry, const std::string& name, const Json& value) {
  const Json* found = entry.find("parameters");
  Json parameters = found != nullptr && found->members() != nullptr ? *found : Json::object();
  const Json* old = parameters.find(name);
  if (old != nullptr && old->members() != nullptr) {
    Json kept = *old;
    kept.set("value", value);
    parameters.set(name, std::move(kept));
  } else {
    parameters.set(name, value);
  }
  entry.set("parameters", std::move(parameters));
  return entry;
}

Json parameterOf(const Json& entry, const std::string& name) {
  const Json* parameters = entry.find("parameters");
  const Json* found = parameters != nullptr ? parameters->find(name) : nullptr;
  if (found == nullptr) return {};
  if (found->members() == nullptr) return *found;
  const Json* value = found->find("value");
  return value != nullptr ? *value : Json();
}

}  // namespace nineline::models
