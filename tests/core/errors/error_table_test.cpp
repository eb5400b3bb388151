#include "core/errors/error_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/units.h"
#include "tests/support/random_machines.h"

namespace nineline::errors {
namespace {

using test_support::Random;

ErrorTable table(const ErrorTable::Grid& grid, std::vector<double> values) {
  return ErrorTable::make(grid, std::move(values)).value();
}

std::vector<double> randomValues(std::size_t count) {
  Random random(41);
  std::vector<double> values(count);
  for (double& value : values) value = random.between(-0.01, 0.01);
  return values;
}

TEST(ErrorTable, LinearByHand) {
  const ErrorTable t = table({10.0, 5.0, Interpolation::Linear, {}}, {1.0, 3.0, 2.0});
  EXPECT_DOUBLE_EQ(t.value(12.5), 2.0);
  EXPECT_DOUBLE_EQ(t.value(19.0), 2.2);
  EXPECT_DOUBLE_EQ(t.slope(12.0), 0.4);
  EXPECT_DOUBLE_EQ(t.slope(17.0), -0.2);
  EXPECT_DOUBLE_EQ(t.end(), 20.0);
}

TEST(ErrorTable, NaturalCubicByHand) {
  // Through (0,0) (1,1) (2,0): m1 = -3, s(t) = 1.5 t - 0.5 t^3 on the first half.
  const ErrorTable t = table({0.0, 1.0, Interpolation::Cubic, {}}, {0.0, 1.0, 0.0});
  EXPECT_DOUBLE_EQ(t.value(0.5), 0.6875);
  EXPECT_DOUBLE_EQ(t.value(1.5), 0.6875);
  EXPECT_DOUBLE_EQ(t.slope(0.0), 1.5);
  EXPECT_DOUBLE_EQ(t.slope(1.0), 0.0);
}

TEST(ErrorTable, OneAndTwoValues) {
  const ErrorTable one = table({5.0, 1.0, Interpolation::Cubic, {}}, {0.25});
  for (const double x : {-100.0, 5.0, 7.0}) {
    EXPECT_EQ(one.value(x), 0.25);
    EXPECT_EQ(one.slope(x), 0.0);
  }
  EXPECT_TRUE(one.covers(5.0));
  EXPECT_FALSE(one.covers(5.1));
  const ErrorTable two = table({0.0, 4.0, Interpolation::Cubic, {}}, {1.0, 3.0});
  EXPECT_DOUBLE_EQ(two.value(1.0), 1.5);
  EXPECT_DOUBLE_EQ(two.slope(3.0), 0.5);
}

TEST(ErrorTable, EndValuesAreHeldOutside) {
  const ErrorTable t = table({0.0, 1.0, Interpolation::Cubic, {}}, {3.0, 1.0, 2.0});
  EXPECT_EQ(t.value(-7.0), 3.0);
  EXPECT_DOUBLE_EQ(t.value(70.0), 2.0);
  EXPECT_EQ(t.slope(-7.0), 0.0);
  EXPECT_EQ(t.slope(70.0), 0.0);
  EXPECT_FALSE(t.covers(-0.001));
  EXPECT_TRUE(t.covers(2.0));
}

TEST(ErrorTable, CubicIsTwiceContinuouslyDifferentiableAtItsNodes) {
  for (const bool periodic : {false, true}) {
    for (const std::size_t count : {2U, 3U, 4U, 24U}) {
      ErrorTable::Grid grid{-2.0, 0.5, Interpolation::Cubic, {}};
      if (periodic) grid.period = 0.5 * static_cast<double>(count);
      const ErrorTable t = table(grid, randomValues(count));
      const std::size_t segments = t.segmentCount();
      for (std::size_t i = 0; i + (periodic ? 0 : 1) < segments; ++i) {
        const ErrorTable::Cubic& a = t.coefficients(i);
        const ErrorTable::Cubic& b = t.coefficients((i + 1) % segments);
        constexpr double h = 0.5;
        EXPECT_NEAR(a.c0 + h * (a.c1 + h * (a.c2 + h * a.c3)), b.c0, 1e-16) << count;
        EXPECT_NEAR(a.c1 + h * (2 * a.c2 + 3 * h * a.c3), b.c1, 1e-15) << count;
        EXPECT_NEAR(a.c2 + 3 * h * a.c3, b.c2, 1e-15) << count;
      }
      if (periodic) continue;
      EXPECT_EQ(t.coefficients(0).c2, 0.0);  // natural ends
      const ErrorTable::Cubic& last = t.coefficients(segments - 1);
      EXPECT_NEAR(last.c2 + 3 * 0.5 * last.c3, 0.0, 1e-15);
    }
  }
}

TEST(ErrorTable, PeriodicTablesWrapForNegativePositionsAndManyTurns) {
  const ErrorTable t = table({0.0, kTurn / 24, Interpolation::Cubic, kTurn}, randomValues(24));
  for (const double x : {0.0, 0.01, 1.0, 3.0, 6.28}) {
    for (const double turns : {-1000.0, -3.0, -1.0, 1.0, 7.0, 1000.0}) {
      EXPECT_NEAR(t.value(x + turns * kTurn), t.value(x), 1e-13) << x << " " << turns;
      EXPECT_NEAR(t.slope(x + turns * kTurn), t.slope(x), 1e-11) << x << " " << turns;
    }
  }
  EXPECT_NEAR(t.value(-1e-18), t.values()[0], 1e-16);
  EXPECT_TRUE(t.covers(-500.0));
}

TEST(ErrorTable, ACoarselyStatedSpacingStillClosesTheTurn) {
  const ErrorTable t = table({0.0, radFromDeg(51.42857), Interpolation::Cubic, kTurn}, randomValues(7));
  EXPECT_DOUBLE_EQ(t.grid().spacing, kTurn / 7.0);
  EXPECT_NEAR(t.value(kTurn - 1e-9), t.value(0.0), 1e-10);
}

TEST(ErrorTable, APeriodicCubicFollowsASine) {
  std::vector<double> values(72);
  for (std::size_t i = 0; i < 72; ++i) values[i] = std::sin(kTurn * static_cast<double>(i) / 72.0);
  const ErrorTable t = table({0.0, kTurn / 72, Interpolation::Cubic, kTurn}, values);
  for (double x = -3.0; x < 9.0; x += 0.0137) EXPECT_NEAR(t.value(x), std::sin(x), 1e-6);
}

TEST(ErrorTable, SlopeAgreesWithCentralDifferences) {
  Random random(42);
  const ErrorTable natural = table({-50.0, 10.0, Interpolation::Cubic, {}}, randomValues(11));
  const ErrorTable turn = table({0.3, kTurn / 12, Interpolation::Cubic, kTurn}, randomValues(12));
  for (int k = 0; k < 100; ++k) {
    const double x = random.between(-49.9, 49.9);
    EXPECT_NEAR((natural.value(x + 1e-4) - natural.value(x - 1e-4)) / 2e-4, natural.slope(x), 1e-10);
    EXPECT_NEAR((turn.value(x + 1e-5) - turn.value(x - 1e-5)) / 2e-5, turn.slope(x), 1e-8);
  }
}

TEST(ErrorTable, RefusesBadGridsAndValues) {
  const double nan = std::nan("");
  const double inf = std::numeric_limits<double>::infinity();
  const auto code = [](const ErrorTable::Grid& grid, std::vector<double> values) {
    const Result<ErrorTable> t = ErrorTable::make(grid, std::move(values));
    return t ? std::string("fine") : t.error().code;
  };
  EXPECT_EQ(code({0, 1, Interpolation::Cubic, {}}, {}), "table.empty");
  EXPECT_EQ(code({nan, 1, Interpolation::Cubic, {}}, {1}), "table.start");
  EXPECT_EQ(code({0, 0, Interpolation::Cubic, {}}, {1, 2}), "table.spacing");
  EXPECT_EQ(code({0, -1, Interpolation::Cubic, {}}, {1, 2}), "table.spacing");
  EXPECT_EQ(code({0, nan, Interpolation::Cubic, {}}, {1, 2}), "table.spacing");
  EXPECT_EQ(code({0, inf, Interpolation::Cubic, {}}, {1, 2}), "table.spacing");
  EXPECT_EQ(code({0, 1, Interpolation::Linear, {}}, {1, nan}), "table.value");
  EXPECT_EQ(code({0, 1, Interpolation::Cubic, 3.0}, {1, 2}), "table.period");
  EXPECT_EQ(code({0, 1, Interpolation::Cubic, nan}, {1, 2}), "table.period");
  EXPECT_EQ(code({0, 1, Interpolation::Cubic, 2.0}, {1, 2}), "fine");
}

}  // namespace
}  // namespace nineline::errors
