#pragma once

#include <optional>

#include "core/smoothing/bspline.h"

namespace nineline::smoothing {

/// What the bound refers to (theory.md, 5.3).
enum class Criterion {
  Points,   ///< the programmed points; between them the chord error of the CAM system is allowed beside it
  Polyline  ///< the straight lines between the points
};

struct FitTolerances {
  double position = 0.005;  ///< mm
  double turn = 1e-3;       ///< rad: sum over the rotary axes
  Criterion criterion = Criterion::Points;
  std::optional<double> chord;  ///< mm: CAM chord error; absent: estimated from neighbouring points
  double corner = 0.35;         ///< rad: a path that turns by more at a point keeps it as a corner
};

/// How far a curve lies from its points. `bound` is proven everywhere on the curve, by the criterion.
struct FitErrors {
  double position = 0.0;  ///< mm, measured at the points
  double turn = 0.0;      ///< rad, measured at the points
  double bound = 0.0;     ///< mm
  double turn_bound = 0.0;
};

/// A curve over points, with the parameter of each (chord length, mm, stretched so that it ends on the grid
/// of knots).
struct FittedCurve {
  BSpline curve;
  std::vector<double> parameters;
  FitErrors errors;
};

/// A part of a path: the points first … last, and the curve through them; none where they stay as they are.
struct PathPiece {
  std::size_t first = 0;
  std::size_t last = 0;
  std::optional<FittedCurve> fitted;
};

/// Knots are multiples of this, mm, so that programs can state them exactly.
inline constexpr double kKnotGrid = 1e-4;

/// Errors of any curve over points, bounded for certain.
[[nodiscard]] FitErrors certify(const BSpline& curve, const std::vector<double>& parameters,
                                const PointRows& points, const FitTolerances& tolerances);

/// Cuts a path at its corners and covers what lies between with certified curves, with few control points:
/// knots are spread by the fourth root of the error until the bound holds. Where no curve meets it the part
/// is cut at its worst point; fewer than four points stay. `points`: rows of tip (mm) and rotary axes (rad,
/// unwound), no two tips in sequence equal.
[[nodiscard]] std::vector<PathPiece> fitPath(const PointRows& points, const FitTolerances& tolerances);

/// Estimated sagitta of each chord, mm: l² κ / 8 with the smaller curvature at its ends; zero for
/// Criterion::Polyline.
[[nodiscard]] std::vector<double> sagittas(const PointRows& points, const FitTolerances& tolerances);

}  // namespace nineline::smoothing
