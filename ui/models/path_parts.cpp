#include "ui/models/path_parts.h"

#include <algorithm>

namespace nineline::models {

namespace {
constexpr double kShortest = 0.2;  // of the longest cut
}

std::vector<PathPart> cutsOf(const std::vector<simulation::PathSample>& samples) {
  std::vector<PathPart> cuts;
  bool open = false;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (samples[i].rapid) {
      open = false;
      continue;
    }
    if (!open) cuts.push_back({i == 0 ? i : i - 1, i + 1});
    open = true;
    cuts.back().last = i + 1;
  }
  const auto length = [&samples](const PathPart& cut) {
    return samples[cut.last - 1].s - samples[cut.first].s;
  };
  double longest = 0.0;
  for (const PathPart& cut : cuts) longest = std::max(longest, length(cut));
  std::erase_if(cuts, [&](const PathPart& cut) { return length(cut) < kShortest * longest; });
  return cuts;
}

std::vector<simulation::PathSample> samplesOf(const std::vector<simulation::PathSample>& samples,
                                              const PathPart& part) {
  std::vector<simulation::PathSample> kept(samples.begin() + static_cast<std::ptrdiff_t>(part.first),
                                           samples.begin() + static_cast<std::ptrdiff_t>(part.last));
  if (kept.empty()) return kept;
  const double s = kept.front().s;
  const double t = kept.front().t;
  for (simulation::PathSample& sample : kept) {
    sample.s -= s;
    sample.t -= t;
  }
  return kept;
}

}  // namespace nineline::models
