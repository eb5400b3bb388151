#pragma once

#include <cstdint>

#include "core/base/progress.h"
#include "core/discovery/report.h"
#include "core/measurement/measurement.h"

namespace nineline::discovery {

struct DiscoveryOptions {
  std::vector<double>
      holdout_runs;        ///< never seen by the fit; empty: chosen, one in four where there are four
  std::uint64_t seed = 1;  ///< kept for the record: the procedure draws nothing
  std::string when;        ///< ISO 8601, noted in the provenance of new effects
};

/// Where simulation and measurement disagree, what is missing, and the model with it (discovery.md). Fails
/// with BadInput when the measurements do not fit the machine or are too few. Deterministic.
[[nodiscard]] Result<DiscoveryReport> discover(const errors::ErrorModel& model,
                                               const std::vector<measurement::Measurement>& measurements,
                                               const DiscoveryOptions& options, Progress& progress);

}  // namespace nineline::discovery
