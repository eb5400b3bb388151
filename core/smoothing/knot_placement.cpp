#include "core/smoothing/knot_placement.h"

#include <algorithm>
#include <cmath>

#include "core/smoothing/path_fit.h"

namespace nineline::smoothing {

namespace {

constexpr double kPointsPerSpan = 16.0;  // of the first fit
constexpr double kLeastGrowth = 0.3;     // spans that one span may become at least and at most in one round
constexpr double kMostGrowth = 3.0;

/// Places inner limits on the grid of knots and leaves out those that would leave a span without data.
std::vector<double> settled(std::span<const double> wanted, std::span<const double> parameters,
                            std::size_t most) {
  std::vector<double> limits{parameters.front()};
  std::size_t used = 0;  // data below the last limit
  for (const double place : wanted.subspan(1, wanted.size() - 2)) {
    if (limits.size() >= most) break;
    const double limit = std::round(place / kKnotGrid) * kKnotGrid;
    const auto below = static_cast<std::size_t>(
        std::lower_bound(parameters.begin(), parameters.end(), limit) - parameters.begin());
    const bool apart =
        limit >= limits.back() + 10.0 * kKnotGrid && limit <= parameters.back() - 10.0 * kKnotGrid;
    if (!apart || below <= used || below + 1 >= parameters.size()) continue;
    limits.push_back(limit);
    used = below;
  }
  limits.push_back(parameters.back());
  return limits;
}

}  // namespace

std::vector<double> firstLimits(std::span<const double> parameters, std::size_t most) {
  const double wanted = std::ceil(static_cast<double>(parameters.size()) / kPointsPerSpan);
  const std::size_t spans = std::clamp<std::size_t>(static_cast<std::size_t>(wanted), 1, most);
  std::vector<double> limits;
  for (std::size_t k = 0; k <= spans; ++k)
    limits.push_back(parameters.back() * static_cast<double>(k) / static_cast<double>(spans));
  return settled(limits, parameters, most);
}

std::vector<double> redistribute(std::span<const double> limits, std::span<const double> ratios, double aim,
                                 std::span<const double> parameters, std::size_t most) {
  std::vector<double> sums{0.0};
  for (const double ratio : ratios) {
    const double share = std::clamp(std::pow(ratio / aim, 0.25), kLeastGrowth, kMostGrowth);
    sums.push_back(sums.back() + share);
  }
  const auto spans = std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(sums.back())), 1, most);
  std::vector<double> wanted{limits.front()};
  std::size_t at = 0;
  for (std::size_t k = 1; k < spans; ++k) {
    const double target = sums.back() * static_cast<double>(k) / static_cast<double>(spans);
    while (sums[at + 1] < target) ++at;
    const double s = (target - sums[at]) / (sums[at + 1] - sums[at]);
    wanted.push_back(limits[at] + s * (limits[at + 1] - limits[at]));
  }
  wanted.push_back(limits.back());
  return settled(wanted, parameters, most);
}

std::vector<double> splitFailing(std::span<const double> limits, std::span<const double> ratios,
                                 std::span<const double> parameters, std::size_t most) {
  std::vector<double> wanted;
  for (std::size_t k = 0; k < ratios.size(); ++k) {
    wanted.push_back(limits[k]);
    if (ratios[k] > 1.0) wanted.push_back(0.5 * (limits[k] + limits[k + 1]));
  }
  wanted.push_back(limits.back());
  return settled(wanted, parameters, most);
}

}  // namespace nineline::smoothing
