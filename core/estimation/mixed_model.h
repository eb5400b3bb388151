#pragma once

#include "core/estimation/normal_sums.h"

namespace nineline::estimation {

/// Noise of a reading i of class c in run group g: white, standard deviation scale_c · sigma_i, and one
/// offset for the whole run, variance ratio_c · scale_c² · (mean sigma_i² of the group).
struct NoiseLevels {
  std::vector<double> scale;
  std::vector<double> ratio;
};

/// What is known of the parameters without any reading: Gaussian about 0 with this precision (1/variance).
using Precision = MatrixXd;

/// The parameters, the zeros of the files and the offsets of the runs that explain the readings best.
struct MixedSolution {
  VectorXd step;        ///< of the parameters, from the point of the linearisation
  VectorXd zeros;       ///< by ReadingSet zero; mm, rad
  VectorXd offsets;     ///< by run group; mm, rad
  MatrixXd covariance;  ///< of parameters and zeros; empty where it was not asked for
};

/// Best linear unbiased prediction: minimises Σ w (r − a·step − zero − offset)² / scale² plus the priors of
/// parameters and offsets. Run offsets and zeros are projected out of the normal equations, so that every
/// uncertainty holds with them unknown. `at`: parameters at the point of the linearisation. Fails with
/// NoAnswer when parameters cannot be told apart.
[[nodiscard]] Result<MixedSolution> solve(const ReadingSet& readings, const NormalSums& sums,
                                          const NoiseLevels& noise, const Precision& prior,
                                          const VectorXd& at, bool with_covariance);

/// The normal matrix of the parameters alone, zeros and offsets projected out.
[[nodiscard]] MatrixXd information(const ReadingSet& readings, const NormalSums& sums,
                                   const NoiseLevels& noise);

/// What remains of each reading: r − change − zero − offset; `change`: J step, by row.
[[nodiscard]] VectorXd restOf(const Linearisation& linearisation, const VectorXd& change,
                              const MixedSolution& solution);

/// Variance of what is fitted to a reading of a run group, its zero and run offset included; `a`: the
/// reading's row, by parameter. The rest of a reading in the fit has the variance of its noise less this,
/// that of a reading left out the sum of both. Requires a solution with covariance.
[[nodiscard]] double fittedVariance(const ReadingSet& readings, const NormalSums& sums,
                                    const NoiseLevels& noise, const MixedSolution& solution,
                                    const VectorXd& a, std::size_t group);

/// Noise levels of largest restricted likelihood, one fixed-point step (D. MacKay's form of EM; degrees of
/// freedom spent on parameters, zeros and offsets are counted). Where the readings say little the stated
/// level counts as much as `kStatedFreedom` readings would.
inline constexpr double kStatedFreedom = 4.0;
[[nodiscard]] NoiseLevels updatedNoise(const ReadingSet& readings, const NormalSums& sums,
                                       const NoiseLevels& noise, const MixedSolution& solution,
                                       const VectorXd& rest, const VectorXd& weights);

/// White noise as stated and run offsets of the usual share: the start.
[[nodiscard]] NoiseLevels usualNoise(const ReadingSet& readings);

}  // namespace nineline::estimation
