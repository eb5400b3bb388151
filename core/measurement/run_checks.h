#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/measurement/prediction.h"

namespace nineline::measurement {

/// A mistake that somebody probably made in one run: proposed, never repaired silently.
struct RunFault {
  std::string code;  ///< "run.sign", "run.factor", "run.reversed", "run.swapped", "run.half",
                     ///< "run.duplicate", "channel.frozen", "sensor.frozen"
  std::string text;  ///< what was noticed, with its place
  std::string remedy;
  std::optional<double> run;
  std::size_t first_row = 0;  ///< samples, from 1, both ends included
  std::size_t last_row = 0;
  std::optional<double> factor;  ///< what the readings of the run are to be multiplied by, where that is it
};

/// Compares each run with the other runs of its file (median at the same positions and approach) and, where a
/// prediction is given, with what the model expects. Noticed: a run of the opposite sign, a run larger or
/// smaller by 1000, 25.4 or 10, one taken in the opposite order, channels exchanged, targets that a run lacks
/// and the others have, runs that are copies of each other, readings and temperatures that stand still. Two
/// runs alone do not tell which of them is wrong: then both are named.
[[nodiscard]] std::vector<RunFault> checkRuns(const Measurement& measurement, const Machine& machine,
                                              const Prediction* prediction = nullptr);

}  // namespace nineline::measurement
