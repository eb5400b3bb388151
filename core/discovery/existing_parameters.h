#pragma once

#include "core/discovery/campaign.h"

namespace nineline::discovery {

/// One number of the present model that is estimated anew with every hypothesis.
struct ExistingParameter {
  std::size_t effect = 0;  ///< index in the model
  std::string name;        ///< of the parameter; empty: value `node` of a table
  std::size_t node = 0;
  double sigma = 0.0;  ///< prior standard deviation, in its unit (tables: mm, rad)
};

/// The parameters of the present model with their columns and priors, and the zeros of the files, which are
/// free. An existing parameter that drifted is so never taken for a missing effect, and a table that was
/// itself noisy is neither blamed on one nor swallows one.
struct ExistingPart {
  std::vector<ExistingParameter> parameters;
  /// Coefficients: directions of the parameters (unit prior), then the zeros in µm. Only directions that the
  /// readings can tell from the prior are there.
  FixedPart fixed;
  Eigen::MatrixXd directions;  ///< parameters (in prior standard deviations) by coefficient of `fixed`
};

[[nodiscard]] ExistingPart existingPart(const Campaign& campaign);

/// The model with the parameters moved by fitted coefficients (of `fixed`, in order).
[[nodiscard]] Result<ErrorModel> movedModel(const ErrorModel& model, const ExistingPart& part,
                                            const VectorXd& coefficients);

}  // namespace nineline::discovery
