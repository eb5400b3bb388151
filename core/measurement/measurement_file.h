#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/diagnostics.h"
#include "core/measurement/measurement.h"

namespace nineline::measurement {

/// What a reader found. The measurement is usable only when `diagnostics` has no errors.
struct MeasurementReading {
  Measurement measurement;
  std::optional<Machine> machine;  ///< the one whose joint order the samples follow
  Diagnostics diagnostics;         ///< every fault with line, column, what stood there and what was expected
};

/// Where the joints come from.
struct MeasurementReadOptions {
  /// The model's or the chosen machine; it wins over `#machine`. Null: the built-in one that the file names.
  const Machine* machine = nullptr;
  /// Without a known machine, make one of the position columns (`X_mm` a linear, `C_deg` a rotary joint on
  /// the tool's side), with a warning. For figures that need no kinematics.
  bool allow_stand_in = false;
};

/// Reads `nineline-measurement/1` (contract.md): head, column names, samples; comma, semicolon or tab, CRLF,
/// byte order mark. Stops after 200 faults.
[[nodiscard]] MeasurementReading readMeasurement(std::string_view bytes, const std::string& source,
                                                 const MeasurementReadOptions& options = {});
[[nodiscard]] MeasurementReading loadMeasurement(const std::filesystem::path& path,
                                                 const MeasurementReadOptions& options = {});

/// The measurement, or the first fault, for callers that show one only.
[[nodiscard]] Result<Measurement> measurementOf(MeasurementReading reading);

/// The same format; numbers with 12 significant digits, so that reading it back gives the same to a
/// picometre.
[[nodiscard]] std::string writeMeasurement(const Measurement& measurement, const Machine& machine);

/// The line of column names of `measurement` and, row by row, its cells: as in writeMeasurement, without the
/// head. `more` are columns beside them.
struct ExtraColumn {
  std::string name;
  std::vector<std::optional<double>> values;  ///< one for each sample, in the unit of the name
};
[[nodiscard]] std::string writeSamples(const Measurement& measurement, const Machine& machine,
                                       const std::vector<ExtraColumn>& more = {});

/// A reading in the unit of its column: µm or arcsec.
[[nodiscard]] double shownReading(const Channel& channel, double value);

}  // namespace nineline::measurement
