#include "core/discovery/wave_scan.h"

#include <algorithm>
#include <cmath>

namespace nineline::discovery {

namespace {

constexpr double kStep = 0.3;  // of the resolution 1 / range
constexpr Index kChunk = 256;  // waves formed at once
constexpr std::size_t kMostWaves = 4000;
constexpr std::size_t kPeaks = 3;
constexpr double kLeastGain = 14.0;

/// The samples of the runs that respond at all.
struct Part {
  std::vector<NoiseRun> runs;  // in the whole
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  double finest = 0.0;  // typical distance of neighbouring arguments
  double run = 0.0;     // typical range of the argument within one run
};

Part activePart(const WaveSite& site, const NoiseModel& model) {
  Part part;
  std::vector<double> steps, ranges;
  for (const NoiseRun& run : model.layout().runs) {
    if (site.response.segment(run.first, run.count).squaredNorm() < 1e-12) continue;
    const auto x = site.argument.segment(run.first, run.count);
    if (x.maxCoeff() - x.minCoeff() < 1e-6) continue;  // a wave stands still there
    part.runs.push_back(run);
    ranges.push_back(x.maxCoeff() - x.minCoeff());
    part.low = std::min(part.low, x.minCoeff());
    part.high = std::max(part.high, x.maxCoeff());
    for (Index i = 1; i < run.count; ++i) {
      const double step = std::abs(x[i] - x[i - 1]);
      if (step > 1e-6) steps.push_back(step);
    }
  }
  if (steps.empty()) return {};
  const auto at = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 10);
  std::nth_element(steps.begin(), at, steps.end());
  part.finest = *at;
  const auto middle = ranges.begin() + static_cast<std::ptrdiff_t>(ranges.size() / 2);
  std::nth_element(ranges.begin(), middle, ranges.end());
  part.run = *middle;
  return part;
}

struct Frequencies {
  double first = 0.0;
  double step = 0.0;
  std::size_t count = 0;
};

/// Gain of the wave pair at every frequency, column by column against the residual; nothing projected out.
/// `coherent` false: every run has its own phase.
VectorXd gainsAt(const WaveSite& site, const Part& part, const NoiseModel& model, const Noise& noise,
                 const VectorXd& residual, const Frequencies& frequencies, bool coherent) {
  const auto count = static_cast<Index>(frequencies.count);
  VectorXd ss = VectorXd::Zero(count), cc = ss, sc = ss, sr = ss, cr = ss, gains = ss;
  const auto flush = [&] {
    for (Index f = 0; f < count; ++f) {
      const double determinant = ss[f] * cc[f] - sc[f] * sc[f];
      if (determinant <= 0.05 * ss[f] * cc[f] || determinant <= 1e-12) continue;
      gains[f] += (sr[f] * sr[f] * cc[f] - 2.0 * sr[f] * cr[f] * sc[f] + cr[f] * cr[f] * ss[f]) / determinant;
    }
    for (VectorXd* sum : {&ss, &cc, &sc, &sr, &cr}) sum->setZero();
  };
  for (const NoiseRun& run : part.runs) {
    const auto group = static_cast<std::size_t>(run.group);
    for (Index from = 0; from < count; from += kChunk) {
      const Index width = std::min(kChunk, count - from);
      RowMatrix waves(run.count, 2 * width);
      for (Index i = 0; i < run.count; ++i) {
        const double x = kTurn * (site.argument[run.first + i] - part.low);
        const double f0 = frequencies.first + static_cast<double>(from) * frequencies.step;
        double s = site.response[run.first + i] * std::sin(x * f0);
        double c = site.response[run.first + i] * std::cos(x * f0);
        const double ds = std::sin(x * frequencies.step), dc = std::cos(x * frequencies.step);
        for (Index f = 0; f < width; ++f) {
          waves(i, f) = s, waves(i, width + f) = c;
          const double next = s * dc + c * ds;
          c = c * dc - s * ds, s = next;
        }
      }
      model.whitenRunAlone(run, noise.shape[group], noise.level[group], waves);
      for (Index i = 0; i < run.count; ++i) {
        const auto sines = waves.row(i).head(width).array().transpose();
        const auto cosines = waves.row(i).tail(width).array().transpose();
        ss.segment(from, width).array() += sines.square();
        cc.segment(from, width).array() += cosines.square();
        sc.segment(from, width).array() += sines * cosines;
      }
      const VectorXd inner = waves.transpose() * residual.segment(run.first, run.count);
      sr.segment(from, width) += inner.head(width);
      cr.segment(from, width) += inner.tail(width);
    }
    if (!coherent) flush();
  }
  if (coherent) flush();
  return gains;
}

/// Positions of the highest peaks, each clear of the others.
std::vector<std::size_t> peaksOf(VectorXd gains, std::size_t most, Index apart, double least) {
  std::vector<std::size_t> peaks;
  while (peaks.size() < most && gains.size() != 0) {
    Index at = 0;
    const double height = gains.maxCoeff(&at);
    if (height < least) break;
    peaks.push_back(static_cast<std::size_t>(at));
    const Index from = std::max<Index>(0, at - apart);
    gains.segment(from, std::min(gains.size() - from, 2 * apart + 1)).setZero();
  }
  return peaks;
}

Frequencies between(double low, double high, double range) {
  Frequencies frequencies{low, kStep / range, 0};
  if (high > low) frequencies.count = static_cast<std::size_t>((high - low) / frequencies.step) + 1;
  frequencies.count = std::min(frequencies.count, kMostWaves);
  return frequencies;
}

std::size_t addOption(EffectLibrary& library, const WaveSite& site, double frequency, double step,
                      double tried) {
  const double value = site.in_time ? frequency : 1.0 / frequency;
  const double width = site.in_time ? step : step / (frequency * frequency);
  if (value < site.low || value > site.high) return 0;
  const std::size_t before = library.bank.options.size();
  library.bank.addOption(site.candidate, {value}, {width}, tried);
  return library.bank.options.size() - before;
}

std::size_t scanPositions(EffectLibrary& library, const WaveSite& site, const Part& part,
                          const NoiseModel& model, const Noise& noise, const VectorXd& residual) {
  const double range = part.high - part.low;
  const double shortest = std::max(site.low, 1.2 * part.finest);
  const Frequencies frequencies = between(std::max(1.0 / site.high, 0.8 / range), 1.0 / shortest, range);
  if (frequencies.count < 3) return 0;
  const VectorXd gains = gainsAt(site, part, model, noise, residual, frequencies, true);
  std::size_t added = 0;
  const double tried = kStep * static_cast<double>(frequencies.count);
  for (const std::size_t peak : peaksOf(gains, kPeaks, 4, kLeastGain)) {
    const double f = frequencies.first + static_cast<double>(peak) * frequencies.step;
    added += addOption(library, site, f, frequencies.step, tried);
  }
  return added;
}

/// Each run with a phase of its own first; then coherently about the best frequencies.
std::size_t scanTimes(EffectLibrary& library, const WaveSite& site, const Part& part, const NoiseModel& model,
                      const Noise& noise, const VectorXd& residual) {
  const double highest = std::min(site.high, 0.6 / part.finest);
  const Frequencies coarse = between(std::max(site.low, 2.0 / part.run), highest, part.run);
  if (coarse.count < 3) return 0;
  const VectorXd sums = gainsAt(site, part, model, noise, residual, coarse, false);
  std::size_t added = 0;
  for (const std::size_t peak :
       peaksOf(sums, 2, 4, kLeastGain + 2.0 * static_cast<double>(part.runs.size()))) {
    const double middle = coarse.first + static_cast<double>(peak) * coarse.step;
    const Frequencies fine =
        between(middle - 2.0 * coarse.step, middle + 2.0 * coarse.step, part.high - part.low);
    const VectorXd gains = gainsAt(site, part, model, noise, residual, fine, true);
    const double tried = kStep * static_cast<double>(fine.count * coarse.count) / 4.0;
    for (const std::size_t best : peaksOf(gains, 1, 4, kLeastGain)) {
      added += addOption(library, site, fine.first + static_cast<double>(best) * fine.step, fine.step, tried);
    }
  }
  return added;
}

}  // namespace

std::size_t scanWaves(EffectLibrary& library, const NoiseModel& model, const Noise& noise,
                      const VectorXd& whitened_residual) {
  std::size_t added = 0;
  for (const WaveSite& site : library.waves) {
    const Part part = activePart(site, model);
    if (part.runs.empty() || !(part.high > part.low)) continue;
    added += site.in_time ? scanTimes(library, site, part, model, noise, whitened_residual)
                          : scanPositions(library, site, part, model, noise, whitened_residual);
  }
  return added;
}

}  // namespace nineline::discovery
