#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "core/discovery/discovery.h"

namespace nineline::jobs {

/// All that a search for missing effects depends on.
struct GapInput {
  errors::ErrorModel model;
  std::vector<measurement::Measurement> measurements;
  discovery::DiscoveryOptions options;
};

/// Reading − prediction of one measurement, its unknown zero taken out; entries where a reading is there and
/// can be predicted. mm or rad.
struct Residuals {
  std::vector<measurement::ReadingRow> rows;
  Eigen::VectorXd before;  ///< with the model that the search began with
  Eigen::VectorXd after;   ///< with the found effects
};

/// How much of the gap is left once the first n found effects are in, in the order in which they were found.
struct GapStage {
  std::string effect;  ///< the last one added; empty for the model as it was
  std::string joint;
  double rms_in_sigma = 0.0;  ///< over all readings, in their standard uncertainties
};

/// What the screens show of a finished search.
struct GapOutcome {
  discovery::DiscoveryReport report;
  std::vector<Residuals> residuals;  ///< one for each measurement
  std::vector<GapStage> stages;
};
using GapOutcomePtr = std::shared_ptr<const GapOutcome>;

[[nodiscard]] Result<GapOutcomePtr> findGap(const GapInput& input, Progress& progress);

}  // namespace nineline::jobs
