#include "core/identification/circle_offsets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/kinematics/rotation.h"
#include "tests/support/random_machines.h"

namespace nineline::identification {
namespace {

using test_support::Random;

/// A C axis displaced and tilted as the model's location errors do it, with a ball at `ball` on the table.
CirclePoints circleOf(const SmallMotion& location, const Vector3d& ball, double from_deg, double to_deg,
                      int count) {
  CirclePoints points;
  const Matrix3d R_FL = kinematics::exponential(location.rotation);
  for (int i = 0; i < count; ++i) {
    const double angle = radFromDeg(from_deg + (to_deg - from_deg) * i / (count - 1));
    points.push_back(location.translation +
                     R_FL * (kinematics::rotationAbout(Vector3d::UnitZ(), angle) * ball));
  }
  return points;
}

const SmallMotion kPlanted{{0.012, -0.034, 0.0}, {5e-5, -8e-5, 0.0}};

TEST(CircleOffsets, FindsWhereAnAxisStands) {
  for (const auto& [from, to] : {std::pair{0.0, 330.0}, std::pair{-60.0, 60.0}}) {
    const Result<FoundAxis> found = findRotaryAxis(
        {circleOf(kPlanted, {150, 20, 40}, from, to, 12), circleOf(kPlanted, {140, -30, 240}, from, to, 12)},
        {});
    ASSERT_TRUE(found) << found.error().text;
    EXPECT_LT((found->location.rotation - kPlanted.rotation).norm(), 1e-12);
    EXPECT_LT((found->location.translation - kPlanted.translation).norm(), 1e-10);
    EXPECT_NEAR(found->circles[0].radius, std::hypot(150.0, 20.0), 1e-10);
    EXPECT_LT(found->tilt_of_planes, 1e-10);
  }
}

TEST(CircleOffsets, OneCircleSuffices) {
  const Result<FoundAxis> found = findRotaryAxis({circleOf(kPlanted, {150, 20, 40}, 0, 300, 4)}, {});
  ASSERT_TRUE(found) << found.error().text;
  EXPECT_LT((found->location.rotation - kPlanted.rotation).norm(), 1e-12);
  EXPECT_LT((found->location.translation - kPlanted.translation).norm(), 1e-10);
}

/// The stated standard uncertainties are those of the scatter over many noisy repetitions.
TEST(CircleOffsets, StatesUncertaintiesThatHold) {
  Random random(9);
  constexpr int kTrials = 2000;
  const Vector3d ball(150, 0, 0);
  double tilt_square = 0.0, centre_square = 0.0, stated_tilt = 0.0, stated_centre = 0.0;
  for (int trial = 0; trial < kTrials; ++trial) {
    CirclePoints points = circleOf({}, ball, 0, 345, 24);
    for (Vector3d& point : points) point += random.vector(1e-3);
    const SpaceCircle circle = fitSpaceCircle(points).value();
    tilt_square += circle.normal.head<2>().squaredNorm() / kTrials / 2.0;
    centre_square += circle.centre.head<2>().squaredNorm() / kTrials;
    stated_tilt += circle.sigma_tilt * circle.sigma_tilt / kTrials;
    stated_centre += circle.sigma_centre * circle.sigma_centre / kTrials;
  }
  EXPECT_NEAR(std::sqrt(stated_tilt / tilt_square), 1.0, 0.05);
  EXPECT_NEAR(std::sqrt(stated_centre / centre_square), 1.0, 0.05);
}

TEST(CircleOffsets, RefusesWhatIsNoCircleAboutTheAxis) {
  EXPECT_FALSE(findRotaryAxis({}, {}));
  EXPECT_FALSE(fitSpaceCircle({{1, 0, 0}, {0, 1, 0}}));
  EXPECT_FALSE(fitSpaceCircle({{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {3, 3, 0}}));
  CirclePoints reversed = circleOf(kPlanted, {150, 0, 0}, 0, 300, 8);
  std::reverse(reversed.begin(), reversed.end());
  EXPECT_EQ(findRotaryAxis({reversed}, {}).error().code, "circle.direction");
}

}  // namespace
}  // namespace nineline::identification
