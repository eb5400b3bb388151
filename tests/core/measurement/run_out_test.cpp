#include "core/measurement/run_out.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"

namespace nineline::measurement {
namespace {

TEST(RunOut, TellsEccentricityFromLobes) {
  std::vector<double> angles, readings;
  for (int i = 0; i < 72; ++i) {
    const double angle = kTurn * i / 72.0;
    angles.push_back(angle);
    readings.push_back(0.25 + 4e-3 * std::cos(angle + 0.7) + 1e-3 * std::cos(3.0 * angle - 1.2));
  }
  const Result<RunOut> found = evaluateRunOut(angles, readings);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->mean, 0.25, 1e-14);
  EXPECT_NEAR(found->once_per_turn.amplitude, 4e-3, 1e-14);
  EXPECT_NEAR(found->once_per_turn.phase, 0.7, 1e-12);
  EXPECT_NEAR(found->harmonics[1].amplitude, 1e-3, 1e-14);
  EXPECT_NEAR(found->harmonics[1].phase, -1.2, 1e-11);
  EXPECT_NEAR(found->harmonics[0].amplitude, 0.0, 1e-14);
  EXPECT_NEAR(found->without_eccentricity, 2e-3 * std::cos(radFromDeg(75.0) - 1.2),
              1e-14);  // 15° of the lobe from angle to angle: the nearest to its peak is 75°
  EXPECT_NEAR(found->total, 7.389933497e-3, 1e-12);  // largest − smallest of the 72 numbers
  EXPECT_EQ(found->turns, 1U);
}

TEST(RunOut, TellsTurnsApart) {
  std::vector<double> angles, readings;
  for (int turn = 0; turn < 3; ++turn) {
    for (int i = 0; i < 12; ++i) {
      const double angle = kTurn * (turn + i / 12.0);
      angles.push_back(angle);
      readings.push_back(1e-3 * std::cos(angle) + 2e-3 * std::cos(2.0 * angle) + 0.5e-3 * turn);
    }
  }
  const Result<RunOut> found = evaluateRunOut(angles, readings);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->turns, 3U);
  EXPECT_NEAR(found->asynchronous, 1e-3, 1e-12);
  EXPECT_NEAR(found->synchronous, 4e-3, 1e-12);
  EXPECT_NEAR(found->without_eccentricity, 5e-3, 1e-12);
}

TEST(RunOut, TakesUnequalAngles) {
  std::vector<double> angles, readings;
  for (const double angle_deg : {0.0, 10.0, 55.0, 120.0, 130.0, 200.0, 201.0, 300.0, 350.0}) {
    angles.push_back(radFromDeg(angle_deg));
    readings.push_back(2e-3 * std::sin(angles.back()));
  }
  const Result<RunOut> found = evaluateRunOut(angles, readings, 2);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->once_per_turn.amplitude, 2e-3, 1e-14);
  EXPECT_NEAR(found->once_per_turn.phase, -kPi / 2.0, 1e-11);
  EXPECT_NEAR(found->without_eccentricity, 0.0, 1e-14);
}

TEST(RunOut, RefusesTooFewAngles) {
  EXPECT_FALSE(evaluateRunOut({0.0, kTurn, 2.0 * kTurn, 1.0, 2.0}, {0, 0, 0, 0, 0}));
  EXPECT_FALSE(evaluateRunOut({0.0, 1.0}, {0.0}));
  EXPECT_FALSE(evaluateRunOut({0.0, 1.0, 2.0, 3.0}, {0.0, 1.0, NAN, 0.0}));
}

}  // namespace
}  // namespace nineline::measurement
