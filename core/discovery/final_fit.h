#pragma once

#include "core/discovery/selection.h"

namespace nineline::discovery {

/// Joint estimate of existing parameters, effects and noise, with everything that is needed to report it.
struct FinalFit {
  Hypotheses::Verdict verdict;
  /// Parameters of each member of the set with their uncertainties, non-linear ones included.
  std::vector<std::vector<errors::Parameter>> parameters;
  std::vector<VectorXd> contributions;  ///< of each member to every reading, in repeatabilities
};

/// Generalised least squares with the noise of largest likelihood; the covariance counts the non-linear
/// parameters as free and is widened where the residuals of whole runs say so.
[[nodiscard]] FinalFit finalFit(const Selection& selection);

/// The effect of a member with fitted parameters. Members are named ones.
[[nodiscard]] Result<errors::EffectPtr> effectOf(const Selection& selection, std::size_t option,
                                                 const std::vector<errors::Parameter>& parameters,
                                                 const std::string& when);

}  // namespace nineline::discovery
