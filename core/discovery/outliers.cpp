#include "core/discovery/outliers.h"

#include <algorithm>
#include <cmath>

namespace nineline::discovery {

namespace {

constexpr double kAlone = 4.2;       // of the leave-one-out residual
constexpr double kNeighbours = 3.5;  // robust standard deviations from the neighbours' median
constexpr double kMostShare = 0.06;
constexpr Index kReach = 3;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Distance of each sample of a run from the median of its neighbours, in robust standard deviations.
VectorXd standingOut(const VectorXd& residual, const NoiseRun& run) {
  VectorXd distance(run.count);
  for (Index i = 0; i < run.count; ++i) {
    std::vector<double> around;
    for (Index k = std::max<Index>(0, i - kReach); k <= std::min(run.count - 1, i + kReach); ++k) {
      if (k != i) around.push_back(residual[run.first + k]);
    }
    distance[i] = residual[run.first + i] - median(std::move(around));
  }
  std::vector<double> sizes(distance.data(), distance.data() + distance.size());
  const double middle = median(sizes);
  for (double& size : sizes) size = std::abs(size - middle);
  const double spread = 1.4826 * median(std::move(sizes)) + 1e-9;
  return (distance.array() - middle).abs() / spread;
}

}  // namespace

std::vector<bool> findOutliers(const NoiseModel& model, const Noise& noise, const VectorXd& residual) {
  const VectorXd alone = model.leaveOneOut(noise, residual).cwiseAbs();
  std::vector<std::pair<double, Index>> found;
  for (const NoiseRun& run : model.layout().runs) {
    if (run.count < 6) continue;
    const VectorXd distance = standingOut(residual, run);
    for (Index i = 0; i < run.count; ++i) {
      if (alone[run.first + i] > kAlone && distance[i] > kNeighbours) {
        found.emplace_back(alone[run.first + i], run.first + i);
      }
    }
  }
  std::sort(found.rbegin(), found.rend());
  const auto most = static_cast<std::size_t>(kMostShare * static_cast<double>(residual.size()));
  if (found.size() > most) found.resize(most);
  std::vector<bool> outliers(static_cast<std::size_t>(residual.size()), false);
  for (const auto& [size, sample] : found) outliers[static_cast<std::size_t>(sample)] = true;
  return outliers;
}

}  // namespace nineline::discovery
