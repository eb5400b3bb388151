#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/diagnostics.h"
#include "core/base/progress.h"
#include "core/errors/error_model.h"
#include "core/estimation/fit.h"
#include "core/identification/parameters.h"

namespace nineline::identification {

struct IdentificationOptions {
  std::vector<std::optional<double>> knot_spacings;  ///< by joint, mm or rad; absent: chosen by the readings
  bool play = true;                                  ///< seek backlash where joints were driven both ways
  bool lateral_play = false;                         ///< and play across and about the axes
  double play_significance = 3.0;  ///< standard uncertainties from which a play is written into the model
  estimation::RobustOptions robust;
  bool propose = true;  ///< look for the measurements that would help most
  std::string when;     ///< ISO 8601, for the model's provenance
};

/// Something that the readings cannot tell.
struct Unobservable {
  std::string name;                   ///< "ECX", "B0Z"
  std::vector<std::string> parts;     ///< "mean slope", "shape"; all of it where several stand there
  std::vector<std::string> partners;  ///< what it looks like; empty: no reading depends on it
  [[nodiscard]] std::string text() const;
};

/// Lists the chunks that are not told, each component once; not those that a convention settles.
void listUnobservable(const ParameterSet& parameters, const std::vector<estimation::Telling>& tellings,
                      std::vector<Unobservable>& list);

struct OutlierReading {
  std::size_t file = 0;
  std::size_t line = 0;  ///< in the file
  std::string column;
  double sigmas = 0.0;  ///< how far off, in standard deviations
};

/// Noise of one kind of instrument as the readings show it: standard deviations, mm or rad.
struct NoiseFound {
  std::string instrument;
  bool angular = false;
  std::size_t readings = 0;
  double within_run = 0.0;
  double run_offset = 0.0;  ///< of a whole run
  [[nodiscard]] double repeatability() const;
};

/// A set-up that would tell more (next_measurement.h).
struct ProposedMeasurement {
  std::string text;
  double gain = 0.0;                    ///< nats of information
  std::vector<std::string> would_tell;  ///< what becomes known
};

struct TableCoverage {
  std::string name;
  double low = 0.0, high = 0.0;  ///< measured range, mm or rad
  std::size_t values = 0;
};

/// What was found, how well, and what not.
struct IdentificationReport {
  std::optional<errors::ErrorModel> model;
  std::vector<Unobservable> unobservable;
  double condition_number = 0.0;
  double residual_rms = 0.0;                    ///< of lengths, outliers left out, mm
  std::optional<double> angular_residual_rms;   ///< rad
  std::optional<double> repeatability;          ///< of lengths, offsets from run to run included, mm
  std::optional<double> angular_repeatability;  ///< rad
  std::vector<NoiseFound> noise;
  std::vector<OutlierReading> outliers;
  std::vector<ProposedMeasurement> proposals;
  std::vector<TableCoverage> coverage;
  std::size_t readings = 0;
  std::size_t parameters = 0;
  Diagnostics warnings;
};

/// Finds the errors that the readings tell: location errors, a table for each error component of each joint
/// that moves, backlash; any mixture of instruments on any machine, through the exact kinematics. What they
/// do not tell is listed and not written into the model. See resources/docs/identification.md. Fails with
/// BadInput on files that do not fit the machine or hold no reading, with NoAnswer where the fit does not
/// settle.
[[nodiscard]] Result<IdentificationReport> identify(const Machine& machine,
                                                    std::span<const Measurement> measurements,
                                                    const IdentificationOptions& options, Progress& progress);

/// The result record of the command `identify` (contract.md): effects[] as in the model,
/// condition_number, residual_rms_um, repeatability_um, and what is beside them here.
[[nodiscard]] Json reportToJson(const IdentificationReport& report,
                                std::span<const Measurement> measurements);

}  // namespace nineline::identification
