#include "core/smoothing/certificate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace nineline::smoothing {
namespace {

BezierPiece pieceOf(const std::array<Vector3d, 4>& points) {
  return {CurvePoint(points[0]), CurvePoint(points[1]), CurvePoint(points[2]), CurvePoint(points[3])};
}

double sampled(const BezierPiece& b, const Vector3d& from, const Vector3d& to) {
  double largest = 0.0;
  for (int i = 0; i <= 4000; ++i) {
    const double s = i / 4000.0;
    const double r = 1.0 - s;
    const Vector3d point =
        (r * r * r * b[0] + 3.0 * r * r * s * b[1] + 3.0 * r * s * s * b[2] + s * s * s * b[3]).head<3>();
    largest = std::max(largest, distanceToSegment(point, from, to));
  }
  return largest;
}

TEST(Certificate, FindsTheMaximumOfAnSThatEqualSamplesMiss) {
  const BezierPiece s =
      pieceOf({Vector3d(0, 0, 0), Vector3d(1, 0.03, 0), Vector3d(2, -0.03, 0), Vector3d(3, 0, 0)});
  const DistanceBounds bounds = boundDistance(s, Vector3d::Zero(), Vector3d(3, 0, 0), -1.0, 1e-13);
  constexpr double kTruth = 0.015 / 1.7320508075688772;  // vector E6.S
  EXPECT_NEAR(bounds.upper, kTruth, 1e-12);
  EXPECT_GE(bounds.upper, kTruth - 1e-16);
}

TEST(Certificate, StopsOnceTheAnswerIsKnown) {
  const BezierPiece s =
      pieceOf({Vector3d(0, 0, 0), Vector3d(1, 0.03, 0), Vector3d(2, -0.03, 0), Vector3d(3, 0, 0)});
  EXPECT_LE(boundDistance(s, Vector3d::Zero(), Vector3d(3, 0, 0), 0.01).upper, 0.01);
  EXPECT_GT(boundDistance(s, Vector3d::Zero(), Vector3d(3, 0, 0), 0.008).lower, 0.008);
}

TEST(Certificate, EnclosesDenseSamplesOfRandomPieces) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const auto point = [&] { return Vector3d(number(random), number(random), number(random)); };
  for (int trial = 0; trial < 200; ++trial) {
    const BezierPiece piece = pieceOf({point(), point(), point(), point()});
    const Vector3d from = point();
    const Vector3d to = trial % 7 == 0 ? from : point();
    const DistanceBounds bounds = boundDistance(piece, from, to, -1.0, 1e-7);
    const double dense = sampled(piece, from, to);
    EXPECT_GE(bounds.upper, dense) << trial;
    EXPECT_LE(bounds.upper, dense + 1e-5) << trial;
    EXPECT_LE(bounds.lower, bounds.upper) << trial;
  }
}

TEST(Certificate, CutsAtKnotsAndBoundsTurnsAndBends) {
  const std::vector<double> knots = clampedKnots(std::vector<double>{0.0, 1.0, 2.5, 4.0});
  PointRows control(6, 4);
  control << 0, 0, 0, 0, 1, 1, 0, 0.2, 2, -1, 0.5, 0.1, 3, 1, 0, 0.4, 4, 0, 1, 0.3, 5, 0, 0, 0.5;
  const BSpline curve(knots, control);
  const Vector3d a = curve.at(0.4).head<3>();
  const Vector3d b = curve.at(3.1).head<3>();
  const DistanceBounds bounds = boundDistance(curve, 0.4, 3.1, a, b, -1.0, 1e-9);
  const CurvePoint from = curve.at(0.4);
  const CurvePoint to = curve.at(3.1);
  const double turn = boundTurn(curve, 0.4, 3.1, from, to);
  const double bend = largestSecondDerivative(curve, 0.4, 3.1);
  double dense = 0.0;
  for (int i = 0; i <= 2700; ++i) {
    const double u = 0.4 + i * 1e-3;
    const CurvePoint point = curve.at(u);
    dense = std::max(dense, distanceToSegment(point.head<3>(), a, b));
    const double straight = from[3] + (u - 0.4) / 2.7 * (to[3] - from[3]);
    EXPECT_LE(std::abs(point[3] - straight), turn + 1e-15);
    EXPECT_LE(curve.derivative(u, 2).head<3>().norm(), bend + 1e-12);
  }
  EXPECT_GE(bounds.upper, dense);
  EXPECT_NEAR(bounds.upper, dense, 1e-5);
}

}  // namespace
}  // namespace nineline::smoothing
