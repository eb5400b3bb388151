#pragma once

#include <array>
#include <span>
#include <vector>

namespace nineline::smoothing {

/// Value, first and second derivative of one axis at a node.
struct NodeState {
  double value = 0.0;
  double slope = 0.0;
  double bend = 0.0;
};

/// Coefficients a0 … a5 of the polynomial that takes these states at 0 and at h (theory.md, 5.5, eq. 14,
/// E22).
using Quintic = std::array<double, 6>;
[[nodiscard]] Quintic makeQuintic(const NodeState& start, const NodeState& end, double h);
/// The derivative of this order 0…5 at x.
[[nodiscard]] double derivativeAt(const Quintic& quintic, double x, int order);

/// Node states of values over ascending places: derivatives of the cubic through nodes j−1 … j+2, clamped to
/// the first and last four; three nodes: the parabola; two: the line (theory.md, 5.5, E22).
[[nodiscard]] std::vector<NodeState> nodeStates(std::span<const double> places,
                                                std::span<const double> values);

/// Bound of the distance of a quintic from the straight line between its ends, from its Bernstein
/// coefficients (theory.md, 5.5).
[[nodiscard]] double boundFromLine(const Quintic& quintic, double h);

/// One span of a cubic curve coordinate by the conventions of two controls (theory.md, 5.7).
struct SpanPolynomial {
  double start = 0.0;
  double end = 0.0;
  double a2 = 0.0, a3 = 0.0;            ///< Siemens POLY, p from 0 to the span's length; a1 is implied
  double k3 = 0.0, k2 = 0.0, k1 = 0.0;  ///< Heidenhain SPL, t from 1 to 0
};
[[nodiscard]] SpanPolynomial spanPolynomial(const std::array<double, 4>& bezier, double length);

}  // namespace nineline::smoothing
