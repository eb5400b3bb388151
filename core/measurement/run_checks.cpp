#include "core/measurement/run_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/units.h"
#include "core/measurement/run_profiles.h"

namespace nineline::measurement {

namespace {

constexpr std::size_t kFewestPlaces = 5;   // to compare two profiles
constexpr double kExplained = 0.85;        // share of the variance that a suspicion must explain
constexpr double kFactorTolerance = 0.15;  // relative
constexpr std::size_t kFrozenSamples = 8;  // equal readings in a row
constexpr double kFrozenShare = 0.25;      // of the file, for a sensor

using Profiles = std::vector<std::vector<RunProfile>>;

std::string nameOfRun(const RunSpan& span, std::size_t index) {
  return span.run ? fmt::format("run {:.0f}", *span.run) : fmt::format("run {}", index + 1);
}

RunFault faultAt(const RunSpan& span, std::string code, std::string text, std::string remedy) {
  return {std::move(code), std::move(text), std::move(remedy), span.run,
          span.first + 1,  span.last,       std::nullopt};
}

/// Common places of a profile and a reference, in the order of the profile's visit.
std::pair<std::vector<double>, std::vector<double>> commonOf(const std::map<PlaceKey, double>& reference,
                                                             const RunProfile& profile) {
  std::pair<std::vector<double>, std::vector<double>> common;
  for (const PlaceKey& key : profile.order) {
    const auto known = reference.find(key);
    if (known == reference.end()) continue;
    common.first.push_back(known->second);
    common.second.push_back(profile.readings.at(key));
  }
  return common;
}

/// The reading's factor that explains a likeness; nothing for a run that agrees or that is simply different.
std::optional<double> suspiciousFactor(const Likeness& likeness, double noise) {
  if (likeness.count < kFewestPlaces || likeness.explained < kExplained) return std::nullopt;
  if (likeness.rms_x < 2.0 * noise && likeness.rms_y < 2.0 * noise) return std::nullopt;
  for (const double factor :
       {-1.0, 1000.0, 1e-3, kMillimetresPerInch, 1.0 / kMillimetresPerInch, 10.0, 0.1}) {
    if (std::abs(likeness.factor / factor - 1.0) < kFactorTolerance) return factor;
  }
  return std::nullopt;
}

class RunChecker {
 public:
  RunChecker(const Measurement& measurement, const Machine& machine, const Prediction* prediction)
      : measurement_(measurement), states_(statesOf(measurement, machine)), prediction_(prediction) {
    profiles_ = profilesOf(measurement, states_);
  }

  std::vector<RunFault> check() {
    const std::size_t channels = measurement_.channels.size();
    for (std::size_t run = 0; run < profiles_.size(); ++run) {
      checkTargets(run);
      for (std::size_t channel = 0; channel < channels; ++channel) {
        if (!compareWithOthers(run, channel)) compareWithModel(run, channel);
        checkFrozen(run, channel);
      }
      checkCopies(run);
    }
    checkSensors();
    return std::move(faults_);
  }

 private:
  [[nodiscard]] const RunSpan& span(std::size_t run) const { return profiles_[run].front().span; }
  [[nodiscard]] std::string name(std::size_t run) const { return nameOfRun(span(run), run); }
  [[nodiscard]] double noiseOf(std::size_t channel) const {
    return (measurement_.channels[channel].isAngular() ? measurement_.angular_repeatability
                                                       : measurement_.repeatability)
        .value_or(0.0);
  }

  /// True when something was said about the run.
  bool compareWithOthers(std::size_t run, std::size_t channel) {
    const RunProfile& profile = profiles_[run][channel];
    const std::map<PlaceKey, double> reference = medianOfOthers(profiles_, run, channel);
    const auto [x, y] = commonOf(reference, profile);
    const std::string versus = profiles_.size() == 2 ? "the only other run; one of the two is wrong"
                                                     : "the median of the other runs";
    return checkSwapped(run, channel) || judge(run, channel, x, y, versus);
  }

  void compareWithModel(std::size_t run, std::size_t channel) {
    if (prediction_ == nullptr) return;
    std::vector<double> x;
    std::vector<double> y;
    for (std::size_t i = 0; i < prediction_->rows.size(); ++i) {
      const ReadingRow& row = prediction_->rows[i];
      const bool is_ours =
          row.channel == channel && row.sample >= span(run).first && row.sample < span(run).last;
      if (!is_ours || !row.value || prediction_->is_complete[i] == 0) continue;
      x.push_back(prediction_->readings[static_cast<Eigen::Index>(i)]);
      y.push_back(*row.value);
    }
    judge(run, channel, x, y, "what the model predicts");
  }

