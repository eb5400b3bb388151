#pragma once

#include "core/estimation/robust.h"

namespace nineline::estimation {

struct FitOptions {
  RobustOptions robust;
  bool estimate_noise = true;  ///< false: noise as stated, no run offsets
  int linearisations = 6;      ///< exact predictions at most
};

/// Parameters that explain the readings best, and how far they are known.
struct Fit {
  VectorXd parameters;
  MatrixXd covariance;  ///< of the parameters, with zeros and run offsets unknown
  NoiseLevels noise;
  VectorXd rest;     ///< by row: what remains of a reading, zero and run offset subtracted; mm, rad
  VectorXd weights;  ///< by row: 0 for an outlier
  VectorXd zeros;
  VectorXd offsets;
  std::vector<double> file_factors;  ///< by file: scatter of its readings by that of their noise class
  double condition_number = 0.0;     ///< of the normal matrix's root, columns scaled to unit length
  int linearisations = 0;
  double last_step = 0.0;  ///< largest change of a prediction in the last step; mm, rad
  [[nodiscard]] std::size_t outliers() const;
};

/// Weighted non-linear least squares by Gauss-Newton on accumulated normal equations: coefficients of the
/// unknowns = map · parameters. The error motions of a machine are so small (1e-4 rad) that the first
/// Jacobian serves all iterations; predictions are exact in each of them, so the answer is that of the exact
/// kinematics. Outliers are found with Huber's loss and then left out, noise levels follow from the readings.
/// Starts at 0. Fails with NoAnswer on parameters that cannot be told apart (see observability.h) and when it
/// does not settle.
[[nodiscard]] Result<Fit> fit(Linearisation& linearisation, const Eigen::SparseMatrix<double>& map,
                              const Precision& prior, const FitOptions& options, Progress& progress);

}  // namespace nineline::estimation
