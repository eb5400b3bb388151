#pragma once

#include "core/compensation/compensation.h"
#include "ui/jobs/program_preview.h"

namespace nineline::jobs {

/// All that a compensation depends on; a value that crosses to the worker's thread.
struct CompensationInput {
  errors::ErrorModel model;
  std::string program_name;
  std::shared_ptr<const std::string> program;
  simulation::ProgramSetup setup;
  compensation::CompensationOptions options;
};

/// What the screens show of a finished compensation. Deviations of `after` are those of the corrected program
/// from the ideal path of the original one.
struct CompensationOutcome {
  std::shared_ptr<const std::string> text;
  compensation::CompensationReport report;
  std::vector<simulation::PathSample> before;
  std::vector<simulation::PathSample> after;
};
using OutcomePtr = std::shared_ptr<const CompensationOutcome>;

[[nodiscard]] Result<OutcomePtr> compensate(const CompensationInput& input, Progress& progress);

}  // namespace nineline::jobs
