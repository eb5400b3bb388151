#include "core/simulation/deviation_statistics.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace nineline::simulation {

namespace {
constexpr std::size_t kFixedSums = 5;
}

void DeviationStatistics::Sum::add(double value, double weight) {
  weighted += weight * value;
  weighted_squares += weight * value * value;
  plain += value;
  plain_squares += value * value;
  max = std::max(max, std::abs(value));
}

Figures DeviationStatistics::Sum::figures(double weight, double count) const {
  if (count == 0.0) return {};
  if (weight > 0.0) return {weighted / weight, std::sqrt(weighted_squares / weight), max};
  return {plain / count, std::sqrt(plain_squares / count), max};
}

DeviationStatistics::DeviationStatistics(int joints) : sums_(kFixedSums + static_cast<std::size_t>(joints)) {}

void DeviationStatistics::add(const Deviation& deviation, double tilt, double weight) {
  sums_[0].add(deviation.tip.norm(), weight);
  for (int k = 0; k < 3; ++k) sums_[1 + static_cast<std::size_t>(k)].add(deviation.tip[k], weight);
  sums_[4].add(tilt, weight);
  for (std::size_t j = kFixedSums; j < sums_.size(); ++j)
    sums_[j].add(deviation.joints[j - kFixedSums], weight);
  weight_ += weight;
  ++count_;
}

DeviationSummary DeviationStatistics::summary() const {
  const auto count = static_cast<double>(count_);
  DeviationSummary summary;
  Figures* const fixed[kFixedSums] = {&summary.norm, &summary.x, &summary.y, &summary.z, &summary.axis_tilt};
  for (std::size_t i = 0; i < kFixedSums; ++i) *fixed[i] = sums_[i].figures(weight_, count);
  for (std::size_t j = kFixedSums; j < sums_.size(); ++j)
    summary.joints.push_back(sums_[j].figures(weight_, count));
  summary.length = weight_ > 0.0 ? weight_ : count;
  return summary;
}

Json summaryToJson(const DeviationSummary& summary, const Machine& machine) {
  const auto figures = [](const Figures& f, double factor) {
    Json json = Json::object();
    return json.set("mean", f.mean * factor).set("rms", f.rms * factor).set("max", f.max * factor);
  };
  Json json = Json::object();
  json.set("norm", figures(summary.norm, 1.0)).set("x", figures(summary.x, 1.0));
  json.set("y", figures(summary.y, 1.0)).set("z", figures(summary.z, 1.0));
  for (int j = 0; j < machine.jointCount(); ++j) {
    const double factor = machine.isRotary(j) ? degFromRad(1.0) : 1.0;
    json.set(machine.joint(j).axis.text(), figures(summary.joints[static_cast<std::size_t>(j)], factor));
  }
  return json.set("tool_axis_deg", figures(summary.axis_tilt, degFromRad(1.0)));
}

}  // namespace nineline::simulation
