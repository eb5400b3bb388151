#include "core/smoothing/spline_fit.h"

#include <algorithm>

#include "core/base/contract.h"

namespace nineline::smoothing {

namespace {

/// Lower bands of the normal matrix of the inner control points: row k holds (k, k), (k, k−1) … (k, k−3).
using Bands = std::vector<std::array<double, 4>>;

struct NormalEquations {
  Bands bands;
  PointRows right;
};

/// Adds one point: `basis` belongs to the control points from `first` on.
void addPoint(NormalEquations& sums, const std::array<double, 4>& basis, std::size_t first,
              const CurvePoint& rest) {
  const std::size_t inner = sums.bands.size();
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t row = first + k;  // control point; the inner ones are 1 … inner
    if (row == 0 || row > inner) continue;
    sums.right.row(static_cast<Eigen::Index>(row - 1)) += basis[k] * rest.transpose();
    for (std::size_t back = 0; back <= k && back < row; ++back)
      sums.bands[row - 1][back] += basis[k] * basis[k - back];
  }
}

NormalEquations gather(std::span<const double> parameters, const PointRows& points,
                       std::span<const double> knots) {
  const std::size_t count = knots.size() - 4;
  NormalEquations sums{Bands(count - 2),
                       PointRows::Zero(static_cast<Eigen::Index>(count) - 2, points.cols())};
  const auto last = points.rows() - 1;
  std::size_t span = kDegree;
  for (Eigen::Index j = 1; j < last; ++j) {
    const double u = parameters[static_cast<std::size_t>(j)];
    while (span + 5 < knots.size() && u >= knots[span + 1]) ++span;
    const std::array<double, 4> basis = basisAt(knots, span, u);
    const std::size_t first = span - kDegree;
    CurvePoint rest = points.row(j).transpose();
    if (first == 0) rest -= basis[0] * points.row(0).transpose();
    if (first + 3 == count - 1) rest -= basis[3] * points.row(last).transpose();
    addPoint(sums, basis, first, rest);
  }
  return sums;
}

/// L D Lᵀ in place: bands[k][0] becomes the pivot, bands[k][b] the factor L(k, k − b). False when a pivot is
/// too small.
bool factorise(Bands& bands, double weakest) {
  double largest = 0.0;
  for (const auto& row : bands) largest = std::max(largest, row[0]);
  for (std::size_t k = 0; k < bands.size(); ++k) {
    const std::size_t reach = std::min<std::size_t>(3, k);
    for (std::size_t b = reach; b >= 1; --b) {
      const std::size_t column = k - b;
      double sum = bands[k][b];
      for (std::size_t c = b + 1; c <= reach; ++c)
        sum -= bands[k][c] * bands[column][c - b] * bands[k - c][0];
      bands[k][b] = sum / bands[column][0];
    }
    for (std::size_t b = 1; b <= reach; ++b) bands[k][0] -= bands[k][b] * bands[k][b] * bands[k - b][0];
    if (!(bands[k][0] > weakest * largest)) return false;
  }
  return true;
}

void solve(const Bands& bands, PointRows& x) {
  const auto row = [&x](std::size_t k) { return x.row(static_cast<Eigen::Index>(k)); };
  for (std::size_t k = 0; k < bands.size(); ++k) {
    for (std::size_t b = 1; b <= std::min<std::size_t>(3, k); ++b) row(k) -= bands[k][b] * row(k - b);
  }
  for (std::size_t k = 0; k < bands.size(); ++k) row(k) /= bands[k][0];
  for (std::size_t k = bands.size(); k-- > 0;) {
    for (std::size_t b = 1; b <= 3 && k + b < bands.size(); ++b) row(k) -= bands[k + b][b] * row(k + b);
  }
}

}  // namespace

std::optional<BSpline> fitSpline(std::span<const double> parameters, const PointRows& points,
                                 std::vector<double> knots, double weakest) {
  NL_EXPECTS(parameters.size() == static_cast<std::size_t>(points.rows()), parameters.size());
  NL_EXPECTS(knots.size() >= 8 && points.rows() >= 2, knots.size());
  if (knots.size() - 4 > parameters.size()) return std::nullopt;
  NormalEquations sums = gather(parameters, points, knots);
  if (!factorise(sums.bands, weakest)) return std::nullopt;
  solve(sums.bands, sums.right);
  PointRows control(sums.right.rows() + 2, points.cols());
  control.row(0) = points.row(0);
  control.middleRows(1, sums.right.rows()) = sums.right;
  control.row(control.rows() - 1) = points.row(points.rows() - 1);
  if (!control.allFinite()) return std::nullopt;
  return BSpline(std::move(knots), std::move(control));
}

}  // namespace nineline::smoothing
