#include "core/compensation/arc_geometry.h"

#include <array>
#include <cmath>

#include "core/base/contract.h"

namespace nineline::compensation {

Eigen::Vector2d centreBetween(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                              const Eigen::Vector2d& centre) {
  const Eigen::Vector2d chord = b - a;
  const double length = chord.norm();
  if (length < 0.1 * (a - centre).norm()) return centre;
  const Eigen::Vector2d along = chord / length;
  return centre - along * along.dot(centre - 0.5 * (a + b));
}

double roundTo(double value, int decimals) {
  static constexpr std::array<double, 10> kPowers = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
  NL_EXPECTS(decimals >= 0 && decimals <= 9, decimals);
  const double power = kPowers[static_cast<std::size_t>(decimals)];
  return std::round(value * power) / power;
}

}  // namespace nineline::compensation
