#include "core/thread_grinding/thread_geometry.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nineline::thread_grinding {
namespace {

TEST(ThreadGeometry, LiteratureThreadHasThePublishedSizes) {
  const ThreadGeometry thread = threadGeometry(48.0, 1.5, 1);
  EXPECT_NEAR(thread.triangle_height, 1.299038, 5e-7);
  EXPECT_NEAR(thread.pitch_diameter, 47.025721, 5e-7);
  EXPECT_NEAR(thread.internal_minor_diameter, 46.376202, 5e-7);
  EXPECT_NEAR(thread.root_diameter, 46.159696, 5e-7);
  EXPECT_NEAR(thread.external_depth, 0.920152, 5e-7);
  EXPECT_NEAR(degFromRad(thread.helix_angle), 0.581720, 5e-7);
}

TEST(ThreadGeometry, GrooveAndRidgeAreEquallyWideAtThePitchDiameter) {
  const ThreadGeometry thread = threadGeometry(30.0, 3.5, 2);
  // The crest is P/8 wide and widens by 2 tan 30° for each mm of depth.
  const double depth = (thread.major_diameter - thread.pitch_diameter) / 2.0;
  EXPECT_NEAR(3.5 / 8.0 + 2.0 * depth * std::tan(kPi / 6.0), 3.5 / 2.0, 1e-12);
}

TEST(ThreadGeometry, HelixAngleUsesTheLeadOfAllStarts) {
  const ThreadGeometry thread = threadGeometry(100.0, 3.0, 4);
  EXPECT_DOUBLE_EQ(thread.lead, 12.0);
  EXPECT_NEAR(std::tan(thread.helix_angle) * kPi * thread.pitch_diameter, 12.0, 1e-12);
}

TEST(ThreadGeometry, OtherProfileAngleTakesTheGivenDepth) {
  const ThreadGeometry tr = threadGeometry(40.0, 7.0, 1, radFromDeg(30.0), 3.5);
  EXPECT_DOUBLE_EQ(tr.pitch_diameter, 36.5);
  EXPECT_DOUBLE_EQ(tr.root_diameter, 33.0);
  EXPECT_NEAR(tr.triangle_height, 7.0 * 1.866025, 1e-5);
}

}  // namespace
}  // namespace nineline::thread_grinding
