#include "ui/jobs/program_preview.h"

namespace nineline::jobs {

void PathRecord::add(const simulation::PathSample& sample) {
  if (seen_++ % stride_ != 0) return;
  samples_.push_back(sample);
  if (samples_.size() < kMostSamples) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < samples_.size(); i += 2) samples_[kept++] = samples_[i];
  samples_.resize(kept);
  stride_ *= 2;
}

ProgramPreview previewProgram(const kinematics::Machine& machine, const std::string& name,
                              const std::shared_ptr<const std::string>& text,
                              const simulation::ProgramSetup& setup, Progress& progress) {
  ProgramPreview preview;
  PathRecord record;
  nc::MemoryText source(name, *text);
  const simulation::SampleSink sink = [&record, &progress](const simulation::PathSample& sample) {
    record.add(sample);
    return !progress.isCancelled();
  };
  auto report = simulation::simulateProgram(errors::ErrorModel(machine), source, setup, sink, progress);
  if (report) {
    preview.report = std::move(*report);
  } else {
    preview.error = report.error();
  }
  preview.samples = record.take();
  return preview;
}

}  // namespace nineline::jobs
