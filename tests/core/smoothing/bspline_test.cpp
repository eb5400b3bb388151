#include "core/smoothing/bspline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/smoothing/spline_fit.h"

namespace nineline::smoothing {
namespace {

const std::vector<double> kLimits{0.0, 0.7, 1.9, 2.0, 4.5};

BSpline wavyCurve() {
  std::vector<double> knots = clampedKnots(kLimits);
  PointRows control(static_cast<Eigen::Index>(knots.size()) - 4, 4);
  for (Eigen::Index i = 0; i < control.rows(); ++i) {
    const auto t = static_cast<double>(i);
    control.row(i) << t, std::sin(2.0 * t), std::cos(3.0 * t), 0.1 * t * t;
  }
  return {knots, control};
}

TEST(BSpline, BasisFunctionsSumToOneAndAreNotNegative) {
  const std::vector<double> knots = clampedKnots(kLimits);
  for (double u = 0.0; u <= 4.5; u += 0.01) {
    double sum = 0.0;
    for (const double value : basisAt(knots, findSpan(knots, u), u)) {
      EXPECT_GE(value, 0.0) << u;
      sum += value;
    }
    EXPECT_NEAR(sum, 1.0, 1e-14) << u;
  }
}

TEST(BSpline, StartsAndEndsAtItsControlPoints) {
  const BSpline curve = wavyCurve();
  EXPECT_EQ((curve.at(0.0) - curve.control().row(0).transpose()).norm(), 0.0);
  EXPECT_EQ((curve.at(4.5) - curve.control().bottomRows(1).transpose()).norm(), 0.0);
}

TEST(BSpline, DerivativesAgreeWithCentralDifferences) {
  const BSpline curve = wavyCurve();
  constexpr double kStep = 1e-4;
  for (const double u : {0.3, 1.1, 1.95, 3.3}) {
    for (int order = 0; order < 3; ++order) {
      const CurvePoint difference =
          (curve.derivative(u + kStep, order) - curve.derivative(u - kStep, order)) / (2.0 * kStep);
      const CurvePoint exact = curve.derivative(u, order + 1);
      EXPECT_LT((difference - exact).norm(), 1e-5 * (1.0 + exact.norm())) << u << " order " << order;
    }
    EXPECT_LT((curve.derivative(u, 0) - curve.at(u)).norm(), 1e-13);
  }
}

TEST(BSpline, IsTwiceContinuouslyDifferentiableAtItsKnots) {
  const BSpline curve = wavyCurve();
  for (const double knot : {0.7, 1.9, 2.0}) {
    const double left = std::nextafter(knot, 0.0);
    for (int order = 0; order <= 2; ++order) {
      const CurvePoint jump = curve.derivative(knot, order) - curve.derivative(left, order);
      EXPECT_LT(jump.norm(), 1e-9) << knot << " order " << order;
    }
    EXPECT_GT((curve.derivative(knot, 3) - curve.derivative(left, 3)).norm(), 1e-3);
  }
}

TEST(BSpline, BezierPointsReproduceTheirPart) {
  const BSpline curve = wavyCurve();
  const BezierPiece b = curve.bezier(curve.spanAt(2.5), 2.5, 3.5);
  for (double s = 0.0; s <= 1.0; s += 0.125) {
    const double r = 1.0 - s;
    const CurvePoint point =
        r * r * r * b[0] + 3.0 * r * r * s * b[1] + 3.0 * r * s * s * b[2] + s * s * s * b[3];
    EXPECT_LT((point - curve.at(2.5 + s)).norm(), 1e-13);
  }
}

TEST(SplineFit, FindsACubicExactly) {
  std::vector<double> parameters;
  PointRows points(60, 3);
  for (Eigen::Index j = 0; j < 60; ++j) {
    const double u = 4.5 * static_cast<double>(j) / 59.0;
    parameters.push_back(u);
    points.row(j) << u, u * u - 2.0, 0.3 * u * u * u;
  }
  const std::optional<BSpline> curve = fitSpline(parameters, points, clampedKnots(kLimits));
  ASSERT_TRUE(curve);
  for (double u = 0.0; u <= 4.5; u += 0.05)
    EXPECT_LT((curve->at(u) - CurvePoint(Eigen::Vector3d(u, u * u - 2.0, 0.3 * u * u * u))).norm(), 1e-11)
        << u;
}

TEST(SplineFit, ResidualIsNormalToTheBasis) {
  std::vector<double> parameters;
  PointRows points(80, 3);
  for (Eigen::Index j = 0; j < 80; ++j) {
    const double u = 4.5 * static_cast<double>(j) / 79.0;
    parameters.push_back(u);
    points.row(j) << std::cos(u), std::sin(3.0 * u), 1.0 / (1.0 + u);
  }
  const std::vector<double> knots = clampedKnots(kLimits);
  const std::optional<BSpline> curve = fitSpline(parameters, points, knots);
  ASSERT_TRUE(curve);
  PointRows products = PointRows::Zero(static_cast<Eigen::Index>(knots.size()) - 4, 3);
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    const std::size_t span = findSpan(knots, parameters[j]);
    const std::array<double, 4> basis = basisAt(knots, span, parameters[j]);
    const Eigen::Vector3d off =
        curve->at(parameters[j]) - points.row(static_cast<Eigen::Index>(j)).transpose();
    for (std::size_t k = 0; k < 4; ++k)
      products.row(static_cast<Eigen::Index>(span - 3 + k)) += basis[k] * off.transpose();
  }
  EXPECT_LT(products.middleRows(1, products.rows() - 2).norm(), 1e-12);
}

TEST(SplineFit, RefusesKnotsWithoutDataAndNumbersThatAreNone) {
  const std::vector<double> parameters{0.0, 0.1, 0.2, 0.3, 0.4, 4.4, 4.5};
  PointRows points = PointRows::Random(7, 3);
  EXPECT_FALSE(fitSpline(parameters, points, clampedKnots(std::vector<double>{0.0, 1.0, 2.0, 3.0, 4.5})));
  points(3, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(fitSpline(parameters, points, clampedKnots(std::vector<double>{0.0, 4.5})));
}

}  // namespace
}  // namespace nineline::smoothing
