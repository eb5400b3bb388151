#pragma once

#include <span>
#include <vector>

namespace nineline::smoothing {

/// Limits of the spans of a first, coarse fit: `parameters` of the data ascending, at most `most` spans.
[[nodiscard]] std::vector<double> firstLimits(std::span<const double> parameters, std::size_t most);

/// New limits with equal shares of the error: the error of a cubic least-squares spline grows with the fourth
/// power of the span, so that a span whose error is `ratio` of the allowed one takes (ratio / aim)^¼ spans of
/// the next fit. Every span holds a data parameter and lies on the grid of knots.
[[nodiscard]] std::vector<double> redistribute(std::span<const double> limits, std::span<const double> ratios,
                                               double aim, std::span<const double> parameters,
                                               std::size_t most);

/// The limits with one more in the middle of each span whose ratio is above 1, as far as data and `most`
/// allow.
[[nodiscard]] std::vector<double> splitFailing(std::span<const double> limits, std::span<const double> ratios,
                                               std::span<const double> parameters, std::size_t most);

}  // namespace nineline::smoothing
