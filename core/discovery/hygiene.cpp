#include "core/discovery/hygiene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/base/units.h"

namespace nineline::discovery {

namespace {

/// One channel of one run: readings, what the model predicts, and the repeatability.
struct Strip {
  std::vector<double> read;
  std::vector<double> predicted;
  double sigma = 1e-4;
};

struct Slope {
  double value = 1.0;
  double error = 1.0;
  bool known = false;
};

double spreadOf(const std::vector<double>& values) {
  double mean = 0.0, squares = 0.0;
  const auto n = static_cast<double>(values.size());
  for (const double v : values) mean += v / n;
  for (const double v : values) squares += (v - mean) * (v - mean) / n;
  return std::sqrt(squares);
}

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Robust slope of readings over predictions, with an offset.
Slope slopeOf(const Strip& strip) {
  constexpr int kRounds = 6;
  constexpr double kCorrelation = 3.0;  // samples to an independent piece
  if (strip.read.size() < 8 || spreadOf(strip.predicted) < 1.5 * strip.sigma) return {};
  std::vector<double> weight(strip.read.size(), 1.0);
  Slope slope;
  for (int round = 0; round < kRounds; ++round) {
    double w = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (std::size_t i = 0; i < weight.size(); ++i) {
      w += weight[i], x += weight[i] * strip.predicted[i], y += weight[i] * strip.read[i];
    }
    x /= w, y /= w;
    for (std::size_t i = 0; i < weight.size(); ++i) {
      xx += weight[i] * (strip.predicted[i] - x) * (strip.predicted[i] - x);
      xy += weight[i] * (strip.predicted[i] - x) * (strip.read[i] - y);
    }
    slope.value = xy / xx;
    std::vector<double> size;
    for (std::size_t i = 0; i < weight.size(); ++i) {
      size.push_back(std::abs(strip.read[i] - y - slope.value * (strip.predicted[i] - x)));
    }
    const double scale = 1.4826 * medianOf(size) + 1e-12;
    for (std::size_t i = 0; i < weight.size(); ++i)
      weight[i] = std::min(1.0, 1.5 * scale / (size[i] + 1e-15));
    slope.error = scale * std::sqrt(kCorrelation / xx);
  }
  slope.known = true;
  return slope;
}

Strip stripOf(const CampaignFile& file, const measurement::RunSpan& run, std::size_t channel, double sigma) {
  Strip strip;
  strip.sigma = sigma;
  for (std::size_t r = 0; r < file.rows.size(); ++r) {
    const measurement::ReadingRow& row = file.rows[r];
    if (row.channel != channel || row.sample < run.first || row.sample >= run.last || !row.value) continue;
    strip.read.push_back(*row.value);
    strip.predicted.push_back(file.predicted[static_cast<Index>(r)]);
    strip.sigma = row.sigma.value_or(sigma);
  }
  return strip;
}

/// What the slope of one run says, when the other runs of its file are as predicted; empty: nothing.
std::string faultOf(const Slope& slope) {
  constexpr std::array<double, 4> kUnits{kMillimetresPerInch, 1.0 / kMillimetresPerInch, 1000.0, 0.001};
  if (slope.value + 4.0 * slope.error < -0.3 &&
      std::abs(slope.value + 1.0) < std::max(0.4, 3.0 * slope.error)) {
    return "the readings have the opposite sign of those of the other runs";
  }
  const double size = std::abs(slope.value);
  for (const double unit : kUnits) {
    if (slope.value > 4.0 * slope.error && std::abs(std::log(size / unit)) < 0.5) {
      return fmt::format("the readings are {:.4g} times as large as those of the other runs: wrong unit?",
                         unit);
    }
  }
  return {};
}

class Checker {
 public:
  explicit Checker(const Campaign& campaign) : campaign_(&campaign) {}

  std::vector<HygieneFinding> all() {
    for (std::size_t f = 0; f < campaign_->files().size(); ++f) {
      const Measurement& file = campaign_->files()[f].measurement;
      spans_ = measurement::runsOf(file);
      for (std::size_t c = 0; c < file.channels.size(); ++c) checkSlopes(f, c);
      for (std::size_t a = 0; a < file.channels.size(); ++a) {
        for (std::size_t b = a + 1; b < file.channels.size(); ++b) checkExchanged(f, a, b);
      }
      checkSensors(f);
    }
    return std::move(found_);
  }

 private:
  void note(std::size_t f, std::size_t first, std::size_t last, std::string text) {
    const DataFault fault{std::move(text), campaign_->files()[f].measurement.source, first + 1, last};
    found_.push_back({fault, f});
  }

