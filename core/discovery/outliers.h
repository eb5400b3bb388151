#pragma once

#include "core/discovery/noise_model.h"

namespace nineline::discovery {

/// Single wrong readings: far from what all others of the run say, and far from their neighbours in time, so
/// that a step or a drift is none. At most 6 % of the samples. Residuals in units of the repeatability.
[[nodiscard]] std::vector<bool> findOutliers(const NoiseModel& model, const Noise& noise,
                                             const VectorXd& residual);

}  // namespace nineline::discovery
