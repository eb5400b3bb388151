#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/measurement/measurement.h"

namespace nineline::models {

/// Columns of a measurement that a plot may run over: commanded positions that change, then time and the
/// conditions that change. Names as in the file ("Z_mm", "temp_bed_C").
[[nodiscard]] std::vector<std::string> variableColumns(const kinematics::Machine& machine,
                                                       const measurement::Measurement& measurement);

/// The value of such a column at a sample, in the unit that its name ends in.
[[nodiscard]] std::optional<double> columnValue(const kinematics::Machine& machine,
                                                const measurement::Measurement& measurement,
                                                const std::string& column, std::size_t sample);

/// "Z_mm" → "Z / mm", "temp_bed_C" → "temp bed / °C".
[[nodiscard]] std::string columnTitle(const std::string& column);

}  // namespace nineline::models