  bool judge(std::size_t run, std::size_t channel, const std::vector<double>& x, const std::vector<double>& y,
             const std::string& versus) {
    if (x.size() < kFewestPlaces) return false;
    const std::string column = measurement_.channels[channel].column();
    const Likeness straight = likenessOf(x, y);
    std::vector<double> backwards = y;
    std::reverse(backwards.begin(), backwards.end());
    const Likeness reversed = likenessOf(x, backwards);
    if (const std::optional<double> factor = suspiciousFactor(straight, noiseOf(channel))) {
      const bool sign = *factor == -1.0;
      RunFault fault = faultAt(
          span(run), sign ? "run.sign" : "run.factor",
          sign ? fmt::format("{} of {} has the opposite sign of {}.", column, name(run), versus)
               : fmt::format("{} of {} is about {:.4g} times {} ({:.4g}).", column, name(run), *factor,
                             versus, straight.factor),
          sign ? "Check the sense of the reading; turn the sign of this run if it was noted the wrong way "
                 "round."
               : "Check the unit (mm, um, inch, mil) in which this run was noted.");
      if (sign && reversed.explained > kExplained && std::abs(reversed.factor - 1.0) < kFactorTolerance) {
        fault.text += " Read backwards it agrees as well.";
        fault.remedy = "Check the sense of the reading and the order of the targets of this run.";
      }
      fault.factor = 1.0 / *factor;
      faults_.push_back(std::move(fault));
      return true;
    }
    if (straight.explained < 0.5 && reversed.explained > kExplained &&
        std::abs(reversed.factor - 1.0) < kFactorTolerance && reversed.rms_y > 2.0 * noiseOf(channel)) {
      faults_.push_back(
          faultAt(span(run), "run.reversed",
                  fmt::format("{} of {} read backwards agrees with {}.", column, name(run), versus),
                  "Check the direction of this run; its targets may be listed in the wrong order."));
      return true;
    }
    return false;
  }

  /// A channel that follows another channel of the other runs, not its own.
  bool checkSwapped(std::size_t run, std::size_t channel) {
    if (profiles_.size() < 3) return false;
    const RunProfile& profile = profiles_[run][channel];
    const auto [own_x, own_y] = commonOf(medianOfOthers(profiles_, run, channel), profile);
    if (own_x.size() < kFewestPlaces) return false;
    const Likeness own = likenessOf(own_x, own_y);
    for (std::size_t other = 0; other < measurement_.channels.size(); ++other) {
      if (other == channel) continue;
      const auto [x, y] = commonOf(medianOfOthers(profiles_, run, other), profile);
      const Likeness likeness = likenessOf(x, y);
      if (likeness.explained < kExplained || std::abs(likeness.factor - 1.0) > kFactorTolerance) continue;
      if (likeness.rms_y < 2.0 * noiseOf(channel)) continue;
      if (own.factor > 0.0 && likeness.explained < own.explained + 0.1) continue;
      if (likeness.explained < own.explained) continue;
      faults_.push_back(faultAt(
          span(run), "run.swapped",
          fmt::format("{} of {} follows {} of the other runs.", measurement_.channels[channel].column(),
                      name(run), measurement_.channels[other].column()),
          "Check whether the columns of this run were exchanged."));
      return true;
    }
    return false;
  }

  /// Positions that more than half of the other runs have and this one lacks, or whose reading is missing.
  /// Runs that share no position with this one are another measurement.
  void checkTargets(std::size_t run) {
    std::set<PlaceKey> own;
    for (const PlaceKey& place : profiles_[run].front().order) own.insert(positionOf(place));
    std::map<PlaceKey, std::size_t> counts;
    std::size_t others = 0;
    for (std::size_t other = 0; other < profiles_.size(); ++other) {
      if (other == run) continue;
      std::set<PlaceKey> there;
      for (const PlaceKey& place : profiles_[other].front().order) there.insert(positionOf(place));
      if (std::none_of(there.begin(), there.end(), [&](const PlaceKey& one) { return own.contains(one); }))
        continue;
      ++others;
      for (const PlaceKey& position : there) ++counts[position];
    }
    std::size_t usual = 0;
    std::size_t missing = 0;
    for (const auto& [position, count] : counts) {
      if (2 * count <= others) continue;
      ++usual;
      missing += own.contains(position) ? 0U : 1U;
    }
    if (missing == 0) return;
    faults_.push_back(faultAt(
        span(run), "run.half",
        fmt::format("{} lacks {} of the {} targets that the other runs have.", name(run), missing, usual),
        "Measure the missing targets, or leave the run out where it was broken off."));
  }

