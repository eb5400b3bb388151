#include <algorithm>
#include <array>

#include "core/errors/reading_effect.h"
#include "core/errors/sensor_names.h"

namespace nineline::errors {

namespace {

/// Instruments whose readings may have an error; empty: any.
struct InstrumentRule {
  std::string_view id;
  std::array<std::string_view, 4> instruments;
};

constexpr std::array kRules{
    InstrumentRule{"cosine", {"laser-linear"}},
    InstrumentRule{"dead_path", {"laser-linear"}},
    InstrumentRule{"material_temperature", {"laser-linear"}},
    InstrumentRule{"air_wavelength", {"laser-linear"}},
    InstrumentRule{"probe_lobing", {"ballbar", "dial", "deviation"}},
    InstrumentRule{"stylus_radius", {"dial", "deviation"}},
    InstrumentRule{"datum_shift", {}},
    InstrumentRule{"time_shift", {"ballbar", "lead", "joint", "deviation"}},
    InstrumentRule{"wrong_arm", {"laser-linear", "laser-straightness", "dial"}},
};

bool suits(const InstrumentRule& rule, std::string_view instrument) {
  return rule.instruments.front().empty() ||
         std::find(rule.instruments.begin(), rule.instruments.end(), instrument) != rule.instruments.end();
}

std::vector<std::string> pressures(const AvailableData& data) {
  std::vector<std::string> found;
  for (const std::string& name : data.columns) {
    if (name.find("press") != std::string::npos) found.push_back(name);
  }
  return found;
}

ReadingCandidate candidateAt(const EffectSpec& spec, ReadingPlacement placement, bool grinder) {
  ReadingCandidate candidate{.spec = &spec, .placement = std::move(placement), .nonlinear = {}, .columns = 0};
  const UnitChoice units = unitChoice(candidate.placement);
  for (const ParameterSpec& rule : spec.parameters) {
    candidate.columns += rule.role == Role::Linear ? 1U : rule.role == Role::Amplitude ? 2U : 0U;
    if (rule.role != Role::NonLinear && rule.role != Role::Choice) continue;
    const Plausible& plausible = rule.arc && units.angular ? *rule.arc : rule.linear;
    candidate.nonlinear.push_back({.name = std::string(rule.name),
                                   .unit = std::string(unitOf(rule.quantity, units)),
                                   .plausible = grinder ? plausible.grinder : plausible.mill,
                                   .starts = rule.starts,
                                   .choice = rule.role == Role::Choice});
  }
  return candidate;
}

std::vector<ReadingPlacement> placementsOf(const kinematics::Machine& machine, const EffectSpec& spec,
                                           const ReadingPlacement& place, const AvailableData& data) {
  std::vector<ReadingPlacement> found;
  if (spec.id == "wrong_arm") {
    for (int row = 0; row < 3; ++row) {
      found.push_back(place);
      found.back().row = row;
    }
    return found;
  }
  if (spec.sensors == 0) return {place};
  const AxisId axis = place.joint >= 0 ? machine.joint(place.joint).axis : AxisId{};
  const std::vector<std::string> all_pressures =
      spec.sensors > 1 ? pressures(data) : std::vector<std::string>();
  for (const std::string& name : data.columns) {
    if (!suitsSensor(spec, axis, name)) continue;
    found.push_back(place);
    found.back().sensor = name;
    if (!all_pressures.empty()) found.back().sensor_2 = all_pressures.front();
  }
  return found;
}

}  // namespace

std::vector<ReadingCandidate> readingCandidates(const kinematics::Machine& machine,
                                                const ReadingPlacement& placement,
                                                const AvailableData& data) {
  const bool time = std::find(data.columns.begin(), data.columns.end(), "t_s") != data.columns.end();
  std::vector<ReadingCandidate> found;
  for (const InstrumentRule& rule : kRules) {
    const EffectSpec* spec = findEffectSpec(rule.id);
    if (!suits(rule, placement.instrument) || ((spec->covariates & kTime) != 0 && !time)) continue;
    for (ReadingPlacement& place : placementsOf(machine, *spec, placement, data)) {
      found.push_back(candidateAt(*spec, std::move(place), data.grinder));
    }
  }
  return found;
}

}  // namespace nineline::errors
