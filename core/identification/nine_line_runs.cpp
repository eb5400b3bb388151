#include "core/identification/nine_line_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nineline::identification {

namespace {

using Runs = std::vector<std::vector<std::vector<double>>>;

constexpr double kOutOfProportion = 0.001;

Result<void> checkRuns(const LineSetup& setup, const LineRuns& runs, const Runs& direction,
                       const char* name) {
  if (direction.size() != setup.readings.size()) {
    return badInput("lines.count", fmt::format("The set-up has {} readings, the {} runs have {}.",
                                               setup.readings.size(), name, direction.size()));
  }
  const std::size_t count = runs.forward.empty() || runs.forward[0].empty() ? 0 : runs.forward[0][0].size();
  for (std::size_t k = 0; k < direction.size(); ++k) {
    if (direction[k].size() != runs.positions.size()) {
      return badInput("lines.count", fmt::format("Reading {} has {} positions in the {} runs instead of {}.",
                                                 k + 1, direction[k].size(), name, runs.positions.size()));
    }
    for (std::size_t p = 0; p < direction[k].size(); ++p) {
      if (count > 0 && direction[k][p].size() == count) continue;
      return badInput("lines.count", fmt::format("Reading {} at position {} has {} {} runs instead of {}.",
                                                 k + 1, p + 1, direction[k][p].size(), name, count));
    }
  }
  if (runs.datum < runs.positions.size()) return {};
  return badInput("lines.datum",
                  fmt::format("The datum is position {} of {}.", runs.datum + 1, runs.positions.size()));
}

struct Scatter {
  double mean = 0.0;
  double variance = 0.0;
};

Scatter scatterOf(const std::vector<double>& values, const std::vector<double>& zeros) {
  const double count = static_cast<double>(values.size());
  Scatter result;
  for (std::size_t j = 0; j < values.size(); ++j) result.mean += (values[j] - zeros[j]) / count;
  for (std::size_t j = 0; j < values.size(); ++j) {
    result.variance += std::pow(values[j] - zeros[j] - result.mean, 2);
  }
  result.variance = values.size() > 1 ? result.variance / (count - 1.0) : 0.0;
  return result;
}

/// Replaces the variances of one reading by their mean where they could all be the same. Positions whose
/// readings are zero by definition (the datum) stay.
bool pool(std::vector<double>& variances, std::size_t runs) {
  std::vector<double> free;
  std::copy_if(variances.begin(), variances.end(), std::back_inserter(free),
               [](double v) { return v > 0.0; });
  if (free.empty() || runs < 2) return false;
  const double mean = std::accumulate(free.begin(), free.end(), 0.0) / static_cast<double>(free.size());
  const int freedom = static_cast<int>(runs) - 1;
  const double largest = *std::max_element(free.begin(), free.end());
  if (chiSquareTail(freedom * largest / mean, freedom) * static_cast<double>(free.size()) <
      kOutOfProportion) {
    return false;
  }
  for (double& variance : variances) variance = variance > 0.0 ? mean : 0.0;
  return true;
}

LineErrors combined(const LineErrors& one, const LineErrors& other, double sign) {
  LineErrors result;
  result.position = one.position;
  for (std::size_t row = 0; row < 6; ++row) {
    if (!one.value[row] || !other.value[row]) continue;
    result.value[row] = 0.5 * (*one.value[row] + sign * *other.value[row]);
    result.sigma[row] = 0.5 * std::hypot(*one.sigma[row], *other.sigma[row]);
  }
  result.chi_square = one.chi_square + other.chi_square;
  result.freedom = one.freedom + other.freedom;
  result.is_blunder = one.is_blunder || other.is_blunder;
  return result;
}

Result<LineReport> identifyDirection(const LineSetup& setup, const LineRuns& runs, bool is_backward,
                                     LineMethod method) {
  LineMeans means = meansOf(setup, runs, is_backward);
  LineData data;
  data.positions = runs.positions;
  if (!is_backward) data.datum = runs.datum;
  data.readings = std::move(means.mean);
  data.sigma = std::move(means.sigma);
  return identifyLines(setup, data, method);
}

}  // namespace

LineMeans meansOf(const LineSetup& setup, const LineRuns& runs, bool is_backward) {
  const Runs& direction = is_backward ? runs.backward : runs.forward;
  NL_EXPECTS(direction.size() == setup.readings.size());
  LineMeans result;
  for (std::size_t k = 0; k < direction.size(); ++k) {
    std::vector<double> mean, variance, sigma;
    const std::vector<double>& zeros = runs.forward[k][runs.datum];
    for (const std::vector<double>& values : direction[k]) {
      const Scatter scatter = scatterOf(values, zeros);
      mean.push_back(scatter.mean);
      variance.push_back(scatter.variance);
    }
    const std::size_t count = zeros.size();
    result.is_pooled.push_back(pool(variance, count));
    for (double& one : variance) {
      sigma.push_back(std::hypot(setup.readings[k].sigma, std::sqrt(one / static_cast<double>(count))));
      one = std::sqrt(one);
    }
    result.mean.push_back(std::move(mean));
    result.scatter.push_back(std::move(variance));
    result.sigma.push_back(std::move(sigma));
  }
  return result;
}

Result<BidirectionalLines> identifyLineRuns(const LineSetup& setup, const LineRuns& runs, LineMethod method) {
  if (const Result<void> good = checkRuns(setup, runs, runs.forward, "forward"); !good) return good.error();
  BidirectionalLines result;
  Result<LineReport> forward = identifyDirection(setup, runs, false, method);
  if (!forward) return forward.error();
  result.forward = *std::move(forward);
  result.table = result.forward.positions;
  if (!runs.backward.empty()) {
    if (const Result<void> good = checkRuns(setup, runs, runs.backward, "backward"); !good)
      return good.error();
    Result<LineReport> backward = identifyDirection(setup, runs, true, method);
    if (!backward) return backward.error();
    result.backward = *std::move(backward);
    result.table.clear();
    for (std::size_t p = 0; p < runs.positions.size(); ++p) {
      const LineErrors& there = result.forward.positions[p];
      const LineErrors& back = result.backward->positions[p];
      result.table.push_back(combined(there, back, 1.0));
      result.reversal.push_back(combined(there, back, -1.0));
    }
  }
  for (std::size_t p = 0; p < result.table.size(); ++p) {
    if (result.table[p].is_blunder) result.blunders.push_back(p);
  }
  return result;
}

}  // namespace nineline::identification
