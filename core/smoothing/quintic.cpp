#include "core/smoothing/quintic.h"

#include <algorithm>
#include <cmath>

#include "core/base/contract.h"

namespace nineline::smoothing {

Quintic makeQuintic(const NodeState& start, const NodeState& end, double h) {
  NL_EXPECTS(h > 0.0, h);
  const double way = end.value - start.value;
  const double d0 = start.slope;
  const double d1 = end.slope;
  const double s0 = start.bend;
  const double s1 = end.bend;
  const double h2 = h * h;
  return {start.value,
          d0,
          0.5 * s0,
          (20.0 * way - (8.0 * d1 + 12.0 * d0) * h - (3.0 * s0 - s1) * h2) / (2.0 * h2 * h),
          (-30.0 * way + (14.0 * d1 + 16.0 * d0) * h + (3.0 * s0 - 2.0 * s1) * h2) / (2.0 * h2 * h2),
          (12.0 * way - 6.0 * (d1 + d0) * h - (s0 - s1) * h2) / (2.0 * h2 * h2 * h)};
}

double derivativeAt(const Quintic& quintic, double x, int order) {
  NL_EXPECTS(order >= 0 && order <= 5, order);
  double value = 0.0;
  for (int k = 5; k >= order; --k) {
    double factor = 1.0;
    for (int i = 0; i < order; ++i) factor *= k - i;
    value = value * x + factor * quintic[static_cast<std::size_t>(k)];
  }
  return value;
}

std::vector<NodeState> nodeStates(std::span<const double> places, std::span<const double> values) {
  NL_EXPECTS(places.size() == values.size() && places.size() >= 2, places.size());
  const std::size_t count = places.size();
  const std::size_t used = std::min<std::size_t>(count, 4);
  std::vector<NodeState> states(count);
  for (std::size_t j = 0; j < count; ++j) {
    const std::size_t first = std::min(j > 0 ? j - 1 : 0, count - used);
    std::array<double, 4> c{};  // divided differences
    for (std::size_t k = 0; k < used; ++k) c[k] = values[first + k];
    for (std::size_t level = 1; level < used; ++level) {
      for (std::size_t k = used - 1; k >= level; --k)
        c[k] = (c[k] - c[k - 1]) / (places[first + k] - places[first + k - level]);
    }
    NodeState state;  // Horner on the Newton form, derivatives carried along
    for (std::size_t k = used; k-- > 0;) {
      const double x = places[j] - places[first + k];
      state.bend = state.bend * x + 2.0 * state.slope;
      state.slope = state.slope * x + state.value;
      state.value = state.value * x + c[k];
    }
    states[j] = state;
    states[j].value = values[j];
  }
  return states;
}

double boundFromLine(const Quintic& quintic, double h) {
  constexpr std::array<std::array<double, 6>, 6> kBinomial{{{1, 0, 0, 0, 0, 0},
                                                            {1, 1, 0, 0, 0, 0},
                                                            {1, 2, 1, 0, 0, 0},
                                                            {1, 3, 3, 1, 0, 0},
                                                            {1, 4, 6, 4, 1, 0},
                                                            {1, 5, 10, 10, 5, 1}}};
  std::array<double, 6> bernstein{};
  for (std::size_t i = 0; i < 6; ++i) {
    double power = 1.0;
    for (std::size_t k = 0; k <= i; ++k, power *= h)
      bernstein[i] += kBinomial[i][k] / kBinomial[5][k] * quintic[k] * power;
  }
  double bound = 0.0;
  for (std::size_t i = 0; i < 6; ++i) {
    const double line = bernstein[0] + (bernstein[5] - bernstein[0]) * static_cast<double>(i) / 5.0;
    bound = std::max(bound, std::abs(bernstein[i] - line));
  }
  return bound;
}

SpanPolynomial spanPolynomial(const std::array<double, 4>& b, double length) {
  NL_EXPECTS(length > 0.0, length);
  const double c1 = 3.0 * (b[1] - b[0]);
  const double c2 = 3.0 * (b[2] - 2.0 * b[1] + b[0]);
  const double c3 = b[3] - 3.0 * b[2] + 3.0 * b[1] - b[0];
  return {b[0], b[3],          c2 / (length * length),     c3 / (length * length * length),
          -c3,  c2 + 3.0 * c3, -(c1 + 2.0 * c2 + 3.0 * c3)};
}

}  // namespace nineline::smoothing
