#include "core/measurement/iso_230_4.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/units.h"

namespace nineline::measurement {
namespace {

constexpr double kRadius = 150.0;
constexpr double kPicometre = 1e-9;

/// What a ballbar reads when the path is the nominal circle changed by `radial(angle)` about a centre moved
/// by (u, v): exact, from the points.
template <typename Function>
CircularPath pathOf(const Function& radial, double u = 0.0, double v = 0.0, int count = 360,
                    double turns = 1.0) {
  CircularPath path;
  for (int i = 0; i < count; ++i) {
    const double angle = turns * kTurn * i / count;
    const double x = (kRadius + radial(angle)) * std::cos(angle) + u;
    const double y = (kRadius + radial(angle)) * std::sin(angle) + v;
    path.angle.push_back(std::atan2(y, x));
    path.deviation.push_back(std::hypot(x, y) - kRadius);
  }
  return path;
}

TEST(Iso2304, SeesNoDeviationInAShiftedCircle) {
  const auto circle = [](double) { return 0.004; };
  const Result<Iso2304> found = evaluateIso2304({kRadius, std::nullopt, pathOf(circle, 0.05, -0.03)});
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->is_full_circle);
  EXPECT_NEAR(found->all.centre_u, 0.05, kPicometre);
  EXPECT_NEAR(found->all.centre_v, -0.03, kPicometre);
  EXPECT_NEAR(found->all.G, 0.0, kPicometre);
  EXPECT_NEAR(found->D, 0.004, kPicometre);
  EXPECT_NEAR(found->F_max, 0.004, kPicometre);
  EXPECT_NEAR(found->F_min, 0.004, kPicometre);
  EXPECT_NEAR(found->F_max_as_set, std::hypot(0.05, 0.03) + 0.004, 2e-5);  // nearest of 360 points
  EXPECT_FALSE(found->H || found->clockwise);
  ASSERT_TRUE(found->counterclockwise);
}

/// Oval 3 cos 2θ one way, 3 cos 2θ + 1 the other: everything by hand.
TEST(Iso2304, GivesTheFiguresOfTwoPaths) {
  const auto one = [](double angle) { return 3e-3 * std::cos(2.0 * angle); };
  const auto other = [](double angle) { return 3e-3 * std::cos(2.0 * angle) + 1e-3; };
  const Result<Iso2304> found = evaluateIso2304({kRadius, pathOf(one), pathOf(other)});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->clockwise->G, 6e-3, kPicometre);
  EXPECT_NEAR(found->counterclockwise->G, 6e-3, kPicometre);
  EXPECT_NEAR(found->clockwise->G_minimum_zone, 6e-3, kPicometre);  // an oval has its best centre there
  EXPECT_NEAR(found->all.G, 7e-3, kPicometre);
  EXPECT_NEAR(*found->H, 1e-3, kPicometre);
  EXPECT_NEAR(found->D, 0.5e-3, kPicometre);
  EXPECT_NEAR(found->F_max, 4e-3, kPicometre);
  EXPECT_NEAR(found->F_min, -3e-3, kPicometre);
}

/// A single bump shifts the centre of least squares; the minimum zone is the smaller of the two. A bump of
/// height h at one of n points: shifting the centre by a towards it leaves h − a at the bump, and the other
/// points take −a … a: separation max(h, 2a) at the least, so that the least zone is h itself or less.
TEST(Iso2304, FindsAZoneNoWiderThanThatOfLeastSquares) {
  const auto lobes = [](double angle) {
    return 2e-3 * std::cos(3.0 * angle) + 1e-3 * std::sin(2.0 * angle) + (angle < 0.3 ? 5e-3 : 0.0);
  };
  const Result<Iso2304> found = evaluateIso2304({kRadius, pathOf(lobes, 0.01, 0.02), std::nullopt});
  ASSERT_TRUE(found);
  EXPECT_LT(found->all.G_minimum_zone, found->all.G);
  // found independently by nested grids over the centre (evaluation.md)
  EXPECT_NEAR(found->all.G_minimum_zone, 8.133237526e-3, 1e-9);
}

TEST(Iso2304, TakesTheSetCentreOnAnArc) {
  const auto circle = [](double) { return 0.0; };
  const Result<Iso2304> found =
      evaluateIso2304({kRadius, pathOf(circle, 0.05, 0.0, 100, 0.25), std::nullopt});
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->is_full_circle);
  EXPECT_NEAR(found->F_max, 0.05, 1e-5);
  EXPECT_NEAR(found->all.G, 0.0, 1e-8);
}

TEST(Iso2304, RefusesWhatItCannotEvaluate) {
  const auto circle = [](double) { return 0.0; };
  EXPECT_FALSE(evaluateIso2304({0.0, pathOf(circle), std::nullopt}));
  EXPECT_FALSE(evaluateIso2304({kRadius, std::nullopt, std::nullopt}));
  EXPECT_FALSE(evaluateIso2304({kRadius, pathOf(circle, 0, 0, 5), std::nullopt}));
  EXPECT_FALSE(evaluateIso2304({kRadius, pathOf(circle, 0, 0, 20, 1e-6), std::nullopt}));
  CircularPath broken = pathOf(circle);
  broken.deviation[3] = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(evaluateIso2304({kRadius, broken, std::nullopt}));
}

}  // namespace
}  // namespace nineline::measurement
