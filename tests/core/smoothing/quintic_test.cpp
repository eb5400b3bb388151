#include "core/smoothing/quintic.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nineline::smoothing {
namespace {

TEST(Quintic, TakesItsStatesAtBothEnds) {
  const NodeState start{0.3, -0.2, 1.1};
  const NodeState end{-0.4, 0.7, 0.05};
  const Quintic q = makeQuintic(start, end, 2.5);
  EXPECT_EQ(derivativeAt(q, 0.0, 0), start.value);
  EXPECT_EQ(derivativeAt(q, 0.0, 1), start.slope);
  EXPECT_EQ(derivativeAt(q, 0.0, 2), start.bend);
  EXPECT_NEAR(derivativeAt(q, 2.5, 0), end.value, 1e-14);
  EXPECT_NEAR(derivativeAt(q, 2.5, 1), end.slope, 1e-14);
  EXPECT_NEAR(derivativeAt(q, 2.5, 2), end.bend, 1e-13);
}

TEST(Quintic, NodeStatesAreExactForCubicsParabolasAndLines) {
  for (const std::size_t count : {2U, 3U, 4U, 7U}) {
    std::vector<double> places;
    std::vector<double> values;
    const double cube = count >= 4 ? 0.25 : 0.0;
    const double square = count >= 3 ? -1.5 : 0.0;
    for (std::size_t j = 0; j < count; ++j) {
      const double x = static_cast<double>(j) + 0.1 * static_cast<double>(j % 3);
      places.push_back(x);
      values.push_back(1.0 + 2.0 * x + square * x * x + cube * x * x * x);
    }
    const std::vector<NodeState> states = nodeStates(places, values);
    for (std::size_t j = 0; j < count; ++j) {
      const double x = places[j];
      EXPECT_NEAR(states[j].slope, 2.0 + 2.0 * square * x + 3.0 * cube * x * x, 1e-12) << count;
      EXPECT_NEAR(states[j].bend, 2.0 * square + 6.0 * cube * x, 1e-12) << count;
    }
  }
}

TEST(Quintic, BoundFromTheLineHoldsEverywhere) {
  const Quintic q = makeQuintic({0.0, 0.4, -1.0}, {0.1, -0.3, 2.0}, 1.5);
  const double bound = boundFromLine(q, 1.5);
  double largest = 0.0;
  for (double x = 0.0; x <= 1.5; x += 1e-3)
    largest = std::max(largest, std::abs(derivativeAt(q, x, 0) - 0.1 * x / 1.5));
  EXPECT_GE(bound, largest);
  EXPECT_LT(bound, 3.0 * largest);
}

TEST(SpanPolynomial, BothConventionsGiveTheSameCurve) {
  const std::array<double, 4> b{1.0, 2.5, -0.5, 3.0};
  constexpr double kLength = 2.0;
  const SpanPolynomial p = spanPolynomial(b, kLength);
  const double a1 =
      (p.end - p.start - p.a2 * kLength * kLength - p.a3 * kLength * kLength * kLength) / kLength;
  for (double s = 0.0; s <= 1.0; s += 0.125) {
    const double r = 1.0 - s;
    const double exact = r * r * r * b[0] + 3 * r * r * s * b[1] + 3 * r * s * s * b[2] + s * s * s * b[3];
    const double x = s * kLength;
    EXPECT_NEAR(p.start + x * (a1 + x * (p.a2 + x * p.a3)), exact, 1e-14);
    EXPECT_NEAR(p.end + r * (p.k1 + r * (p.k2 + r * p.k3)), exact, 1e-14);
  }
}

}  // namespace
}  // namespace nineline::smoothing
