#include "core/measurement/evaluation_ballbar.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"

namespace nineline::measurement {
namespace {

constexpr double kRadius = 150.0;

struct Planted {
  double scale_x = 30e-6, scale_y = -10e-6;  // mm/mm
  double squareness = 40e-6;                 // C0Y, rad
  double play_x = 4e-3, play_y = 1.5e-3;     // mm
  double lag = 2e-3;                         // mm: travel by which Y lags more than X at the circle's speed
};

/// The path of a tool whose axes err, point by point; nothing of the first-order traces.
CircularPath pathOf(const Planted& planted, double sense) {
  CircularPath path;
  for (int i = 0; i < 360; ++i) {
    const double angle = sense * kTurn * (i + 0.5) / 360.0;
    const double vx = -std::sin(angle) * sense, vy = std::cos(angle) * sense;  // unit speed
    double x = kRadius * std::cos(angle) * (1.0 + planted.scale_x);
    double y = kRadius * std::sin(angle) * (1.0 + planted.scale_y);
    x -= 0.5 * planted.play_x * (vx > 0.0 ? 1.0 : -1.0);
    y -= 0.5 * planted.play_y * (vy > 0.0 ? 1.0 : -1.0) + planted.lag * vy;
    const double tilted_x = x - std::sin(planted.squareness) * y;
    const double tilted_y = std::cos(planted.squareness) * y;
    path.angle.push_back(angle);
    path.deviation.push_back(std::hypot(tilted_x, tilted_y) - kRadius);
  }
  return path;
}

double shareOf(const BallbarShares& shares, const std::string& name) {
  for (const BallbarShare& one : shares.shares) {
    if (one.name == name) return one.value;
  }
  ADD_FAILURE() << name << " is missing";
  return 0.0;
}

TEST(BallbarShares, FindsWhatWasPlanted) {
  const Planted planted;
  const Result<BallbarShares> found =
      ballbarShares({kRadius, pathOf(planted, -1.0), pathOf(planted, 1.0)}, 'X', 'Y');
  ASSERT_TRUE(found) << found.error().text;
  // dr is first order: what is left is the square of the errors over the radius, 1e-7 mm
  EXPECT_NEAR(shareOf(*found, "scale mismatch"), planted.scale_x - planted.scale_y, 5e-9);
  EXPECT_NEAR(shareOf(*found, "squareness"), planted.squareness, 5e-9);
  EXPECT_NEAR(shareOf(*found, "backlash X"), planted.play_x, 1e-6);
  EXPECT_NEAR(shareOf(*found, "backlash Y"), planted.play_y, 1e-6);
  EXPECT_NEAR(shareOf(*found, "servo mismatch"), -0.5 * planted.lag, 1e-6);
  EXPECT_NEAR(shareOf(*found, "radius change"), kRadius * 10e-6, 1e-6);
  EXPECT_LT(found->residual_rms, 1e-6);
}

TEST(BallbarShares, OneSenseHasNoServoMismatch) {
  Planted planted;
  planted.lag = 0.0;
  const Result<BallbarShares> found = ballbarShares({kRadius, std::nullopt, pathOf(planted, 1.0)}, 'X', 'Y');
  ASSERT_TRUE(found);
  EXPECT_NEAR(shareOf(*found, "backlash X"), planted.play_x, 1e-6);
  EXPECT_NEAR(shareOf(*found, "squareness"), planted.squareness, 5e-9);
  for (const BallbarShare& one : found->shares) EXPECT_NE(one.name, "servo mismatch");
}

TEST(BallbarShares, RefusesAShortArc) {
  CircularPath arc = pathOf({}, 1.0);
  arc.angle.resize(30);
  arc.deviation.resize(30);
  EXPECT_FALSE(ballbarShares({kRadius, std::nullopt, arc}, 'X', 'Y'));
}

}  // namespace
}  // namespace nineline::measurement
