#include "core/measurement/evaluation_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nineline::measurement {

namespace {

Result<void> checkDirection(const TargetRuns& runs, const std::vector<std::vector<double>>& direction,
                            const char* name) {
  if (direction.empty()) return {};
  if (direction.size() != runs.targets.size()) {
    return badInput("evaluation.targets",
                    fmt::format("There are {} targets, but {} of them in the {} direction.",
                                runs.targets.size(), direction.size(), name));
  }
  for (std::size_t i = 0; i < direction.size(); ++i) {
    if (direction[i].empty()) {
      return badInput("evaluation.missing",
                      fmt::format("Target {:g} has no reading in the {} direction.", runs.targets[i], name));
    }
    for (const double value : direction[i]) {
      if (std::isfinite(value)) continue;
      return badInput(
          "evaluation.number",
          fmt::format("A reading at target {:g} in the {} direction is no number.", runs.targets[i], name));
    }
  }
  return {};
}

}  // namespace

Result<void> checkTargetRuns(const TargetRuns& runs) {
  if (runs.targets.empty() || (runs.forward.empty() && runs.backward.empty())) {
    return badInput("evaluation.empty", "There is no target with readings to evaluate.");
  }
  for (std::size_t i = 0; i < runs.targets.size(); ++i) {
    if (!std::isfinite(runs.targets[i]) || (i > 0 && runs.targets[i] <= runs.targets[i - 1])) {
      return badInput("evaluation.order",
                      fmt::format("Targets must ascend; number {} is {:g}.", i + 1, runs.targets[i]));
    }
  }
  if (Result<void> forward = checkDirection(runs, runs.forward, "forward"); !forward) return forward;
  return checkDirection(runs, runs.backward, "backward");
}

ApproachStatistics statisticsOf(const std::vector<double>& values) {
  NL_EXPECTS(!values.empty());
  ApproachStatistics result;
  result.count = values.size();
  const double count = static_cast<double>(values.size());
  result.mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  if (values.size() < 2) return result;
  double squares = 0.0;
  for (const double value : values) squares += (value - result.mean) * (value - result.mean);
  result.s = std::sqrt(squares / (count - 1.0));
  return result;
}

std::vector<ApproachStatistics> statisticsOf(const std::vector<std::vector<double>>& direction) {
  std::vector<ApproachStatistics> result;
  result.reserve(direction.size());
  for (const std::vector<double>& values : direction) result.push_back(statisticsOf(values));
  return result;
}

void Extent::add(double value) {
  largest_ = largest_ ? std::max(*largest_, value) : value;
  smallest_ = smallest_ ? std::min(*smallest_, value) : value;
}

std::optional<double> Extent::range() const {
  if (!largest_) return std::nullopt;
  return *largest_ - *smallest_;
}

}  // namespace nineline::measurement
