#include "core/discovery/holdout.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace nineline::discovery {

namespace {

constexpr std::size_t kFewestRuns = 4;
constexpr double kWild = 6.0;  // noise levels: a reading farther off both models is an outlier

bool isAsked(const std::optional<double>& run, const std::vector<double>& asked) {
  return run && std::find(asked.begin(), asked.end(), *run) != asked.end();
}

/// Residuals of the held-out rows of one file under one model; absent where nothing can be said.
Result<std::vector<std::optional<double>>> heldResiduals(const ErrorModel& model, const Measurement& file,
                                                         const std::vector<std::uint8_t>& held) {
  const Result<measurement::Prediction> prediction = measurement::predict(model, file);
  if (!prediction) return prediction.error();
  std::vector<std::uint8_t> fitted(prediction->rows.size()), all(prediction->rows.size());
  bool any = false;
  for (std::size_t r = 0; r < fitted.size(); ++r) {
    const bool known = prediction->rows[r].value && prediction->is_complete[r] != 0;
    fitted[r] = known && held[prediction->rows[r].sample] == 0 ? 1 : 0;
    all[r] = known ? 1 : 0;
    any = any || fitted[r] != 0;
  }
  const std::vector<std::optional<double>> zeros =
      measurement::fitZeros(file, prediction->rows, prediction->readings, any ? fitted : all);
  std::vector<std::optional<double>> residuals(prediction->rows.size());
  for (std::size_t r = 0; r < residuals.size(); ++r) {
    const measurement::ReadingRow& row = prediction->rows[r];
    if (all[r] == 0 || held[row.sample] == 0) continue;
    residuals[r] =
        *row.value - prediction->readings[static_cast<Index>(r)] - zeros[row.channel].value_or(0.0);
  }
  return residuals;
}

/// Files of one run each: the last of every four or more of one set-up.
std::vector<bool> lastOfMany(const std::vector<Measurement>& measurements) {
  std::map<std::string, std::vector<std::size_t>> same;
  for (std::size_t f = 0; f < measurements.size(); ++f) {
    const measurement::Instrument& one = measurements[f].instrument;
    if (measurement::runsOf(measurements[f]).size() != 1) continue;
    std::string key(measurement::nameOf(one.kind));
    key += (one.axis ? one.axis->text() : "") + one.plane + std::to_string(one.sensitive) +
           std::to_string(one.about);
    same[key].push_back(f);
  }
  std::vector<bool> last(measurements.size(), false);
  for (const auto& [key, files] : same) {
    if (files.size() >= kFewestRuns) last[files.back()] = true;
  }
  return last;
}

struct Sums {
  double before = 0.0, after = 0.0, noise = 0.0, count = 0.0;
};

}  // namespace

Holdout::Holdout(const std::vector<Measurement>& measurements, const std::vector<double>& asked) {
  const std::vector<bool> whole = lastOfMany(measurements);
  for (std::size_t f = 0; f < measurements.size(); ++f) {
    const Measurement& file = measurements[f];
    std::vector<std::uint8_t> held(file.samples.size(), asked.empty() && whole[f] ? 1 : 0);
    const std::vector<measurement::RunSpan> spans = measurement::runsOf(file);
    for (std::size_t s = 0; s < spans.size(); ++s) {
      const bool last = asked.empty() && spans.size() >= kFewestRuns && s + 1 == spans.size();
      if (!last && !isAsked(spans[s].run, asked)) continue;
      std::fill(held.begin() + static_cast<std::ptrdiff_t>(spans[s].first),
                held.begin() + static_cast<std::ptrdiff_t>(spans[s].last), std::uint8_t{1});
      if (spans[s].run) runs_.push_back(*spans[s].run);
    }
    held_.push_back(std::move(held));
  }
  std::sort(runs_.begin(), runs_.end());
  runs_.erase(std::unique(runs_.begin(), runs_.end()), runs_.end());
}

Result<void> Holdout::judge(const ErrorModel& before, const ErrorModel& after,
                            const std::vector<Measurement>& measurements, const Campaign& campaign,
                            const Noise& noise, Gap& gap) const {
  Sums lengths, angles;
  for (std::size_t f = 0; f < measurements.size(); ++f) {
    if (std::none_of(held_[f].begin(), held_[f].end(), [](std::uint8_t h) { return h != 0; })) continue;
    const Measurement filled = withFilledConditions(measurements[f]);
    const auto old_residuals = heldResiduals(before, filled, held_[f]);
    if (!old_residuals) return old_residuals.error();
    const auto new_residuals = heldResiduals(after, filled, held_[f]);
    if (!new_residuals) return new_residuals.error();
    const std::vector<measurement::ReadingRow> rows = measurement::rowsOf(filled);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const auto& was = (*old_residuals)[r];
      const auto& is = (*new_residuals)[r];
      if (!was || !is) continue;
      const std::optional<int> group = campaign.groupOf(f, rows[r].channel);
      const double level = group ? noise.level[static_cast<std::size_t>(*group)] : 1.0;
      const double sigma = rows[r].sigma.value_or(campaign.estimatedSigma(f, rows[r].channel));
      const double variance = sigma * sigma * level;
      if (*is * *is > kWild * kWild * variance && *was * *was > kWild * kWild * variance) continue;
      Sums& sums = filled.channels[rows[r].channel].isAngular() ? angles : lengths;
      sums.before += *was * *was, sums.after += *is * *is, sums.noise += variance, sums.count += 1.0;
    }
  }
  const bool long_ones = lengths.count > 0.0;
  const Sums& sums = long_ones ? lengths : angles;
  if (sums.count == 0.0) return {};
  const double unit = long_ones ? umFromMm(1.0) : arcsecFromRad(1.0);
  gap.holdout_before = unit * std::sqrt(sums.before / sums.count);
  gap.holdout_after = unit * std::sqrt(sums.after / sums.count);
  gap.holdout_runs = runs_;
  const double reducible = sums.before - sums.noise;
  if (reducible > 0.0) gap.closed_pct = std::min(100.0, 100.0 * (sums.before - sums.after) / reducible);
  return {};
}

}  // namespace nineline::discovery
