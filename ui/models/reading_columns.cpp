#include "ui/models/reading_columns.h"

#include <algorithm>
#include <array>

#include "core/base/units.h"

namespace nineline::models {

namespace {

using kinematics::Machine;
using measurement::Measurement;

std::string positionColumn(const Machine& machine, int joint) {
  return machine.joint(joint).axis.text() + (machine.isRotary(joint) ? "_deg" : "_mm");
}

bool changes(const Machine& machine, const Measurement& measurement, const std::string& column) {
  std::optional<double> first;
  for (std::size_t i = 0; i < measurement.samples.size(); ++i) {
    const std::optional<double> value = columnValue(machine, measurement, column, i);
    if (!value) continue;
    if (first && *value != *first) return true;
    first = value;
  }
  return false;
}

}  // namespace

std::vector<std::string> variableColumns(const Machine& machine, const Measurement& measurement) {
  std::vector<std::string> columns;
  const auto offer = [&](const std::string& column) {
    if (changes(machine, measurement, column)) columns.push_back(column);
  };
  for (int joint = 0; joint < machine.jointCount(); ++joint) offer(positionColumn(machine, joint));
  for (const measurement::Covariate& covariate : measurement.covariates) offer(covariate.column);
  return columns;
}

std::optional<double> columnValue(const Machine& machine, const Measurement& measurement,
                                  const std::string& column, std::size_t sample) {
  for (int joint = 0; joint < machine.jointCount(); ++joint) {
    if (column != positionColumn(machine, joint)) continue;
    if (!measurement.samples[sample].has_positions) return std::nullopt;
    const double q = measurement.samples[sample].q[static_cast<std::size_t>(joint)];
    return machine.isRotary(joint) ? degFromRad(q) : q;
  }
  return measurement.value(column, sample);
}

std::string columnTitle(const std::string& column) {
  static constexpr std::array<std::pair<const char*, const char*>, 7> kUnits = {{{"_mm_min", "mm/min"},
                                                                                 {"_mm_s2", "mm/s²"},
                                                                                 {"_mm", "mm"},
                                                                                 {"_deg", "deg"},
                                                                                 {"_s", "s"},
                                                                                 {"_C", "°C"},
                                                                                 {"_kg", "kg"}}};
  std::string name = column;
  std::string unit;
  for (const auto& [ending, text] : kUnits) {
    if (!name.ends_with(ending)) continue;
    unit = text;
    name.erase(name.size() - std::string_view(ending).size());
    break;
  }
  if (unit.empty() && name.ends_with("_1")) name.erase(name.size() - 2);
  std::replace(name.begin(), name.end(), '_', ' ');
  return unit.empty() ? name : name + " / " + unit;
}

}  // namespace nineline::models
