#include "ui/jobs/compensation_job.h"

namespace nineline::jobs {

Result<OutcomePtr> compensate(const CompensationInput& input, Progress& progress) {
  PathRecord before;
  PathRecord after;
  const compensation::ComparisonSink record = [&](const simulation::PathSample& as_programmed,
                                                  const simulation::PathSample& corrected) {
    before.add(as_programmed);
    after.add(corrected);
  };
  auto corrected = compensation::compensateText(input.model, input.program_name, *input.program, input.setup,
                                                input.options, progress, record);
  if (!corrected) return corrected.error();
  auto outcome = std::make_shared<CompensationOutcome>();
  outcome->text = std::make_shared<const std::string>(std::move(corrected->text));
  outcome->report = std::move(corrected->report);
  outcome->before = before.take();
  outcome->after = after.take();
  return OutcomePtr(outcome);
}

}  // namespace nineline::jobs
