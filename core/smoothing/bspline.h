#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace nineline::smoothing {

/// Most coordinates of a curve: the tip and six rotary axes.
inline constexpr int kMostCoordinates = 9;
inline constexpr int kDegree = 3;

/// A point of a curve: tip in mm, rotary axes in rad. Never on the heap.
using CurvePoint = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostCoordinates, 1>;
/// Points row by row.
using PointRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
/// Four Bezier points of a cubic piece.
using BezierPiece = std::array<CurvePoint, 4>;

/// A clamped cubic B-spline with simple inner knots: twice continuously differentiable. Source:
/// theory.md, 5.2.
class BSpline {
 public:
  /// `knots`: ascending, the first four and the last four equal; `control`: knots − 4 rows.
  BSpline(std::vector<double> knots, PointRows control);

  [[nodiscard]] const std::vector<double>& knots() const { return knots_; }
  [[nodiscard]] const PointRows& control() const { return control_; }
  [[nodiscard]] double begin() const { return knots_.front(); }
  [[nodiscard]] double end() const { return knots_.back(); }
  [[nodiscard]] std::size_t spanCount() const { return knots_.size() - 2 * (kDegree + 1) + 1; }

  /// Index i with knot[i] <= u < knot[i + 1]; the last span at the end.
  [[nodiscard]] std::size_t spanAt(double u) const;
  [[nodiscard]] CurvePoint at(double u) const;
  /// The derivative of this order 0…3 with respect to u; right-continuous at knots, left at the end.
  [[nodiscard]] CurvePoint derivative(double u, int order) const;
  /// Bezier points of the part from a to b, which lies in one span.
  [[nodiscard]] BezierPiece bezier(std::size_t span, double a, double b) const;

 private:
  [[nodiscard]] CurvePoint blossom(std::size_t span, const std::array<double, 3>& t) const;
  std::vector<double> knots_;
  PointRows control_;
};

/// The index of the span that holds u, as BSpline::spanAt.
[[nodiscard]] std::size_t findSpan(std::span<const double> knots, double u);
/// The four basis functions that are not zero in this span.
[[nodiscard]] std::array<double, 4> basisAt(std::span<const double> knots, std::size_t span, double u);

/// Chord lengths from the first point: theory.md, 5.2 (E18), not divided by the whole. `tips`: mm.
[[nodiscard]] std::vector<double> chordLengths(const std::vector<Eigen::Vector3d>& tips);
/// Knots averaged from parameters for this many control points: theory.md, 5.2. Requires 4 <= control_points
/// <= parameters.
[[nodiscard]] std::vector<double> averagedKnots(std::span<const double> parameters,
                                                std::size_t control_points);
/// Clamped knots over these span limits, begin and end included.
[[nodiscard]] std::vector<double> clampedKnots(std::span<const double> limits);

}  // namespace nineline::smoothing
