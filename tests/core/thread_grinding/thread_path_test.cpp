#include "core/thread_grinding/thread_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/contract.h"

namespace nineline::thread_grinding {
namespace {

ThreadPath path(Hand hand) {
  ThreadPath result;
  result.hand = hand;
  result.lead = 1.5;
  result.radius = 24.0;
  return result;
}

TEST(ThreadPath, TableAndSpindleRunTogetherForRightHandAndApartForLeftHand) {
  for (const Hand hand : {Hand::Right, Hand::Left}) {
    const ThreadPoint a = pointAt(path(hand), 0.0);
    const ThreadPoint b = pointAt(path(hand), 3.0);
    EXPECT_NEAR((b.z - a.z) / (b.gamma - a.gamma), signOf(hand) * 1.5 / kTurn, 1e-15);
  }
}

TEST(ThreadPath, OneLeadIsOneTurn) {
  const ThreadPoint point = pointAt(path(Hand::Left), 1.5);
  EXPECT_DOUBLE_EQ(point.gamma, kTurn);
  EXPECT_DOUBLE_EQ(point.z, -1.5);
  EXPECT_DOUBLE_EQ(point.x, 24.0);
}

TEST(ThreadPath, StartsLieEquallySpaced) {
  EXPECT_DOUBLE_EQ(startPhase(0, 3), 0.0);
  EXPECT_DOUBLE_EQ(startPhase(2, 3), 2.0 * kTurn / 3.0);
  EXPECT_THROW((void)startPhase(3, 3), ContractViolation);
}

TEST(ThreadPath, AContactAboveTheAxisStillLiesOnTheScrewLine) {
  ThreadPath high = path(Hand::Right);
  high.contact_height = 5.0;
  high.taper = 0.03125;
  const double wz = 7.25;
  const ThreadPoint point = pointAt(high, wz);
  // workpiece point = Rz(−γ)(x, h)
  const double angle = std::atan2(5.0, point.x) - point.gamma;
  EXPECT_NEAR(std::hypot(point.x, 5.0), 24.0 + 0.03125 * wz, 1e-12);
  EXPECT_NEAR(angle, kTurn * wz / 1.5, 1e-12);
}

TEST(ThreadPath, AContactThatMissesTheWorkIsRefused) {
  ThreadPath high = path(Hand::Right);
  high.contact_height = 24.0;
  EXPECT_THROW((void)pointAt(high, 0.0), ContractViolation);
}

}  // namespace
}  // namespace nineline::thread_grinding
