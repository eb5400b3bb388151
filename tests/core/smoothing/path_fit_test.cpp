#include "core/smoothing/path_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/smoothing/certificate.h"

namespace nineline::smoothing {
namespace {

PointRows circle(int count, double radius, double sweep) {
  PointRows points(count, 3);
  for (int j = 0; j < count; ++j) {
    const double angle = sweep * j / (count - 1);
    points.row(j) << radius * std::cos(angle), radius * std::sin(angle), 0.2 * angle;
  }
  return points;
}

FitTolerances within(double position) {
  FitTolerances tolerances;
  tolerances.position = position;
  return tolerances;
}

/// The pieces follow each other from the first point to the last.
void expectCovered(const std::vector<PathPiece>& pieces, std::size_t points) {
  ASSERT_FALSE(pieces.empty());
  EXPECT_EQ(pieces.front().first, 0U);
  EXPECT_EQ(pieces.back().last, points - 1);
  for (std::size_t k = 1; k < pieces.size(); ++k) EXPECT_EQ(pieces[k].first, pieces[k - 1].last);
}

TEST(PathFit, CoversAnArcWithFewControlPointsWithinTheBound) {
  const PointRows points = circle(400, 50.0, 3.0);
  const std::vector<PathPiece> pieces = fitPath(points, within(0.005));
  ASSERT_EQ(pieces.size(), 1U);
  ASSERT_TRUE(pieces[0].fitted);
  EXPECT_LE(pieces[0].fitted->curve.control().rows(), 12);
  EXPECT_LE(pieces[0].fitted->errors.bound, 0.005);
  const BSpline& curve = pieces[0].fitted->curve;
  for (double u = 0.0; u < curve.end(); u += 0.01) {
    const CurvePoint point = curve.at(u);
    EXPECT_LE(std::abs(std::hypot(point[0], point[1]) - 50.0), 0.005) << u;
  }
}

TEST(PathFit, BoundOfThePolylineHoldsForDenseSamples) {
  FitTolerances tolerances = within(0.02);
  tolerances.criterion = Criterion::Polyline;
  const PointRows points = circle(150, 50.0, 3.0);
  const std::vector<PathPiece> pieces = fitPath(points, tolerances);
  ASSERT_EQ(pieces.size(), 1U);
  ASSERT_TRUE(pieces[0].fitted);
  const FittedCurve& fitted = *pieces[0].fitted;
  for (double u = 0.0; u < fitted.curve.end(); u += 0.01) {
    const Vector3d point = fitted.curve.at(u).head<3>();
    double nearest = 1e9;
    for (Eigen::Index j = 0; j + 1 < points.rows(); ++j)
      nearest = std::min(nearest,
                         distanceToSegment(point, points.row(j).transpose(), points.row(j + 1).transpose()));
    EXPECT_LE(nearest, fitted.errors.bound) << u;
  }
}

TEST(PathFit, RefusesThePolylineCriterionBelowTheSagitta) {
  FitTolerances tolerances = within(0.001);
  tolerances.criterion = Criterion::Polyline;
  for (const PathPiece& piece : fitPath(circle(40, 50.0, 1.5), tolerances)) EXPECT_FALSE(piece.fitted);
}

TEST(PathFit, KeepsACorner) {
  PointRows points(41, 3);
  for (int j = 0; j <= 40; ++j) points.row(j) << std::min(j, 20), std::max(j - 20, 0), 0.0;
  const std::vector<PathPiece> pieces = fitPath(points, within(0.005));
  expectCovered(pieces, 41);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0].last, 20U);
  for (const PathPiece& piece : pieces) ASSERT_TRUE(piece.fitted);
}

TEST(PathFit, DoesNotRoundALoneBendBetweenLongLines) {
  PointRows points(12, 3);  // 10 deg at one point, below the corner angle
  for (int j = 0; j < 12; ++j) {
    const double beyond = std::max(0, j - 6) * 10.0;
    points.row(j) << std::min(j, 6) * 10.0 + beyond * std::cos(0.17), beyond * std::sin(0.17), 0.0;
  }
  for (const PathPiece& piece : fitPath(points, within(0.005))) {
    if (!piece.fitted) continue;
    for (double u = 0.0; u < piece.fitted->curve.end(); u += 0.05) {
      const Vector3d point = piece.fitted->curve.at(u).head<3>();
      const double off =
          std::min(distanceToSegment(point, points.row(0).transpose(), points.row(6).transpose()),
                   distanceToSegment(point, points.row(6).transpose(), points.row(11).transpose()));
      EXPECT_LE(off, 0.005 + 1e-9);
    }
  }
}

TEST(PathFit, ShortAndReversingPathsStay) {
  EXPECT_TRUE(fitPath(PointRows::Zero(1, 3), within(0.005)).empty());
  for (const int count : {2, 3}) {
    const std::vector<PathPiece> pieces = fitPath(circle(count, 10.0, 0.1), within(0.005));
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_FALSE(pieces[0].fitted);
  }
  PointRows back(21, 3);
  for (int j = 0; j <= 20; ++j) back.row(j) << 10 - std::abs(j - 10), 0.0, 0.0;
  const std::vector<PathPiece> pieces = fitPath(back, within(0.005));
  expectCovered(pieces, 21);
  EXPECT_EQ(pieces[0].last, 10U);
}

TEST(PathFit, RandomPointsEndWithEveryBoundHeld) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  PointRows points(300, 4);
  for (Eigen::Index j = 0; j < points.rows(); ++j)
    points.row(j) << static_cast<double>(j), number(random), number(random), number(random);
  FitTolerances tolerances = within(0.005);
  tolerances.corner = 3.2;
  const std::vector<PathPiece> pieces = fitPath(points, tolerances);
  expectCovered(pieces, 300);
  for (const PathPiece& piece : pieces) {
    if (!piece.fitted) continue;
    EXPECT_LE(piece.fitted->errors.bound, 0.005);
    EXPECT_LE(piece.fitted->errors.turn_bound, tolerances.turn);
  }
}

TEST(PathFit, RotaryAxesFollowWithinTheirTolerance) {
  PointRows points(500, 5);
  for (Eigen::Index j = 0; j < points.rows(); ++j) {
    const double t = static_cast<double>(j) / 499.0;
    points.row(j) << 80.0 * t, 5.0 * std::sin(3.0 * t), 0.0, 0.3 * std::sin(6.0 * t), 1.5 * t * t;
  }
  const std::vector<PathPiece> pieces = fitPath(points, within(0.005));
  ASSERT_EQ(pieces.size(), 1U);
  ASSERT_TRUE(pieces[0].fitted);
  for (std::size_t j = 0; j < 500; ++j) {
    const CurvePoint off = pieces[0].fitted->curve.at(pieces[0].fitted->parameters[j]) -
                           points.row(static_cast<Eigen::Index>(j)).transpose();
    EXPECT_LE(off.tail(2).lpNorm<1>(), pieces[0].fitted->errors.turn_bound + 1e-15);
  }
  EXPECT_LE(pieces[0].fitted->errors.turn_bound, 1e-3);
}

}  // namespace
}  // namespace nineline::smoothing
