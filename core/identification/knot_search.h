#pragma once

#include "core/identification/identification.h"

namespace nineline::identification {

/// A fit of everything that the readings tell, and how it was chosen.
struct KnotSearch {
  ParameterSet parameters;
  std::vector<estimation::Telling> tellings;  ///< by chunk
  std::vector<Index> selection;               ///< parameters that take part, of `parameters`
  Eigen::SparseMatrix<double> map;            ///< coefficients by selected parameter
  MatrixXd information;  ///< of all parameters, told or not, before any fit; for the next measurement
  estimation::Fit fit;
  std::vector<int> knot_levels;
};

/// Fits with tables as fine as the readings bear: where targets give the knots they stand there; where
/// positions follow no grid, the number of values per table is the one of smallest Bayesian information
/// criterion. Plays that do not exceed their uncertainty by `play_significance` are dropped. Files that do
/// not state how well they repeat get the sigma that a first fit shows.
[[nodiscard]] Result<KnotSearch> searchKnots(estimation::ReadingSet& readings,
                                             const IdentificationOptions& options, Progress& progress);

}  // namespace nineline::identification
