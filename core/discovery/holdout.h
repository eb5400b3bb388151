#pragma once

#include "core/discovery/campaign.h"
#include "core/discovery/report.h"

namespace nineline::discovery {

/// Runs that the fit does not see: those asked for, else the last of every file that has at least four.
class Holdout {
 public:
  Holdout(const std::vector<Measurement>& measurements, const std::vector<double>& asked);

  [[nodiscard]] bool has(std::size_t file, std::size_t sample) const { return held_[file][sample] != 0; }
  /// Fills the held-out figures: both models against the readings that were not used, the zero of each file
  /// from the runs that were (from the held-out ones where there are no others).
  [[nodiscard]] Result<void> judge(const ErrorModel& before, const ErrorModel& after,
                                   const std::vector<Measurement>& measurements, const Campaign& campaign,
                                   const Noise& noise, Gap& gap) const;

 private:
  std::vector<std::vector<std::uint8_t>> held_;  // by file, sample
  std::vector<double> runs_;
};

}  // namespace nineline::discovery
