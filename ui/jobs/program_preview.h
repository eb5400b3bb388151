#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/simulation/simulation.h"

namespace nineline::jobs {

/// The samples of a path that a screen shows: every n-th one where a program has more than fit, block ends
/// first.
class PathRecord {
 public:
  static constexpr std::size_t kMostSamples = 150000;
  void add(const simulation::PathSample& sample);
  [[nodiscard]] const std::vector<simulation::PathSample>& samples() const { return samples_; }
  [[nodiscard]] std::vector<simulation::PathSample> take() { return std::move(samples_); }

 private:
  std::vector<simulation::PathSample> samples_;
  std::size_t stride_ = 1;
  std::size_t seen_ = 0;
};

/// What a program asks of the machine: its ideal path as far as it can be read, and the fault that ends it.
struct ProgramPreview {
  std::vector<simulation::PathSample> samples;
  std::optional<simulation::SimulationReport> report;
  std::optional<Error> error;
};

[[nodiscard]] ProgramPreview previewProgram(const kinematics::Machine& machine, const std::string& name,
                                            const std::shared_ptr<const std::string>& text,
                                            const simulation::ProgramSetup& setup, Progress& progress);

}  // namespace nineline::jobs
