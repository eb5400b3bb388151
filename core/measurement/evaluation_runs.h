#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/result.h"

namespace nineline::measurement {

/// Repeated approaches to the targets of one axis, as plain numbers. `forward[i][j]` is the deviation (actual
/// minus target, mm or rad) of approach j to target i in the positive direction; `backward` likewise. A
/// direction that was not driven is empty as a whole. The number of approaches may differ between targets.
struct TargetRuns {
  std::vector<double> targets;  ///< mm or rad, ascending
  std::vector<std::vector<double>> forward;
  std::vector<std::vector<double>> backward;
};

/// Fails where there is no target, targets do not ascend, a driven direction misses a target, or a number is
/// not finite.
[[nodiscard]] Result<void> checkTargetRuns(const TargetRuns& runs);

/// Approaches to one target in one direction.
struct ApproachStatistics {
  std::size_t count = 0;
  double mean = 0.0;
  std::optional<double> s;  ///< standard deviation with count − 1; absent for a single approach
};

/// Requires at least one value.
[[nodiscard]] ApproachStatistics statisticsOf(const std::vector<double>& values);

/// Statistics of every target; empty for a direction that was not driven.
[[nodiscard]] std::vector<ApproachStatistics> statisticsOf(const std::vector<std::vector<double>>& direction);

/// The largest and the smallest of the values put in, as the letters of the standards need them.
class Extent {
 public:
  void add(double value);
  /// Largest minus smallest; absent before the first value.
  [[nodiscard]] std::optional<double> range() const;
  [[nodiscard]] std::optional<double> largest() const { return largest_; }
  [[nodiscard]] std::optional<double> smallest() const { return smallest_; }

 private:
  std::optional<double> largest_;
  std::optional<double> smallest_;
};

}  // namespace nineline::measurement
