#include "core/smoothing/bspline.h"

#include <algorithm>

#include "core/base/contract.h"

namespace nineline::smoothing {

BSpline::BSpline(std::vector<double> knots, PointRows control)
    : knots_(std::move(knots)), control_(std::move(control)) {
  NL_EXPECTS(knots_.size() >= 8 && knots_.size() == static_cast<std::size_t>(control_.rows()) + 4,
             knots_.size());
  NL_EXPECTS(control_.cols() >= 1 && control_.cols() <= kMostCoordinates, control_.cols());
}

std::size_t findSpan(std::span<const double> knots, double u) {
  const auto first = knots.begin() + kDegree + 1;
  const auto last = knots.end() - (kDegree + 1);
  const auto above = std::upper_bound(first, last, u);
  return static_cast<std::size_t>(above - knots.begin()) - 1;
}

std::array<double, 4> basisAt(std::span<const double> knots, std::size_t span, double u) {
  std::array<double, 4> basis{1.0, 0.0, 0.0, 0.0};
  for (std::size_t degree = 1; degree <= kDegree; ++degree) {
    double carried = 0.0;
    for (std::size_t k = 0; k < degree; ++k) {
      const double right = knots[span + k + 1];
      const double left = knots[span + 1 + k - degree];
      const double share = basis[k] / (right - left);
      basis[k] = carried + (right - u) * share;
      carried = (u - left) * share;
    }
    basis[degree] = carried;
  }
  return basis;
}

std::size_t BSpline::spanAt(double u) const { return findSpan(knots_, u); }

CurvePoint BSpline::at(double u) const {
  const std::size_t span = spanAt(u);
  const std::array<double, 4> basis = basisAt(knots_, span, u);
  const auto first = static_cast<Eigen::Index>(span) - kDegree;
  CurvePoint point = basis[0] * control_.row(first).transpose();
  for (int k = 1; k < 4; ++k)
    point += basis[static_cast<std::size_t>(k)] * control_.row(first + k).transpose();
  return point;
}

CurvePoint BSpline::derivative(double u, int order) const {
  NL_EXPECTS(order >= 0 && order <= 3, order);
  const std::size_t span = spanAt(u);
  const double a = knots_[span];
  const double h = knots_[span + 1] - a;
  const BezierPiece b = bezier(span, a, knots_[span + 1]);
  const CurvePoint c1 = 3.0 * (b[1] - b[0]);
  const CurvePoint c2 = 3.0 * (b[2] - 2.0 * b[1] + b[0]);
  const CurvePoint c3 = b[3] - 3.0 * b[2] + 3.0 * b[1] - b[0];
  const double s = (u - a) / h;
  switch (order) {
    case 0:
      return b[0] + s * (c1 + s * (c2 + s * c3));
    case 1:
      return (c1 + s * (2.0 * c2 + s * 3.0 * c3)) / h;
    case 2:
      return (2.0 * c2 + s * 6.0 * c3) / (h * h);
    default:
      return 6.0 * c3 / (h * h * h);
  }
}

CurvePoint BSpline::blossom(std::size_t span, const std::array<double, 3>& t) const {
  const auto first = static_cast<Eigen::Index>(span) - kDegree;
  BezierPiece d;
  for (int k = 0; k < 4; ++k) d[static_cast<std::size_t>(k)] = control_.row(first + k).transpose();
  for (std::size_t level = 1; level <= 3; ++level) {
    for (std::size_t k = 3; k >= level; --k) {
      const std::size_t knot = span - kDegree + k;
      const double left = knots_[knot];
      const double share = (t[level - 1] - left) / (knots_[knot + 4 - level] - left);
      d[k] += (1.0 - share) * (d[k - 1] - d[k]);
    }
  }
  return d[3];
}

BezierPiece BSpline::bezier(std::size_t span, double a, double b) const {
  return {blossom(span, {a, a, a}), blossom(span, {a, a, b}), blossom(span, {a, b, b}),
          blossom(span, {b, b, b})};
}

std::vector<double> chordLengths(const std::vector<Eigen::Vector3d>& tips) {
  std::vector<double> lengths;
  lengths.reserve(tips.size());
  double length = 0.0;
  for (std::size_t i = 0; i < tips.size(); ++i) {
    if (i > 0) length += (tips[i] - tips[i - 1]).norm();
    lengths.push_back(length);
  }
  return lengths;
}

std::vector<double> averagedKnots(std::span<const double> parameters, std::size_t control_points) {
  NL_EXPECTS(control_points >= 4 && control_points <= parameters.size(), control_points);
  const std::size_t inner = control_points - 4;
  const double step = static_cast<double>(parameters.size()) / static_cast<double>(inner + 1);
  std::vector<double> limits{parameters.front()};
  for (std::size_t j = 1; j <= inner; ++j) {
    const double place = static_cast<double>(j) * step;
    const auto i = static_cast<std::size_t>(place);
    const double share = place - static_cast<double>(i);
    limits.push_back((1.0 - share) * parameters[i - 1] + share * parameters[i]);
  }
  limits.push_back(parameters.back());
  return clampedKnots(limits);
}

std::vector<double> clampedKnots(std::span<const double> limits) {
  std::vector<double> knots(3, limits.front());
  knots.insert(knots.end(), limits.begin(), limits.end());
  knots.insert(knots.end(), 3, limits.back());
  return knots;
}

}  // namespace nineline::smoothing
