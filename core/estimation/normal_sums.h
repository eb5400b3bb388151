#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "core/estimation/linearisation.h"

namespace nineline::estimation {

/// What a least squares problem needs of its readings, whatever the level of noise and the share of the run
/// offsets turn out to be. With a_i the row of J of reading i, r_i its residual and w_i = weight_i /
/// sigma_i²:
struct NormalSums {
  std::vector<MatrixXd> matrix;  ///< by noise class: Σ w a aᵀ
  std::vector<VectorXd> right;   ///< by noise class: Σ w a r
  std::vector<double> square;    ///< by noise class: Σ w r²
  std::vector<double> count;     ///< by noise class: readings of weight above 0
  MatrixXd group_columns;        ///< column by run group: Σ w a
  VectorXd group_right;          ///< by run group: Σ w r
  VectorXd group_weight;         ///< by run group: Σ w
  VectorXd group_variance;       ///< by run group: mean sigma_i²

  [[nodiscard]] Index size() const { return group_columns.rows(); }
  /// The same for parameters p with coefficients = map · p.
  [[nodiscard]] NormalSums reduced(const Eigen::SparseMatrix<double>& map) const;
  /// The same for some of the parameters.
  [[nodiscard]] NormalSums selected(const std::vector<Index>& which) const;
};

/// Sums over all readings; `weights` by row, 1 for a sound reading, 0 for one left out.
[[nodiscard]] NormalSums normalSums(const Linearisation& linearisation, const VectorXd& weights);

/// Replaces what depends on the residual when only the residual has changed.
void updateRight(const Linearisation& linearisation, const VectorXd& weights, NormalSums& sums);

}  // namespace nineline::estimation
