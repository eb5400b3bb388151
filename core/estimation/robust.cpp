#include "core/estimation/robust.h"

#include <algorithm>

#include "core/base/units.h"

namespace nineline::estimation {

namespace {

constexpr double kMedianToSigma = 1.4826;  // of a normal distribution
// Below these no reading is an outlier: what one linearisation leaves of exact readings (1e-4 rad squared).
constexpr double kLeastOutlier = 2.0 * kNanometre;  // mm
constexpr double kLeastAngle = 1e-8;                // rad

constexpr double kSuspicious = 0.5;      // of the limit: a smaller rest is not looked at more closely
constexpr double kLeastVariance = 0.15;  // of a rest: where the fit takes more, no reading can be judged
constexpr double kMostWork = 4e9;        // products; with more readings what the fit takes does not matter

double leastSigma(const NoiseClass& noise) { return noise.angular ? kLeastAngle : kLeastOutlier; }

}  // namespace

VectorXd huberWeights(const ReadingSet& readings, const NoiseLevels& noise, const VectorXd& rest,
                      double huber) {
  VectorXd weights(rest.size());
  for (std::size_t row = 0; row < readings.rows(); ++row) {
    const std::size_t c = readings.noiseOf(row);
    const double sigma =
        std::max(noise.scale[c] * readings.readings()[row].sigma, leastSigma(readings.classes()[c]));
    const double size = std::abs(rest[static_cast<Index>(row)]) / sigma;
    weights[static_cast<Index>(row)] = size <= huber ? 1.0 : huber / size;
  }
  return weights;
}

std::vector<double> robustScales(const ReadingSet& readings, const VectorXd& rest,
                                 const std::vector<double>& freedom) {
  std::vector<std::vector<double>> sizes(readings.classes().size());
  for (std::size_t row = 0; row < readings.rows(); ++row) {
    sizes[readings.noiseOf(row)].push_back(std::abs(rest[static_cast<Index>(row)]) /
                                           readings.readings()[row].sigma);
  }
  std::vector<double> scales;
  for (std::size_t c = 0; c < sizes.size(); ++c) {
    double scale = 1.0;
    if (!sizes[c].empty()) {
      const auto middle = sizes[c].begin() + static_cast<std::ptrdiff_t>(sizes[c].size() / 2);
      std::nth_element(sizes[c].begin(), middle, sizes[c].end());
      scale = kMedianToSigma * *middle / std::sqrt(std::clamp(freedom[c], 0.1, 1.0));
    }
    scales.push_back(std::max(scale, 1e-6));
  }
  return scales;
}

std::vector<double> fileFactors(const Linearisation& linearisation, const NormalSums& sums,
                                const NoiseLevels& noise, const Eigen::SparseMatrix<double>& map,
                                const MixedSolution& solution, const VectorXd& rest,
                                const VectorXd& weights) {
  const ReadingSet& readings = linearisation.readings();
  const Eigen::SparseMatrix<double> transposed = map.transpose();
  const bool counts =
      static_cast<double>(readings.rows()) * static_cast<double>(map.cols() * map.cols()) < kMostWork;
  std::vector<double> square(readings.files().size(), 0.0);
  std::vector<double> freedom(readings.files().size(), 0.0);
  for (std::size_t row = 0; row < readings.rows(); ++row) {
    const auto at = static_cast<Index>(row);
    if (weights[at] <= 0.0) continue;
    const ReadingPlace& reading = readings.readings()[row];
    const RunGroup& group = readings.groups()[reading.group];
    const double sigma = noise.scale[group.noise] * reading.sigma;
    square[group.file] += rest[at] * rest[at] / (sigma * sigma);
    freedom[group.file] += 1.0;
    if (!counts) continue;
    const VectorXd a = transposed * linearisation.row(row);
    const double fitted = fittedVariance(readings, sums, noise, solution, a, reading.group);
    freedom[group.file] -= std::min(1.0, fitted / (sigma * sigma));
  }
  std::vector<double> factors(square.size(), 1.0);
  for (std::size_t file = 0; file < square.size(); ++file) {
    if (freedom[file] < kFewReadings || square[file] <= 0.0) continue;
    factors[file] = std::clamp(std::sqrt(square[file] / freedom[file]), 0.05, 20.0);
  }
  return factors;
}

VectorXd outlierWeights(const Linearisation& linearisation, const NormalSums& sums, const NoiseLevels& noise,
                        const Eigen::SparseMatrix<double>& map, const MixedSolution& solution,
                        const VectorXd& rest, const VectorXd& weights, double outlier) {
  const ReadingSet& readings = linearisation.readings();
  const Eigen::SparseMatrix<double> transposed = map.transpose();
  VectorXd out = VectorXd::Ones(rest.size());
  for (std::size_t row = 0; row < readings.rows(); ++row) {
    const ReadingPlace& reading = readings.readings()[row];
    const RunGroup& group = readings.groups()[reading.group];
    const double sigma =
        std::max(noise.scale[group.noise] * reading.sigma, leastSigma(readings.classes()[group.noise]));
    const auto at = static_cast<Index>(row);
    const double size = std::abs(rest[at]) / sigma;
    if (size < kSuspicious * outlier) continue;
    const VectorXd a = transposed * linearisation.row(row);
    const double fitted = fittedVariance(readings, sums, noise, solution, a, reading.group) / (sigma * sigma);
    const double variance = weights[at] > 0.5 ? std::max(kLeastVariance, 1.0 - fitted) : 1.0 + fitted;
    if (size > outlier * std::sqrt(variance)) out[at] = 0.0;
  }
  return out;
}

}  // namespace nineline::estimation
