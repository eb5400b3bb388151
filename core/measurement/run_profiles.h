#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "core/measurement/prediction.h"

namespace nineline::measurement {

/// Where a reading was taken, to compare runs: positions to 0.1 µm (1e-7 rad) and the approach of each joint.
using PlaceKey = std::array<long long, 2 * kMaxAxes>;

/// The readings of one run in one channel, by place.
struct RunProfile {
  RunSpan span;
  std::size_t channel = 0;
  std::map<PlaceKey, double> readings;  ///< mean where a place occurs again
  std::vector<PlaceKey> order;          ///< places as they were visited, each once
};

/// A profile for every run and channel, run by run.
[[nodiscard]] std::vector<std::vector<RunProfile>> profilesOf(const Measurement& measurement,
                                                              const std::vector<MachineState>& states);

/// The same place whatever the approach.
[[nodiscard]] PlaceKey positionOf(const PlaceKey& place);

/// Median of the other runs' readings at every place of a run: of those with the same approach where there
/// are at least two, else of all at that position. One other run alone is its own median.
[[nodiscard]] std::map<PlaceKey, double> medianOfOthers(const std::vector<std::vector<RunProfile>>& runs,
                                                        std::size_t run, std::size_t channel);

/// y ≈ factor · x about the means, over the common places: how well it holds.
struct Likeness {
  double factor = 0.0;
  double explained = 0.0;  ///< share of the variance of y, 0…1
  double rms_x = 0.0;      ///< about the mean
  double rms_y = 0.0;
  std::size_t count = 0;
};
[[nodiscard]] Likeness likenessOf(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace nineline::measurement
