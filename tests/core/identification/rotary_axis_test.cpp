#include "core/identification/rotary_axis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "core/base/units.h"
#include "tests/support/random_machines.h"

namespace nineline::identification {
namespace {

using test_support::Random;

constexpr RotaryTargets kTargets{50.0, 250.0, 100.0};

TEST(RotaryAxis, RecoversItsErrorsExactly) {
  Random random(21);
  for (int i = 0; i < 72; ++i) {
    const double angle = kTurn * i / 72.0;
    for (const double size : {1.0, 100.0}) {
      const RotaryPose planted{size * random.vector(0.01), size * random.vector(5e-5)};
      const RotaryReadings readings = predictRotaryReadings(kTargets, planted, angle);
      const Result<RotaryPose> found = exactRotaryPose(kTargets, readings, angle);
      ASSERT_TRUE(found) << found.error().text;
      EXPECT_LT((found->d - planted.d).norm(), 1e-12);
      EXPECT_LT((found->e - planted.e).norm(), 1e-13);
    }
  }
}

/// Ten times the errors, a hundred times what the first-order formulas leave.
TEST(RotaryAxis, FirstOrderFormulasLeaveASquare) {
  const RotaryPose planted{{0.004, -0.009, 0.006}, {4e-5, -6e-5, 3e-5}};
  const auto leftAt = [&](double size) {
    const RotaryPose larger{size * planted.d, size * planted.e};
    const RotaryReadings readings = predictRotaryReadings(kTargets, larger, 1.0);
    const RotaryPose found = firstOrderRotaryPose(kTargets, readings, 1.0).value();
    return std::abs(found.e.x() - larger.e.x());
  };
  EXPECT_LT(leftAt(1.0), 2e-8);
  EXPECT_GT(leftAt(1.0), 1e-11);
  EXPECT_NEAR(leftAt(10.0) / leftAt(1.0), 100.0, 2.0);
}

TEST(RotaryAxis, PutsLocalAxesIntoTheBed) {
  const SmallMotion local{{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}};
  EXPECT_EQ(inBedAxes(local, 'A').translation, Vector3d(1, 2, 3));
  EXPECT_EQ(inBedAxes(local, 'B').translation, Vector3d(3, 1, 2));  // axial along Y, then Z, X
  EXPECT_EQ(inBedAxes(local, 'C').rotation, Vector3d(5, 6, 4));     // axial along Z, then X, Y
}

/// A mandrel that runs out and leans is taken out; errors of the axis at twice and minus once a turn stay.
TEST(RotaryAxis, TakesTheMandrelOut) {
  const std::complex<double> off1(0.02, -0.01), off2(0.05, 0.03), axis_minus(1e-3, 2e-3), mean1(0.1, 0.2);
  const std::complex<double> tilt(3e-4, -2e-4);  // of the axis: y, z per mm
  std::vector<double> angles;
  std::vector<RotaryReadings> readings;
  for (int i = 0; i < 24; ++i) {
    const double angle = kTurn * i / 24.0;
    angles.push_back(angle);
    const std::complex<double> own =
        axis_minus * std::polar(1.0, -angle) + 5e-4 * std::polar(1.0, 2.0 * angle);
    const std::complex<double> first = mean1 + tilt * kTargets.h1 + own + off1 * std::polar(1.0, angle);
    const std::complex<double> second = mean1 + tilt * kTargets.h2 + own + off2 * std::polar(1.0, angle);
    readings.push_back({0.0, first.real(), first.imag(), second.real(), second.imag(), 0.0});
  }
  const Result<MandrelEccentricity> found = removeMandrelEccentricity(kTargets, angles, readings);
  ASSERT_TRUE(found) << found.error().text;
  EXPECT_NEAR(found->u1, off1.real(), 1e-14);
  EXPECT_NEAR(found->v2, off2.imag(), 1e-14);
  EXPECT_NEAR(found->offset2, mean1.real(), 1e-13);
  EXPECT_NEAR(found->tilt3, tilt.real(), 1e-15);   // turning about 3 leans towards 2
  EXPECT_NEAR(found->tilt2, -tilt.imag(), 1e-15);  // turning about 2 leans away from 3
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const std::complex<double> left = mean1 + tilt * kTargets.h1 + axis_minus * std::polar(1.0, -angles[i]) +
                                      5e-4 * std::polar(1.0, 2.0 * angles[i]);
    EXPECT_NEAR(readings[i].y1, left.real(), 1e-14);
    EXPECT_NEAR(readings[i].z1, left.imag(), 1e-14);
  }
}

/// The mandrel off the axis, seen through the exact kinematics of an axis with errors: after the removal the
/// errors are what was planted, up to eccentricity × error.
TEST(RotaryAxis, FindsErrorsUnderAnEccentricMandrel) {
  std::vector<double> angles;
  std::vector<RotaryReadings> readings;
  std::vector<RotaryPose> planted;
  for (int i = 0; i < 36; ++i) {
    const double angle = kTurn * i / 36.0;
    const RotaryPose pose{
        {1e-3 * std::sin(2 * angle), 2e-3 * std::cos(2 * angle), 1e-3 * std::sin(3 * angle)},
        {2e-5 * std::cos(angle), 1e-5 * std::sin(2 * angle), 3e-5 * std::cos(2 * angle)}};
    RotaryReadings reading = predictRotaryReadings(kTargets, pose, angle);
    const std::complex<double> off = std::polar(0.01, angle + 0.4);
    reading.y1 += off.real(), reading.z1 += off.imag();
    reading.y2 += 3.0 * off.real(), reading.z2 += 3.0 * off.imag();
    angles.push_back(angle);
    readings.push_back(reading);
    planted.push_back(pose);
  }
  ASSERT_TRUE(removeMandrelEccentricity(kTargets, angles, readings));
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const RotaryPose found = exactRotaryPose(kTargets, readings[i], angles[i]).value();
    // what is left: cos − i sin of the planted second orders have no part that turns once with the axis
    EXPECT_LT((found.d - planted[i].d).norm(), 1e-9);
    EXPECT_LT((found.e - planted[i].e).norm(), 1e-11);
  }
}

TEST(RotaryAxis, RefusesWhatHasNoAnswer) {
  EXPECT_FALSE(exactRotaryPose({50.0, 50.0, 100.0}, {}, 0.0));
  EXPECT_FALSE(exactRotaryPose({50.0, 60.0, 0.0}, {}, 0.0));
  EXPECT_FALSE(exactRotaryPose(kTargets, {0, NAN, 0, 0, 0, 0}, 0.0));
  EXPECT_EQ(exactRotaryPose(kTargets, {0, 0, 0, 300.0, 0, 0}, 0.0).error().kind, ErrorKind::NoAnswer);
  std::vector<RotaryReadings> three(3);
  EXPECT_FALSE(removeMandrelEccentricity(kTargets, {0.0, 1.0, 2.0}, three));
}

}  // namespace
}  // namespace nineline::identification
