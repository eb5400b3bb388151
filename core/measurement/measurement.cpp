#include "core/measurement/measurement.h"

#include <algorithm>

namespace nineline::measurement {

const Covariate* Measurement::covariate(std::string_view column) const {
  const auto found = std::find_if(covariates.begin(), covariates.end(),
                                  [&](const Covariate& one) { return one.column == column; });
  return found == covariates.end() ? nullptr : &*found;
}

std::optional<double> Measurement::value(std::string_view column, std::size_t sample) const {
  const Covariate* found = covariate(column);
  return found == nullptr ? std::nullopt : found->values[sample];
}

std::vector<RunSpan> runsOf(const Measurement& measurement) {
  std::vector<RunSpan> runs;
  const Covariate* column = measurement.covariate("run");
  for (std::size_t i = 0; i < measurement.samples.size(); ++i) {
    const std::optional<double> run = column == nullptr ? std::nullopt : column->values[i];
    if (runs.empty() || runs.back().run != run) runs.push_back({i, i, run});
    runs.back().last = i + 1;
  }
  return runs;
}

std::vector<ReadingRow> rowsOf(const Measurement& measurement) {
  std::vector<ReadingRow> rows;
  rows.reserve(measurement.readings.size());
  for (std::size_t i = 0; i < measurement.samples.size(); ++i) {
    const Sample& sample = measurement.samples[i];
    if (!sample.has_positions) continue;
    for (std::size_t k = 0; k < measurement.channels.size(); ++k) {
      const bool angular = measurement.channels[k].isAngular();
      const std::optional<double>& own = angular ? sample.angular_sigma : sample.sigma;
      rows.push_back({i, k, measurement.reading(i, k),
                      own       ? own
                      : angular ? measurement.angular_repeatability
                                : measurement.repeatability});
    }
  }
  return rows;
}

}  // namespace nineline::measurement
