#pragma once

#include "core/estimation/mixed_model.h"

namespace nineline::estimation {

/// How readings that do not belong to the rest are dealt with.
struct RobustOptions {
  bool enabled = true;
  double huber = 1.5;  ///< standard deviations within which a reading counts fully while outliers are sought
  double outlier = 4.0;  ///< standard deviations (of what the fit leaves) from which a reading is left out
  int iterations = 6;    ///< reweighted solutions at most
};

/// Weights of Huber's loss: 1 up to `huber` standard deviations, from there falling as 1/|rest|.
[[nodiscard]] VectorXd huberWeights(const ReadingSet& readings, const NoiseLevels& noise,
                                    const VectorXd& rest, double huber);

/// Standard deviations of each class from the median of |rest|, which outliers do not reach; `freedom`:
/// share of the readings that the fit has not used up, by class.
[[nodiscard]] std::vector<double> robustScales(const ReadingSet& readings, const VectorXd& rest,
                                               const std::vector<double>& freedom);

/// 0 for readings whose rest, in its own standard deviation (fittedVariance), exceeds `outlier`, else 1.
[[nodiscard]] VectorXd outlierWeights(const Linearisation& linearisation, const NormalSums& sums,
                                      const NoiseLevels& noise, const Eigen::SparseMatrix<double>& map,
                                      const MixedSolution& solution, const VectorXd& rest,
                                      const VectorXd& weights, double outlier);

/// By file: how far its readings scatter beside the level of their noise classes (1: as far as those). What
/// the fit has taken of each reading is counted. 1 for files with fewer than `kFewReadings` readings to
/// spare.
inline constexpr double kFewReadings = 12.0;
[[nodiscard]] std::vector<double> fileFactors(const Linearisation& linearisation, const NormalSums& sums,
                                              const NoiseLevels& noise,
                                              const Eigen::SparseMatrix<double>& map,
                                              const MixedSolution& solution, const VectorXd& rest,
                                              const VectorXd& weights);

}  // namespace nineline::estimation
