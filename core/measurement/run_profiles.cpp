#include "core/measurement/run_profiles.h"

#include <algorithm>
#include <cmath>

namespace nineline::measurement {

namespace {

PlaceKey placeOf(const MachineState& state) {
  PlaceKey key{};
  for (std::size_t j = 0; j < kMaxAxes; ++j) {
    key[j] = std::llround(state.q[j] * 1e4);
    key[kMaxAxes + j] = state.approach[j];
  }
  return key;
}

double medianOf(std::vector<double>& values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

}  // namespace

std::vector<std::vector<RunProfile>> profilesOf(const Measurement& measurement,
                                                const std::vector<MachineState>& states) {
  std::vector<std::vector<RunProfile>> runs;
  for (const RunSpan& span : runsOf(measurement)) {
    std::vector<RunProfile> channels;
    for (std::size_t k = 0; k < measurement.channels.size(); ++k) {
      RunProfile profile{span, k, {}, {}};
      std::map<PlaceKey, double> counts;
      for (std::size_t i = span.first; i < span.last; ++i) {
        const std::optional<double>& reading = measurement.reading(i, k);
        if (!measurement.samples[i].has_positions || !reading) continue;
        const PlaceKey key = placeOf(states[i]);
        double& count = counts[key];
        double& mean = profile.readings[key];
        if (count == 0.0) profile.order.push_back(key);
        count += 1.0;
        mean += (*reading - mean) / count;
      }
      channels.push_back(std::move(profile));
    }
    runs.push_back(std::move(channels));
  }
  return runs;
}

PlaceKey positionOf(const PlaceKey& place) {
  PlaceKey position = place;
  std::fill(position.begin() + kMaxAxes, position.end(), 0);
  return position;
}

std::map<PlaceKey, double> medianOfOthers(const std::vector<std::vector<RunProfile>>& runs, std::size_t run,
                                          std::size_t channel) {
  std::map<PlaceKey, std::vector<double>> same_approach;
  std::map<PlaceKey, std::vector<double>> any_approach;
  for (std::size_t other = 0; other < runs.size(); ++other) {
    if (other == run) continue;
    for (const auto& [place, reading] : runs[other][channel].readings) {
      same_approach[place].push_back(reading);
      any_approach[positionOf(place)].push_back(reading);
    }
  }
  std::map<PlaceKey, double> medians;
  for (const PlaceKey& place : runs[run][channel].order) {
    const auto same = same_approach.find(place);
    const auto any = any_approach.find(positionOf(place));
    if (same != same_approach.end() && same->second.size() > 1) {
      medians[place] = medianOf(same->second);
    } else if (any != any_approach.end()) {
      medians[place] = medianOf(any->second);
    }
  }
  return medians;
}

Likeness likenessOf(const std::vector<double>& x, const std::vector<double>& y) {
  NL_EXPECTS(x.size() == y.size());
  Likeness likeness;
  likeness.count = x.size();
  if (x.empty()) return likeness;
  const auto count = static_cast<double>(x.size());
  double mean_x = 0.0;
  double mean_y = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += x[i] / count;
    mean_y += y[i] / count;
  }
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
    yy += (y[i] - mean_y) * (y[i] - mean_y);
  }
  likeness.rms_x = std::sqrt(xx / count);
  likeness.rms_y = std::sqrt(yy / count);
  if (xx > 0.0) likeness.factor = xy / xx;
  if (xx > 0.0 && yy > 0.0) likeness.explained = xy * xy / (xx * yy);
  return likeness;
}

}  // namespace nineline::measurement
