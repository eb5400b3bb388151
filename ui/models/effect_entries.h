#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/json.h"
#include "core/errors/component.h"
#include "core/kinematics/machine.h"

/// The entries of a model's `effects` as they are typed: JSON, so that a bad value keeps its place.
namespace nineline::models {

/// Names of the keys of a table entry: they carry the unit.
struct TableKeys {
  std::string start, spacing, values;
};
[[nodiscard]] TableKeys tableKeys(const errors::Component& component, const kinematics::Machine& machine);

/// Index of the table (or location) entry of a component; nothing where there is none.
[[nodiscard]] std::optional<std::size_t> findEntry(const Json& effects, const errors::Component& component);
/// Indices of the entries that are neither tables nor location errors.
[[nodiscard]] std::vector<std::size_t> otherEntries(const Json& effects);

/// The entry of a component, or a new one: zero values over the travel (linear) or a turn (rotary).
[[nodiscard]] Json tableEntry(const Json& effects, const errors::Component& component,
                              const kinematics::Machine& machine);
/// `count` values, kept where they exist, zero where they are new.
[[nodiscard]] Json withCount(Json entry, const TableKeys& keys, std::size_t count);

[[nodiscard]] Json withEntry(Json effects, const errors::Component& component, Json entry);
[[nodiscard]] Json withoutEntry(Json effects, const errors::Component& component);
[[nodiscard]] Json withEntryAt(Json effects, std::size_t index, Json entry);
[[nodiscard]] Json withoutEntryAt(Json effects, std::size_t index);

/// The entries whose joint the machine has; choosing another machine drops the others.
[[nodiscard]] Json effectsFor(const kinematics::Machine& machine, const Json& effects);

/// A location entry; a null value removes it.
[[nodiscard]] Json withLocation(Json effects, const errors::Component& component, const Json& value);
[[nodiscard]] Json locationValue(const Json& effects, const errors::Component& component);

/// A new entry of one of the parametric effects, on the joint's own positioning.
[[nodiscard]] Json newEffect(const std::string& id, const kinematics::Machine& machine, int joint);
/// Sets one parameter of an entry, keeping its sigma and unit.
[[nodiscard]] Json withParameter(Json entry, const std::string& name, const Json& value);
[[nodiscard]] Json parameterOf(const Json& entry, const std::string& name);

}  // namespace nineline::models
