#pragma once

#include <Eigen/Core>

namespace nineline::compensation {

/// The point of the perpendicular bisector of the chord a b that lies nearest to `centre`; `centre` itself
/// where the chord is too short to have one (a full circle). Any unit, in the plane of the arc.
[[nodiscard]] Eigen::Vector2d centreBetween(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                                            const Eigen::Vector2d& centre);

/// `value` rounded to a decimal: the double that a reader makes of its text. `decimals` 0…9.
[[nodiscard]] double roundTo(double value, int decimals);

}  // namespace nineline::compensation
