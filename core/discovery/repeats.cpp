#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/discovery/campaign.h"

namespace nineline::discovery {

namespace {

constexpr double kSamePlace = 1e-3;  // mm, rad: positions that count as the same

using Key = std::vector<long long>;

Key placeOf(const errors::MachineState& state, int joints) {
  Key key;
  for (int j = 0; j < joints; ++j) {
    key.push_back(std::llround(state.q[static_cast<std::size_t>(j)] / kSamePlace));
    key.push_back(state.approach[static_cast<std::size_t>(j)]);
  }
  return key;
}

/// Pooled standard deviation of groups of values; absent with fewer than four degrees of freedom.
std::optional<double> pooled(const std::map<Key, std::vector<double>>& groups) {
  double sum = 0.0, freedom = 0.0;
  for (const auto& [key, values] : groups) {
    if (values.size() < 2) continue;
    double mean = 0.0;
    for (const double v : values) mean += v / static_cast<double>(values.size());
    for (const double v : values) sum += (v - mean) * (v - mean);
    freedom += static_cast<double>(values.size() - 1);
  }
  if (freedom < 4.0) return std::nullopt;
  return std::sqrt(sum / freedom);
}

/// Robust size of second differences, as the standard deviation of one reading.
std::optional<double> fromSecondDifferences(std::vector<double> differences) {
  if (differences.size() < 6) return std::nullopt;
  for (double& d : differences) d = std::abs(d);
  const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
  std::nth_element(differences.begin(), middle, differences.end());
  return 1.4826 * *middle / std::sqrt(6.0);
}

/// The smallest step between different readings: what the display rounds to.
double roundingOf(std::vector<double> readings) {
  std::sort(readings.begin(), readings.end());
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < readings.size(); ++i) {
    const double step = readings[i] - readings[i - 1];
    if (step > 1e-9) least = std::min(least, step);
  }
  return std::isfinite(least) ? least : 0.0;
}

}  // namespace

std::optional<double> repeatabilityFromRepeats(const Measurement& measurement,
                                               const std::vector<errors::MachineState>& states,
                                               std::size_t channel) {
  std::map<Key, std::vector<double>> groups;
  std::vector<double> differences, all;
  for (const measurement::RunSpan& run : measurement::runsOf(measurement)) {
    std::vector<double> readings;
    for (std::size_t i = run.first; i < run.last; ++i) {
      const std::optional<double>& value = measurement.reading(i, channel);
      if (!value || !measurement.samples[i].has_positions) continue;
      groups[placeOf(states[i], static_cast<int>(measurement.commanded.size()))].push_back(*value);
      readings.push_back(*value);
      all.push_back(*value);
    }
    for (std::size_t i = 2; i < readings.size(); ++i) {
      differences.push_back(readings[i] - 2.0 * readings[i - 1] + readings[i - 2]);
    }
  }
  // Repeats also hold whatever changed between the runs, neighbours also hold what is smooth: the smaller
  // counts.
  constexpr double kCorrelated = 1.25;
  const std::optional<double> repeats = pooled(groups);
  const std::optional<double> neighbours = fromSecondDifferences(std::move(differences));
  if (!repeats && !neighbours) return std::nullopt;
  const double infinite = std::numeric_limits<double>::infinity();
  const std::optional<double> found =
      std::min(repeats.value_or(infinite), neighbours ? kCorrelated * *neighbours : infinite);
  return std::max({*found, roundingOf(std::move(all)) / std::sqrt(12.0), 1e-9});
}

namespace {

/// Fills gaps between known values in proportion to `along`.
void fillGaps(std::vector<std::optional<double>>& values, const std::vector<double>& along) {
  std::optional<std::size_t> before;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!values[i]) continue;
    if (before && i - *before > 1) {
      const double span = along[i] - along[*before];
      for (std::size_t k = *before + 1; k < i; ++k) {
        const double share = span > 0.0 ? (along[k] - along[*before]) / span : 0.5;
        values[k] = *values[*before] + share * (*values[i] - *values[*before]);
      }
    }
    if (!before) std::fill(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(i), values[i]);
    before = i;
  }
  if (before) {
    std::fill(values.begin() + static_cast<std::ptrdiff_t>(*before) + 1, values.end(), values[*before]);
  }
}

bool isSmooth(const std::string& column) {
  return column.starts_with("temp_") || column == "t_s" || column == "load_kg";
}

}  // namespace

Measurement withFilledConditions(Measurement measurement) {
  std::vector<double> along(measurement.samples.size());
  for (std::size_t i = 0; i < along.size(); ++i) along[i] = static_cast<double>(i);
  for (const bool times : {true, false}) {
    for (measurement::Covariate& covariate : measurement.covariates) {
      if (!isSmooth(covariate.column) || (covariate.column == "t_s") != times) continue;
      const auto known = std::count_if(covariate.values.begin(), covariate.values.end(),
                                       [](const std::optional<double>& v) { return v.has_value(); });
      if (2 * static_cast<std::size_t>(known) < covariate.values.size()) continue;
      fillGaps(covariate.values, along);
      if (!times) continue;
      for (std::size_t i = 0; i < along.size(); ++i) along[i] = covariate.values[i].value_or(along[i]);
    }
  }
  return measurement;
}

}  // namespace nineline::discovery