  /// Earlier runs with exactly the same readings.
  void checkCopies(std::size_t run) {
    for (std::size_t other = 0; other < run; ++other) {
      bool equal = true;
      std::set<double> values;
      for (std::size_t channel = 0; channel < measurement_.channels.size() && equal; ++channel) {
        equal = profiles_[run][channel].readings == profiles_[other][channel].readings;
        for (const auto& [key, value] : profiles_[run][channel].readings) values.insert(value);
      }
      if (!equal || values.size() < 3) continue;
      faults_.push_back(faultAt(span(run), "run.duplicate",
                                fmt::format("{} holds exactly the readings of {}.", name(run), name(other)),
                                "Remove one of them; a copy makes the scatter look smaller than it is."));
      return;
    }
  }

  /// Equal readings in a row, at different positions, in a channel that varies otherwise.
  void checkFrozen(std::size_t run, std::size_t channel) {
    const RunSpan& whole = span(run);
    std::size_t first = whole.first;
    for (std::size_t i = whole.first + 1; i <= whole.last; ++i) {
      const bool same = i < whole.last && measurement_.reading(i, channel).has_value() &&
                        measurement_.reading(i, channel) == measurement_.reading(first, channel);
      if (same) continue;
      if (i - first >= kFrozenSamples && measurement_.reading(first, channel) &&
          variesElsewhere(channel, first)) {
        RunFault fault = faultAt(whole, "channel.frozen",
                                 fmt::format("{} stands still over {} samples of {}.",
                                             measurement_.channels[channel].column(), i - first, name(run)),
                                 "Check the instrument and repeat these samples.");
        fault.first_row = first + 1;
        fault.last_row = i;
        faults_.push_back(std::move(fault));
      }
      first = i;
    }
  }

  /// True where the channel's readings change from sample to sample in most of the file.
  [[nodiscard]] bool variesElsewhere(std::size_t channel, std::size_t at) const {
    std::size_t changes = 0;
    std::size_t pairs = 0;
    for (std::size_t i = 1; i < measurement_.samples.size(); ++i) {
      if (!measurement_.reading(i, channel) || !measurement_.reading(i - 1, channel)) continue;
      if (measurement_.reading(i, channel) == measurement_.reading(at, channel)) continue;
      ++pairs;
      changes += measurement_.reading(i, channel) != measurement_.reading(i - 1, channel) ? 1U : 0U;
    }
    return pairs >= kFewestPlaces && 2 * changes > pairs;
  }

  /// A temperature that moves and then stops for a large part of the file.
  void checkSensors() {
    for (const Covariate& covariate : measurement_.covariates) {
      if (!covariate.column.starts_with("temp_")) continue;
      std::size_t longest = 0;
      std::size_t longest_first = 0;
      std::size_t first = 0;
      std::set<double> values;
      for (std::size_t i = 0; i <= covariate.values.size(); ++i) {
        if (i < covariate.values.size() && covariate.values[i]) values.insert(*covariate.values[i]);
        if (i < covariate.values.size() && covariate.values[i] == covariate.values[first]) continue;
        if (i - first > longest && covariate.values[first]) {
          longest = i - first;
          longest_first = first;
        }
        first = i;
      }
      const auto count = static_cast<double>(covariate.values.size());
      const bool moves = values.size() > kFrozenSamples &&
                         static_cast<double>(values.size()) > 0.25 * (count - static_cast<double>(longest));
      if (!moves || longest < kFrozenSamples || static_cast<double>(longest) < kFrozenShare * count) continue;
      const std::optional<double> time = measurement_.value("t_s", longest_first);
      RunFault fault{"sensor.frozen",
                     fmt::format("{} stands still over {} samples{}: sensor dead?", covariate.column, longest,
                                 time ? fmt::format(" from t = {:.0f} s", *time) : ""),
                     "Check the sensor; leave its column out where it is dead.",
                     std::nullopt,
                     longest_first + 1,
                     longest_first + longest,
                     std::nullopt};
      faults_.push_back(std::move(fault));
    }
  }

  const Measurement& measurement_;
  std::vector<MachineState> states_;
  const Prediction* prediction_;
  Profiles profiles_;
  std::vector<RunFault> faults_;
};

}  // namespace

std::vector<RunFault> checkRuns(const Measurement& measurement, const Machine& machine,
                                const Prediction* prediction) {
  if (measurement.samples.empty() || measurement.channels.empty()) return {};
  return RunChecker(measurement, machine, prediction).check();
}

}  // namespace nineline::measurement
