#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/json.h"
#include "core/measurement/import.h"
#include "core/measurement/measurement_file.h"

namespace nineline::measurement {

/// What one column of a foreign table is.
enum class Meaning {
  Unknown,  ///< nobody has said; the table cannot be read
  Ignored,
  Position,  ///< commanded position of a joint
  Reading,   ///< the instrument's deviation, actual minus ideal
  Actual,    ///< actual position of the joint under test: the reading is actual minus commanded
  Sigma,     ///< standard uncertainty of the readings
  Covariate  ///< under `name`, as in a measurement file
};

/// One column of a foreign table, from the left.
struct MappedColumn {
  std::string header;  ///< as it stands in the file
  Meaning meaning = Meaning::Unknown;
  std::optional<AxisId> axis;            ///< position
  Quantity quantity = Quantity::Length;  ///< reading
  std::string unit;       ///< "mm", "um", "inch", "deg", "arcsec", …; "" where it is not known
  bool negative = false;  ///< the column's sign is the opposite of ours
  std::string name;       ///< covariate, "temp_bed_C"
};

/// How a foreign table is read. A value that a dialog fills, that is remembered by the layout's fingerprint.
struct ColumnMapping {
  char separator = ';';
  bool decimal_comma = false;
  std::size_t header_line = 1;  ///< from 1; 0: there is none
  Instrument instrument;
  std::optional<double> repeatability;  ///< mm
  std::vector<MappedColumn> columns;
};

/// Length and angle units that columns may have.
[[nodiscard]] const std::vector<std::string>& lengthUnits();
[[nodiscard]] const std::vector<std::string>& angleUnits();

/// What the text itself tells: separator, decimal sign, header, and the meaning of columns whose header
/// leaves no doubt (a name of the contract, or a known word together with a unit). All others stay Unknown or
/// without a unit, to be asked. Fails on text that is no table.
[[nodiscard]] Result<ColumnMapping> proposeMapping(std::string_view bytes, const std::string& source,
                                                   const Machine& machine);

/// What a mapping still lacks, as questions for a dialog; empty when the table can be read.
[[nodiscard]] std::vector<Question> openQuestions(const ColumnMapping& mapping, const Machine& machine);

/// Reads the table. Every fault with line and column, as readMeasurement does.
[[nodiscard]] MeasurementReading readMapped(std::string_view bytes, const std::string& source,
                                            const ColumnMapping& mapping, const Machine& machine);

/// A short text that is equal for files of the same layout: separator, decimal sign and headers.
[[nodiscard]] std::string layoutFingerprint(const ColumnMapping& mapping);

/// For the settings: what `mappingFromJson` reads back.
[[nodiscard]] Json mappingToJson(const ColumnMapping& mapping);
[[nodiscard]] Result<ColumnMapping> mappingFromJson(const Json& json, const std::string& source);

}  // namespace nineline::measurement