  void checkSlopes(std::size_t f, std::size_t channel) {
    std::vector<Slope> slopes;
    std::vector<double> known;
    for (const measurement::RunSpan& run : spans_) {
      slopes.push_back(
          slopeOf(stripOf(campaign_->files()[f], run, channel, campaign_->estimatedSigma(f, channel))));
      if (slopes.back().known) known.push_back(slopes.back().value);
    }
    if (known.size() < 3) return;
    const double usual = medianOf(known);
    if (usual < 0.4 || usual > 2.5) return;
    for (std::size_t s = 0; s < spans_.size(); ++s) {
      if (!slopes[s].known) continue;
      const std::string fault = faultOf(slopes[s]);
      if (!fault.empty()) note(f, spans_[s].first, spans_[s].last, fault);
    }
  }

  /// Misfit of readings of one channel against predictions of another, offsets free.
  [[nodiscard]] static double misfit(const Strip& read, const Strip& predicted) {
    std::vector<double> difference;
    for (std::size_t i = 0; i < std::min(read.read.size(), predicted.predicted.size()); ++i) {
      difference.push_back(read.read[i] - predicted.predicted[i]);
    }
    if (difference.size() < 8) return 0.0;
    const double middle = medianOf(difference);
    for (double& d : difference) d = std::abs(d - middle);
    return 1.4826 * medianOf(difference);
  }

  void checkExchanged(std::size_t f, std::size_t a, std::size_t b) {
    constexpr double kClearly = 0.6;
    std::vector<std::size_t> exchanged;
    for (std::size_t s = 0; s < spans_.size(); ++s) {
      const Strip one = stripOf(campaign_->files()[f], spans_[s], a, campaign_->estimatedSigma(f, a));
      const Strip other = stripOf(campaign_->files()[f], spans_[s], b, campaign_->estimatedSigma(f, b));
      const double own_a = misfit(one, one), own_b = misfit(other, other);
      const double crossed_a = misfit(one, other), crossed_b = misfit(other, one);
      if (crossed_a <= 0.0 || crossed_b <= 0.0) continue;
      if (crossed_a < kClearly * own_a && crossed_b < kClearly * own_b) exchanged.push_back(s);
    }
    if (exchanged.empty() || 2 * exchanged.size() >= spans_.size()) return;
    for (const std::size_t s : exchanged) {
      const Measurement& file = campaign_->files()[f].measurement;
      note(f, spans_[s].first, spans_[s].last,
           fmt::format("{} and {} look exchanged", file.channels[a].column(), file.channels[b].column()));
    }
  }

  [[nodiscard]] static std::size_t distinct(const measurement::Covariate& column, std::size_t first,
                                            std::size_t last) {
    std::set<double> values;
    for (std::size_t i = first; i < last; ++i) {
      if (column.values[i]) values.insert(*column.values[i]);
    }
    return values.size();
  }

  void checkSensors(std::size_t f) {
    constexpr std::size_t kLeast = 12;
    const Measurement& file = campaign_->files()[f].measurement;
    const std::size_t n = file.samples.size();
    for (const measurement::Covariate& column : file.covariates) {
      if (!column.column.starts_with("temp_")) continue;
      std::size_t first = 0, best_first = 0, best_last = 0;
      for (std::size_t i = 1; i <= n; ++i) {
        if (i < n && column.values[i] == column.values[first]) continue;
        if (i - first > best_last - best_first) best_first = first, best_last = i;
        first = i;
      }
      const std::size_t length = best_last - best_first;
      if (length < std::max(kLeast, n / 7) || !column.values[best_first]) continue;
      const std::size_t rest = distinct(column, 0, best_first) + distinct(column, best_last, n);
      if (rest < 8 || !othersLive(file, column, best_first, best_last)) continue;
      const std::optional<double> time = file.value("t_s", best_first);
      note(f, best_first, best_last,
           time ? fmt::format("{} stands still from t = {:.0f} s: sensor dead?", column.column, *time)
                : fmt::format("{} stands still: sensor dead?", column.column));
    }
  }

  /// True when most other temperatures change while one stands still.
  [[nodiscard]] static bool othersLive(const Measurement& file, const measurement::Covariate& still,
                                       std::size_t first, std::size_t last) {
    std::size_t live = 0, all = 0;
    for (const measurement::Covariate& other : file.covariates) {
      if (!other.column.starts_with("temp_") || other.column == still.column) continue;
      ++all;
      live += distinct(other, first, last) >= 5 ? 1 : 0;
    }
    return all > 0 && 2 * live > all;
  }

  const Campaign* campaign_;
  std::vector<measurement::RunSpan> spans_;
  std::vector<HygieneFinding> found_;
};

}  // namespace

std::vector<HygieneFinding> checkData(const Campaign& campaign) { return Checker(campaign).all(); }

bool isFaulty(const std::vector<HygieneFinding>& findings, std::size_t file, std::size_t sample) {
  return std::any_of(findings.begin(), findings.end(), [&](const HygieneFinding& one) {
    return one.file == file && sample + 1 >= one.fault.first_row && sample + 1 <= one.fault.last_row;
  });
}

}  // namespace nineline::discovery
