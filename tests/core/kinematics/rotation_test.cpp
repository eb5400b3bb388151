#include "core/kinematics/rotation.h"

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "tests/support/random_machines.h"

namespace nineline::kinematics {
namespace {

using test_support::Random;

constexpr double kRoundOff = 2e-15;

TEST(Rotation, QuarterTurnAboutZByHand) {
  Matrix3d expected;
  expected << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  EXPECT_LT((exponential({0, 0, kPi / 2}) - expected).norm(), kRoundOff);
  EXPECT_LT((rotationAbout({0, 0, 1}, kPi / 2) - expected).norm(), kRoundOff);
  EXPECT_LT((logarithm(expected) - Vector3d(0, 0, kPi / 2)).norm(), kRoundOff);
}

TEST(Rotation, SkewIsTheCrossProduct) {
  EXPECT_EQ(skew({1, 2, 3}) * Vector3d(4, 5, 6), Vector3d(1, 2, 3).cross(Vector3d(4, 5, 6)));
}

TEST(Rotation, LogarithmUndoesExponentialFromZeroToHalfATurn) {
  Random random(11);
  for (const double angle :
       {0.0, 1e-300, 1e-18, 1e-12, 1e-9,   1e-6,     1e-4,       1.1e-4,     1e-3,       0.1,        1.0,
        1.6, 2.0,    3.0,   3.14,  3.1415, 3.141592, kPi - 1e-7, kPi - 1e-8, kPi - 1e-9, kPi - 1e-12}) {
    for (int k = 0; k < 20; ++k) {
      const Vector3d w = angle * random.unitVector();
      const Vector3d back = logarithm(exponential(w));
      EXPECT_LT((back - w).norm(), 1e-14 + 1e-12 * (angle > 3.0 ? 1.0 : angle)) << angle;
    }
  }
}

TEST(Rotation, HalfATurnKeepsItsAxisUpToTheSign) {
  Random random(12);
  for (int k = 0; k < 50; ++k) {
    const Vector3d axis = random.unitVector();
    const Vector3d w = logarithm(exponential(kPi * axis));
    EXPECT_NEAR(w.norm(), kPi, 1e-14);
    EXPECT_NEAR(std::abs(w.dot(axis)), kPi, 1e-13);
  }
  for (int k = 0; k < 3; ++k) {
    Matrix3d half = -Matrix3d::Identity();
    half(k, k) = 1.0;
    EXPECT_NEAR(std::abs(logarithm(half)[k]), kPi, 1e-15);
  }
}

TEST(Rotation, ExponentialIsARotation) {
  Random random(13);
  for (int k = 0; k < 100; ++k) {
    const Matrix3d R = exponential(random.vector(4.0));
    EXPECT_LT((R * R.transpose() - Matrix3d::Identity()).norm(), 4e-15);
    EXPECT_NEAR(R.determinant(), 1.0, 4e-15);
  }
}

TEST(Rotation, LeftJacobianAgreesWithCentralDifferences) {
  Random random(14);
  constexpr double kStep = 1e-5;
  for (const double size : {1e-6, 1e-4, 1e-2, 1.0, 2.5}) {
    for (int k = 0; k < 10; ++k) {
      const Vector3d w = size * random.unitVector();
      const Vector3d dw = random.unitVector();
      const Matrix3d change = exponential(w + kStep * dw) * exponential(w - kStep * dw).transpose();
      EXPECT_LT((logarithm(change) / (2.0 * kStep) - leftJacobian(w) * dw).norm(), 1e-9) << size;
    }
  }
}

}  // namespace
}  // namespace nineline::kinematics
