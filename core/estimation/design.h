#pragma once

#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/estimation/basis.h"

namespace nineline::estimation {

enum class Criterion {
  D,  ///< smallest volume of the ellipsoid of uncertainty: largest log det of the information
  A   ///< smallest sum of variances, each by its plausible size squared
};

/// What a feasible set-up would add.
struct SetupGain {
  std::size_t setup = 0;
  double d_gain = 0.0;  ///< rise of log det of the information, nats; 0: tells nothing new
  double a_gain = 0.0;  ///< fall of the sum of variances by plausible size squared, 0 … number of parameters
};

/// Chooses the next measurements: greedily the set-up that gains most, then the best one beside it, `count`
/// of them. `known` is the information of the readings at hand (zeros), `setups` that of each set-up that
/// could be made; what is plausible counts as knowledge before any reading, so that parameters that nothing
/// tells yet take part.
[[nodiscard]] std::vector<SetupGain> chooseSetups(const MatrixXd& known, std::span<const MatrixXd> setups,
                                                  const VectorXd& plausible, Criterion criterion,
                                                  std::size_t count);

/// How good positions are for what they are to tell, before anyone measures.
struct PlanQuality {
  double condition_number = 0.0;  ///< of the told combinations; columns of unit length
  Index told = 0;                 ///< parameters that the plan tells
  Index asked = 0;
  VectorXd
      sigma;  ///< expected standard uncertainty of each parameter; its plausible size where nothing tells
  /// Mean of 1 − (sigma / plausible)²: 0 nothing is learnt, 1 all becomes known.
  double quality = 0.0;
};
[[nodiscard]] PlanQuality qualityOf(const MatrixXd& information, const VectorXd& plausible);

}  // namespace nineline::estimation
