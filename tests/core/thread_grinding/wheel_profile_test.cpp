#include "core/thread_grinding/wheel_profile.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nineline::thread_grinding {
namespace {

double untiltedOvercut_um(double diameter, double pitch, int starts) {
  const ThreadGeometry thread = threadGeometry(diameter, pitch, starts);
  const Result<double> tilted = halfWidthAtPitchLine(thread, Hand::Right, {400.0, thread.helix_angle});
  const Result<double> straight = halfWidthAtPitchLine(thread, Hand::Right, {400.0, 0.0});
  return umFromMm(tilted.value() - straight.value());
}

TEST(WheelProfile, UntiltedWheelOvercutsByThePublishedAmounts) {
  EXPECT_NEAR(untiltedOvercut_um(48.0, 1.5, 1), 1.86, 0.005);
  EXPECT_NEAR(untiltedOvercut_um(48.0, 5.0, 1), 21.2, 0.05);
  EXPECT_NEAR(untiltedOvercut_um(48.0, 1.5, 4), 29.7, 0.05);
}

TEST(WheelProfile, PitchDiameterShrinksByThePublishedAmounts) {
  const auto change_um = [](double pitch, int starts, double tilt) {
    const ThreadGeometry thread = threadGeometry(48.0, pitch, starts);
    return umFromMm(pitchDiameterChange(thread, Hand::Left, {400.0, tilt}).value());
  };
  EXPECT_NEAR(change_um(1.5, 1, 0.0), -6.4, 0.05);
  EXPECT_NEAR(change_um(5.0, 1, 0.0), -73.0, 0.5);
  EXPECT_NEAR(change_um(1.5, 4, 0.0), -103.0, 0.5);
  const double right_tilt = -threadGeometry(48.0, 1.5, 1).helix_angle;
  EXPECT_DOUBLE_EQ(change_um(1.5, 1, right_tilt), 0.0);
  const double plus = change_um(1.5, 1, right_tilt + radFromDeg(0.1));
  const double minus = change_um(1.5, 1, right_tilt - radFromDeg(0.1));
  EXPECT_NEAR((plus + minus) / 2.0, -0.17, 0.03);
}

TEST(WheelProfile, TheWrongSignOfTheTiltQuadruplesTheOvercut) {
  const ThreadGeometry thread = threadGeometry(48.0, 1.5, 1);
  const double none = pitchDiameterChange(thread, Hand::Left, {400.0, 0.0}).value();
  const double wrong = pitchDiameterChange(thread, Hand::Left, {400.0, thread.helix_angle}).value();
  EXPECT_NEAR(wrong / none, 4.0, 0.05);
}

TEST(WheelProfile, TheClosedRuleAgreesWithTheContactCalculation) {
  const ThreadGeometry fine = threadGeometry(48.0, 1.5, 1);
  EXPECT_NEAR(umFromMm(overcutRule(fine, {400.0, 0.0}, fine.helix_angle)) / untiltedOvercut_um(48.0, 1.5, 1),
              1.0, 0.015);  // published as "1 %"
  const ThreadGeometry coarse = threadGeometry(48.0, 5.0, 1);
  EXPECT_NEAR(
      umFromMm(overcutRule(coarse, {400.0, 0.0}, coarse.helix_angle)) / untiltedOvercut_um(48.0, 5.0, 1), 1.0,
      0.04);
}

TEST(WheelProfile, AThreadWithoutHelixHasTheStraightProfile) {
  // Lead → 0: the groove is a ring, the wheel's flank is the groove's flank.
  ThreadGeometry ring = threadGeometry(48.0, 1.5, 1);
  ring.lead = 0.0;
  const double r = 23.6;
  const Result<WheelPoint> point = conjugateWheelPoint(ring, Hand::Right, {400.0, 0.0}, 1, r);
  ASSERT_TRUE(point);
  EXPECT_NEAR(point->angle, 0.0, 1e-12);
  EXPECT_NEAR(point->axial, 0.375 + (r - ring.pitch_diameter / 2.0) * std::tan(kPi / 6.0), 1e-12);
}

TEST(WheelProfile, HandsAreMirrorImages) {
  const ThreadGeometry thread = threadGeometry(48.0, 5.0, 1);
  const Result<WheelPoint> right = conjugateWheelPoint(thread, Hand::Right, {400.0, 0.02}, 1, 22.0);
  const Result<WheelPoint> left = conjugateWheelPoint(thread, Hand::Left, {400.0, -0.02}, 1, 22.0);
  ASSERT_TRUE(right && left);
  EXPECT_NEAR(right->axial, left->axial, 1e-12);
  EXPECT_NEAR(right->radius, left->radius, 1e-12);
  EXPECT_NEAR(right->angle, -left->angle, 1e-12);
}

}  // namespace
}  // namespace nineline::thread_grinding
