#include "core/identification/rigid_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/kinematics/rotation.h"
#include "tests/support/random_machines.h"

namespace nineline::identification {
namespace {

using kinematics::exponential;
using test_support::Random;

std::vector<Vector3d> carried(const std::vector<Vector3d>& targets, const SmallMotion& motion) {
  std::vector<Vector3d> result;
  for (const Vector3d& target : targets) {
    result.push_back(motion.translation + exponential(motion.rotation) * target);
  }
  return result;
}

TEST(RigidFit, FindsMotionsOfAnySize) {
  Random random(11);
  for (const double angle : {1e-6, 1e-3, 0.5, 3.0}) {
    for (int count = 3; count <= 6; ++count) {
      std::vector<Vector3d> targets;
      for (int i = 0; i < count; ++i) targets.push_back(random.vector(200.0));
      const SmallMotion planted{random.vector(50.0), angle * random.unitVector()};
      const Result<RigidFit> found = fitRigidMotion(targets, carried(targets, planted));
      ASSERT_TRUE(found) << found.error().text;
      EXPECT_LT((found->motion.rotation - planted.rotation).norm(), 1e-12) << angle;
      EXPECT_LT((found->motion.translation - planted.translation).norm(), 1e-10) << angle;
      EXPECT_LT(found->rms, 1e-12);
    }
  }
}

/// The sum of squares is at its smallest: no small further motion lowers it.
TEST(RigidFit, IsTheLeastOfAllMotionsNearby) {
  Random random(5);
  std::vector<Vector3d> targets, observed;
  for (int i = 0; i < 7; ++i) {
    targets.push_back(random.vector(100.0));
    observed.push_back(targets.back() + random.vector(0.01));
  }
  const RigidFit found = fitRigidMotion(targets, observed).value();
  const auto squares = [&](const SmallMotion& motion) {
    double sum = 0.0;
    const std::vector<Vector3d> there = carried(targets, motion);
    for (std::size_t i = 0; i < targets.size(); ++i) sum += (observed[i] - there[i]).squaredNorm();
    return sum;
  };
  const double least = squares(found.motion);
  EXPECT_NEAR(found.rms, std::sqrt(least / 21.0), 1e-12);
  for (int trial = 0; trial < 50; ++trial) {
    const SmallMotion other{found.motion.translation + random.vector(1e-4),
                            found.motion.rotation + random.vector(1e-6)};
    EXPECT_GE(squares(other), least);
  }
}

TEST(RigidFit, RefusesWhatLeavesAMotionOpen) {
  const std::vector<Vector3d> line{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
  EXPECT_EQ(fitRigidMotion(line, line).error().code, "rigid_fit.line");
  const std::vector<Vector3d> two{{0, 0, 0}, {1, 0, 0}};
  EXPECT_FALSE(fitRigidMotion(two, two));
  std::vector<Vector3d> broken{{0, 0, 0}, {1, 0, 0}, {0, 1, std::numeric_limits<double>::quiet_NaN()}};
  EXPECT_FALSE(fitRigidMotion(broken, broken));
}

/// A pose stated in either frame is the same body: the chain of the machine says so.
TEST(RigidFit, ChangesTheFrameAsTheChainDoes) {
  Random random(3);
  for (int trial = 0; trial < 50; ++trial) {
    const kinematics::Machine machine = test_support::randomMachine(random, 1);
    const kinematics::Joint& joint = machine.joint(0);
    if (joint.type != kinematics::JointType::Rotary) continue;
    kinematics::JointPositions q{};
    q[0] = random.between(-3.0, 3.0);
    const SmallMotion standing{random.vector(0.1), random.vector(0.01)};
    kinematics::JointDisplacements as_standing{}, as_turning{};
    as_standing[0].standing = standing;
    as_turning[0].moved = inTurningFrame(standing, joint.direction, q[0]);
    const Eigen::Isometry3d one = kinematics::bodyPoses(machine, q, as_standing)[0];
    const Eigen::Isometry3d other = kinematics::bodyPoses(machine, q, as_turning)[0];
    EXPECT_TRUE(one.isApprox(other, 1e-14));
    const SmallMotion back = inStandingFrame(as_turning[0].moved, joint.direction, q[0]);
    EXPECT_LT((back.translation - standing.translation).norm(), 1e-14);
  }
}

TEST(RigidFit, MovesTheReferencePoint) {
  const SmallMotion motion{{1e-3, 2e-3, 3e-3}, {1e-4, -2e-4, 3e-4}};
  const Vector3d from(10, 20, 30), to(-40, 5, 100);
  const SmallMotion moved = atReferencePoint(motion, from, to);
  const Vector3d first_order = motion.translation + motion.rotation.cross(to - from);
  EXPECT_LT((moved.translation - first_order).norm(), 1e-5);
  // a body point keeps its displacement
  const Vector3d point(7, -8, 9);
  const Matrix3d R = exponential(motion.rotation);
  EXPECT_LT((motion.translation + (R * (point - from) - (point - from)) -
             (moved.translation + (R * (point - to) - (point - to))))
                .norm(),
            1e-13);
}

}  // namespace
}  // namespace nineline::identification
