#pragma once

#include <Eigen/Core>

#include "core/identification/nine_line.h"

namespace nineline::identification {

/// Readings relative to the datum: one row for each reading, one column for each position; mm.
struct ZeroedReadings {
  Eigen::VectorXd positions;
  Eigen::MatrixXd values;
  Eigen::MatrixXd sigma;
};
[[nodiscard]] ZeroedReadings zeroedReadings(const LineSetup& setup, const LineData& data);

/// All positions and the inclinations of the straightness references in one system. What the inclinations
/// hide is found from the open directions of its matrix; the gauge is: no mean slope in the errors hidden.
[[nodiscard]] Result<LineReport> identifyTogether(const LineSetup& setup, const ZeroedReadings& data,
                                                  std::optional<std::size_t> datum, LineMethod method);

}  // namespace nineline::identification
