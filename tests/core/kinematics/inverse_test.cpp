#include "core/kinematics/inverse.h"

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/kinematics/machine_file.h"
#include "tests/support/random_machines.h"

namespace nineline::kinematics {
namespace {

using test_support::Random;

Eigen::Isometry3d poseOf(const ToolPose& tool) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = tool.R_WP;
  pose.translation() = tool.tip;
  return pose;
}

PoseTarget axisTarget(const ToolPose& pose) {
  PoseTarget target;
  target.tip = pose.tip;
  target.axis = pose.axis;
  target.rotation = PoseTarget::Rotation::Axis;
  return target;
}

TEST(InverseKinematics, PositionsItFindsReachTheAskedPose) {
  Random random(31);
  for (const Machine& machine : builtInMachines()) {
    for (int k = 0; k < 25; ++k) {
      const ToolPose asked = forward(machine, randomPositions(random, machine));
      const Result<JointPositions> q = inverse(machine, poseOf(asked));
      ASSERT_TRUE(q) << machine.id() << " " << k << ": " << q.error().message();
      const ToolPose found = forward(machine, *q);
      EXPECT_LT((found.tip - asked.tip).norm(), kNanometre) << machine.id();
      EXPECT_LT(logarithm(found.R_WP * asked.R_WP.transpose()).norm(), 1e-10) << machine.id();
      EXPECT_LT(machine.firstOutsideTravel(*q), 0) << machine.id();
    }
  }
}

TEST(InverseKinematics, FindsRandomMachinesBackFromANearStart) {
  Random random(32);
  for (int k = 0; k < 200; ++k) {
    const Machine machine = test_support::randomMachine(random, 2 + k % 8);
    const JointPositions q = randomPositions(random, machine);
    JointPositions start = q;
    for (int i = 0; i < machine.jointCount(); ++i)
      start[static_cast<std::size_t>(i)] += random.between(-1.0, 1.0) * (machine.isRotary(i) ? 0.1 : 20.0);
    const ToolPose asked = forward(machine, q);
    PoseTarget target = axisTarget(asked);
    target.R_WP = asked.R_WP;
    target.rotation = PoseTarget::Rotation::Full;
    const Result<JointPositions> found = inverse(machine, target, start);
    ASSERT_TRUE(found) << "machine " << k << ": " << found.error().message();
    EXPECT_LT((forward(machine, *found).tip - asked.tip).norm(), kNanometre) << k;
    EXPECT_LT((forward(machine, *found).R_WP - asked.R_WP).norm(), 1e-9) << k;
  }
}

TEST(InverseKinematics, APoseOutOfReachGetsNoAnswer) {
  const Machine& machine = *findBuiltInMachine("linear-stage");
  PoseTarget target;
  target.tip = {10.0, 5.0, 0.0};
  const Result<JointPositions> q = inverse(machine, target, {});
  ASSERT_FALSE(q);
  EXPECT_EQ(q.error().kind, ErrorKind::NoAnswer);
  EXPECT_EQ(q.error().code, "kinematics.inverse");
  EXPECT_NE(q.error().text.find("5 mm"), std::string::npos) << q.error().text;
}

TEST(InverseKinematics, RespectsTheTravel) {
  const Machine& machine = *findBuiltInMachine("generic-3axis");
  PoseTarget target;
  target.tip = {0.0, 0.0, 500.1};
  const Result<JointPositions> q = inverse(machine, target, {});
  ASSERT_FALSE(q);
  EXPECT_EQ(q.error().kind, ErrorKind::NoAnswer);
  EXPECT_EQ(q.error().code, "kinematics.travel");
  EXPECT_NE(q.error().text.find("Z"), std::string::npos);
  target.tip.z() = 500.0;
  EXPECT_TRUE(inverse(machine, target, {}));
}

TEST(InverseKinematics, RotaryAxesStayNearTheStart) {
  const Machine& machine = *findBuiltInMachine("trunnion-ac");
  const JointPositions q = {0.4, 12.0 * kTurn + 0.3, 10.0, 20.0, 30.0};
  const Result<JointPositions> found = inverse(machine, axisTarget(forward(machine, q)), q);
  ASSERT_TRUE(found);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR((*found)[i], q[i], 1e-9);
}

TEST(LeastSquaresStep, SpinAboutTheToolAxisIsFreeAndConvergenceQuadratic) {
  const Machine& machine = *findBuiltInMachine("trunnion-ac");
  const JointPositions wanted = {0.5, 0.7, 40.0, -30.0, 90.0};
  JointPositions q = {0.7, 0.5, 45.0, -20.0, 80.0};
  const PoseTarget target = axisTarget(forward(machine, wanted));
  int iterations = 0;
  for (; iterations < 20; ++iterations) {
    PoseJacobian jacobian;
    const PoseResidual r = residual(target, forwardWithJacobian(machine, q, jacobian));
    if (r.head<3>().norm() < 1e-10 && r.tail<3>().norm() < 1e-12) break;
    const JointPositions step = leastSquaresStep(machine, jacobian, r, target, {});
    for (std::size_t i = 0; i < 5; ++i) q[i] += step[i];
  }
  EXPECT_LE(iterations, 6);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(q[i], wanted[i], 1e-9);
}

TEST(LeastSquaresStep, MovesOnlyFreeJointsAndLeavesHopelessDirectionsAlone) {
  const Machine& machine = *findBuiltInMachine("b2-k3032");
  PoseJacobian jacobian;
  PoseTarget target;
  const ToolPose pose = forwardWithJacobian(machine, {0.0, 0.0, 30.0}, jacobian);
  target.tip = pose.tip + Vector3d(0.01, 0.02, 0.03);
  StepOptions options;
  options.free = 0b101;  // Z and X; the tangential part stays
  const JointPositions step = leastSquaresStep(machine, jacobian, residual(target, pose), target, options);
  EXPECT_NEAR(step[0], -0.03, 1e-14);
  EXPECT_EQ(step[1], 0.0);
  EXPECT_NEAR(step[2], 0.01, 1e-14);
  options.free = 0;
  EXPECT_EQ(leastSquaresStep(machine, jacobian, residual(target, pose), target, options), JointPositions{});
}

}  // namespace
}  // namespace nineline::kinematics
