#include "core/measurement/iso_230_2.h"

#include <algorithm>
#include <cmath>

namespace nineline::measurement {

namespace {

std::optional<double> fourSigma(const std::optional<ApproachStatistics>& direction) {
  if (!direction || !direction->s) return std::nullopt;
  return 4.0 * *direction->s;
}

Iso2302Position positionOf(const TargetRuns& runs, std::size_t i) {
  Iso2302Position result;
  result.target = runs.targets[i];
  if (!runs.forward.empty()) result.forward = statisticsOf(runs.forward[i]);
  if (!runs.backward.empty()) result.backward = statisticsOf(runs.backward[i]);
  result.R_forward = fourSigma(result.forward);
  result.R_backward = fourSigma(result.backward);
  if (!result.forward || !result.backward) return result;
  result.mean = 0.5 * (result.forward->mean + result.backward->mean);
  result.B = result.forward->mean - result.backward->mean;
  if (result.R_forward && result.R_backward) {
    result.R = std::max({0.5 * *result.R_forward + 0.5 * *result.R_backward + std::abs(*result.B),
                         *result.R_forward, *result.R_backward});
  }
  return result;
}

/// Ranges over the positions of one direction, or of both when a second one is added.
struct Ranges {
  Extent means;
  Extent bands;    // mean ± 2 s
  Extent repeats;  // 4 s
  bool has_all_s = true;

  void add(const ApproachStatistics& direction) {
    means.add(direction.mean);
    if (!direction.s) {
      has_all_s = false;
      return;
    }
    bands.add(direction.mean + 2.0 * *direction.s);
    bands.add(direction.mean - 2.0 * *direction.s);
    repeats.add(4.0 * *direction.s);
  }
  [[nodiscard]] std::optional<double> accuracy() const { return has_all_s ? bands.range() : std::nullopt; }
  [[nodiscard]] std::optional<double> repeatability() const {
    return has_all_s ? repeats.largest() : std::nullopt;
  }
};

void addOneWay(Iso2302& result) {
  Ranges forward, backward;
  for (const Iso2302Position& position : result.positions) {
    if (position.forward) forward.add(*position.forward);
    if (position.backward) backward.add(*position.backward);
  }
  result.A_forward = forward.accuracy();
  result.E_forward = forward.means.range();
  result.R_forward = forward.repeatability();
  result.A_backward = backward.accuracy();
  result.E_backward = backward.means.range();
  result.R_backward = backward.repeatability();
}

void addBothWays(Iso2302& result) {
  Ranges both;
  Extent means, reversals, repeats;
  double sum = 0.0;
  for (const Iso2302Position& position : result.positions) {
    both.add(*position.forward);
    both.add(*position.backward);
    means.add(*position.mean);
    reversals.add(std::abs(*position.B));
    sum += *position.B;
    if (position.R) repeats.add(*position.R);
  }
  result.A = both.accuracy();
  result.E = both.means.range();
  if (both.has_all_s) result.R = repeats.largest();
  result.M = means.range();
  result.B = reversals.largest();
  result.mean_B = sum / static_cast<double>(result.positions.size());
}

std::size_t fewestApproaches(const std::vector<Iso2302Position>& positions) {
  std::size_t fewest = static_cast<std::size_t>(-1);
  for (const Iso2302Position& position : positions) {
    if (position.forward) fewest = std::min(fewest, position.forward->count);
    if (position.backward) fewest = std::min(fewest, position.backward->count);
  }
  return fewest;
}

/// Standard uncertainty of a value known to lie in an interval of this width.
double fromInterval(double width) { return width / std::sqrt(12.0); }

}  // namespace

Result<Iso2302> evaluateIso2302(const TargetRuns& runs) {
  if (const Result<void> checked = checkTargetRuns(runs); !checked) return checked.error();
  Iso2302 result;
  for (std::size_t i = 0; i < runs.targets.size(); ++i) result.positions.push_back(positionOf(runs, i));
  addOneWay(result);
  if (!runs.forward.empty() && !runs.backward.empty()) addBothWays(result);
  result.fewest_approaches = fewestApproaches(result.positions);
  return result;
}

Iso2302Uncertainty uncertaintyOf(const PositioningCircumstances& c) {
  NL_EXPECTS(c.approaches >= 1);
  const double device = 0.5 * c.device_expanded;
  const double cosine = c.length * c.misalignment * c.misalignment / 2.0;  // from 0 to this
  const double temperature = fromInterval(c.expansion * c.length * c.temperature_range);
  const double expansion = fromInterval(c.expansion_range * c.length) * std::abs(c.temperature_off_20);
  const double along = std::hypot(device, fromInterval(cosine), std::hypot(temperature, expansion));
  const double drift = fromInterval(c.environment_variation);  // of a single reading
  const double n = static_cast<double>(c.approaches);
  Iso2302Uncertainty result;
  result.A = 2.0 * std::hypot(along, drift * std::sqrt(2.0));
  result.E = 2.0 * std::hypot(along, drift * std::sqrt(2.0 / n));
  result.M = 2.0 * std::hypot(along, drift / std::sqrt(n));
  result.R = 4.0 * drift;
  result.B = 2.0 * drift * std::sqrt(2.0 / n);
  return result;
}

}  // namespace nineline::measurement
