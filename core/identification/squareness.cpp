#include "core/identification/squareness.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace nineline::identification {

Result<SlopeFit> fitSlope(const std::vector<double>& positions, const std::vector<double>& readings) {
  if (positions.size() != readings.size() || positions.size() < 2) {
    return badInput("slope.count",
                    fmt::format("A slope needs two readings; there are {} positions and {} readings.",
                                positions.size(), readings.size()));
  }
  const double count = static_cast<double>(positions.size());
  double mean_q = 0.0, mean_y = 0.0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    mean_q += positions[i] / count;
    mean_y += readings[i] / count;
  }
  double qq = 0.0, qy = 0.0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    qq += (positions[i] - mean_q) * (positions[i] - mean_q);
    qy += (positions[i] - mean_q) * (readings[i] - mean_y);
  }
  if (!std::isfinite(qq + qy)) return badInput("slope.number", "A position or reading is no number.");
  if (!(qq > 0.0))
    return noAnswer("slope.place", "All readings were taken at one position; they have no slope.");
  SlopeFit result;
  result.slope = qy / qq;
  result.intercept = mean_y - result.slope * mean_q;
  double squares = 0.0, largest = 0.0, smallest = 0.0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const double rest = readings[i] - mean_y - result.slope * (positions[i] - mean_q);
    squares += rest * rest;
    largest = i == 0 ? rest : std::max(largest, rest);
    smallest = i == 0 ? rest : std::min(smallest, rest);
  }
  result.straightness = largest - smallest;
  if (positions.size() > 2) result.sigma_slope = std::sqrt(squares / (count - 2.0) / qq);
  return result;
}

Result<Squareness> squarenessOf(char reference_axis, char second_axis, const SlopeFit& of_reference,
                                const SlopeFit& of_second) {
  const int from = reference_axis - 'X', to = second_axis - 'X';
  if (from < 0 || from > 2 || to < 0 || to > 2 || from == to) {
    return badInput("squareness.axes",
                    fmt::format("Squareness is between two of X, Y and Z, not '{}' and '{}'.", reference_axis,
                                second_axis));
  }
  const bool is_cyclic = (from + 1) % 3 == to;
  const double sign = is_cyclic ? -1.0 : 1.0;
  Squareness result;
  result.component = {static_cast<char>('A' + (3 - from - to)), '0', second_axis};
  result.reference = std::string(1, reference_axis);
  result.value = sign * (std::atan(of_reference.slope) + std::atan(of_second.slope));
  result.first_order = sign * (of_reference.slope + of_second.slope);
  result.sigma = std::hypot(of_reference.sigma_slope, of_second.sigma_slope);
  result.between = kPi / 2.0 - (std::atan(of_reference.slope) + std::atan(of_second.slope));
  return result;
}

SpindleParallelism parallelismOf(const MandrelSlopes& slopes, MovingPart moving) {
  const double sign = moving == MovingPart::Mandrel ? 1.0 : -1.0;
  const auto mean = [](const SlopeFit& a, const SlopeFit& b) {
    return 0.5 * (std::atan(a.slope) + std::atan(b.slope));
  };
  const auto half = [](const SlopeFit& a, const SlopeFit& b) {
    return 0.5 * (std::atan(a.slope) - std::atan(b.slope));
  };
  SpindleParallelism result;
  result.A0C = sign * mean(slopes.y_at_0, slopes.y_at_180);
  result.B0C = -sign * mean(slopes.x_at_0, slopes.x_at_180);
  result.mandrel_about_x = sign * half(slopes.y_at_0, slopes.y_at_180);
  result.mandrel_about_y = -sign * half(slopes.x_at_0, slopes.x_at_180);
  for (const auto& [one, other] :
       {std::pair{&slopes.x_at_0, &slopes.x_at_180}, std::pair{&slopes.y_at_0, &slopes.y_at_180}}) {
    result.sigma = std::max(result.sigma, 0.5 * std::hypot(one->sigma_slope, other->sigma_slope));
  }
  return result;
}

}  // namespace nineline::identification
