#pragma once

#include <bitset>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/errors/machine_state.h"
#include "core/measurement/instrument.h"

namespace nineline::measurement {

using errors::MachineState;
using kinematics::JointPositions;
using kinematics::Machine;

/// One sample: where the machine was commanded to stand when the instrument was read.
struct Sample {
  JointPositions q{};         ///< mm, rad, in the machine's joint order; joints without a column stand at 0
  bool has_positions = true;  ///< false: a position cell is empty; nothing can be predicted here
  std::bitset<kMaxAxes> missing;        ///< the joints whose cells are empty
  std::size_t line = 0;                 ///< in the file, from 1; 0 when there is no file
  std::optional<double> sigma;          ///< of this sample's lengths, mm (`sigma_um`)
  std::optional<double> angular_sigma;  ///< of this sample's angles, rad (`sigma_arcsec`)
};

/// A numeric column that is neither position nor reading, by its name in the file ("t_s", "run", "pass_1",
/// "temp_bed_C", "approach_Z_1", "v_Z_mm_min"), in the unit that the name ends in. One value for each sample.
struct Covariate {
  std::string column;
  std::vector<std::optional<double>> values;
};

/// One file of one instrument: what was commanded, what was read, and the conditions. A value. The samples
/// stand in the order in which they were taken.
struct Measurement {
  std::string source;      ///< file name, for messages
  std::string machine_id;  ///< as the file names it; empty when it does not
  Instrument instrument;
  std::optional<double> repeatability;          ///< standard deviation of lengths, mm
  std::optional<double> angular_repeatability;  ///< standard deviation of angles, rad
  std::vector<Channel> channels;
  std::vector<Sample> samples;
  /// Row by row: reading of sample i in channel k at i · channels.size() + k; mm or rad. Absent: empty cell.
  std::vector<std::optional<double>> readings;
  std::vector<Covariate> covariates;
  /// Joints that have a column, in joint order; the others stand at 0.
  std::vector<bool> commanded;
  /// Column names in the order of the file; empty when there is no file.
  std::vector<std::string> columns;
  /// Head lines that this version does not use, in order: key and value.
  std::vector<std::pair<std::string, std::string>> other_head;

  [[nodiscard]] const std::optional<double>& reading(std::size_t sample, std::size_t channel) const {
    return readings[sample * channels.size() + channel];
  }
  /// Null when there is no such column.
  [[nodiscard]] const Covariate* covariate(std::string_view column) const;
  /// The value of a column at a sample; absent also when there is no such column.
  [[nodiscard]] std::optional<double> value(std::string_view column, std::size_t sample) const;
  /// The run of a sample; absent without a `run` column.
  [[nodiscard]] std::optional<double> run(std::size_t sample) const { return value("run", sample); }
};

/// Neighbouring samples [first, last) of one run. Without a `run` column the file is one run.
struct RunSpan {
  std::size_t first = 0;
  std::size_t last = 0;
  std::optional<double> run;
};
[[nodiscard]] std::vector<RunSpan> runsOf(const Measurement& measurement);

/// One reading that can be predicted.
struct ReadingRow {
  std::size_t sample = 0;
  std::size_t channel = 0;
  std::optional<double> value;  ///< mm, rad; absent where the cell is empty
  /// Standard uncertainty, mm or rad: of the sample, else of the file; absent where neither is stated.
  std::optional<double> sigma;
};

/// Every channel of every sample whose positions are known, sample by sample. Predictions and gradients have
/// one entry for each of these rows, in this order.
[[nodiscard]] std::vector<ReadingRow> rowsOf(const Measurement& measurement);

}  // namespace nineline::measurement
