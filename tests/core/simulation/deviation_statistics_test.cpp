#include "core/simulation/deviation_statistics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/kinematics/machine_file.h"

namespace nineline::simulation {
namespace {

constexpr double kExact = 1e-12;

Deviation along(double x, double y, double joint) {
  Deviation deviation;
  deviation.tip = {x, y, 0.0};
  deviation.joints[0] = joint;
  return deviation;
}

TEST(DeviationStatistics, WeighsByPathLength) {
  DeviationStatistics statistics(1);
  EXPECT_TRUE(statistics.empty());
  statistics.add(along(3.0, 4.0, -1.0), 0.5, 1.0);
  statistics.add(along(-1.0, 0.0, 2.0), 0.0, 3.0);
  const DeviationSummary summary = statistics.summary();
  EXPECT_NEAR(summary.norm.mean, (5.0 + 3.0 * 1.0) / 4.0, kExact);
  EXPECT_NEAR(summary.norm.rms, std::sqrt((25.0 + 3.0) / 4.0), kExact);
  EXPECT_NEAR(summary.norm.max, 5.0, kExact);
  EXPECT_NEAR(summary.x.mean, (3.0 - 3.0) / 4.0, kExact);
  EXPECT_NEAR(summary.x.rms, std::sqrt((9.0 + 3.0) / 4.0), kExact);
  EXPECT_NEAR(summary.x.max, 3.0, kExact);
  EXPECT_NEAR(summary.y.mean, 1.0, kExact);
  EXPECT_NEAR(summary.axis_tilt.max, 0.5, kExact);
  ASSERT_EQ(summary.joints.size(), 1U);
  EXPECT_NEAR(summary.joints[0].mean, (-1.0 + 6.0) / 4.0, kExact);
  EXPECT_NEAR(summary.joints[0].max, 2.0, kExact);
  EXPECT_NEAR(summary.length, 4.0, kExact);
}

TEST(DeviationStatistics, CountsWhereNothingMoves) {
  DeviationStatistics statistics(1);
  statistics.add(along(1.0, 0.0, 0.0), 0.0, 0.0);
  statistics.add(along(3.0, 0.0, 0.0), 0.0, 0.0);
  EXPECT_NEAR(statistics.summary().x.mean, 2.0, kExact);
  EXPECT_NEAR(statistics.summary().x.rms, std::sqrt(5.0), kExact);
  EXPECT_EQ(DeviationStatistics(2).summary().norm.max, 0.0);
}

/// theory.md, 1.5 in closed form: at C = 0 a point that lies off by (e_r, e_t, e_a) at radius r is the one
/// that the ideal grinder touches with X longer, C turned back and Z opposite.
TEST(JointErrors, OfTheGrinderFollowItsGeometry) {
  const Machine& machine = *kinematics::findBuiltInMachine("b2-k3032");
  const double r = 23.0, radial = 0.01, tangential = 0.02, axial = -0.03;
  const JointPositions q = {5.0, 0.0, r};  // Z, C, X
  ToolPose actual = forward(machine, q);
  actual.tip += Vector3d(radial, tangential, axial);
  const JointPositions error = jointErrors(machine, q, actual);
  EXPECT_NEAR(error[0], -axial, 1e-9);
  EXPECT_NEAR(error[1], -std::atan2(tangential, r + radial), 1e-11);
  EXPECT_NEAR(error[2], std::hypot(r + radial, tangential) - r, 1e-9);
}

TEST(JointErrors, LeaveOutWhatNoJointMoves) {
  const Machine& machine = *kinematics::findBuiltInMachine("linear-stage");
  ToolPose actual = forward(machine, {10.0});
  actual.tip += Vector3d(0.001, 0.5, -0.3);
  EXPECT_NEAR(jointErrors(machine, {10.0}, actual)[0], 0.001, kExact);
}

}  // namespace
}  // namespace nineline::simulation
