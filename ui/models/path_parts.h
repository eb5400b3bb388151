#pragma once

#include <cstddef>
#include <vector>

#include "core/simulation/simulation.h"

namespace nineline::models {

/// Samples `first` up to, not including, `last`.
struct PathPart {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// The runs of a path between rapid motions, in order; runs far shorter than the longest one (approaches,
/// infeeds) are left out.
[[nodiscard]] std::vector<PathPart> cutsOf(const std::vector<simulation::PathSample>& samples);

/// The samples of a part; path length and time count from its start.
[[nodiscard]] std::vector<simulation::PathSample> samplesOf(
    const std::vector<simulation::PathSample>& samples, const PathPart& part);

}  // namespace nineline::models
