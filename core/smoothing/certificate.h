#pragma once

#include "core/smoothing/bspline.h"

namespace nineline::smoothing {

using Eigen::Vector3d;

/// Two proven bounds of a largest distance: lower <= largest distance <= upper.
struct DistanceBounds {
  double lower = 0.0;
  double upper = 0.0;
};

/// Distance of a point from the segment a b, mm.
[[nodiscard]] double distanceToSegment(const Vector3d& point, const Vector3d& a, const Vector3d& b);

/// Bounds of the largest distance of a Bezier piece's tip from the segment a b. The points within d of a
/// segment form a convex set, so that the farthest Bezier point bounds the piece; the part with the largest
/// bound is halved until upper <= enough, lower > enough, or upper − lower <= precision; a negative `enough`
/// asks for the precision alone.
/// Source: theory.md, 5.4 (E21).
[[nodiscard]] DistanceBounds boundDistance(const BezierPiece& piece, const Vector3d& a, const Vector3d& b,
                                           double enough, double precision = 1e-9);

/// The same for the part of the curve from u_a to u_b, cut at the knots inside.
[[nodiscard]] DistanceBounds boundDistance(const BSpline& curve, double u_a, double u_b, const Vector3d& a,
                                           const Vector3d& b, double enough, double precision = 1e-9);

/// An upper bound, rad, of how far the rotary coordinates (4th and following) of the curve leave the straight
/// line between `from` and `to` (u_a to u_b): the sum over the axes bounds the angle between the tool axes.
[[nodiscard]] double boundTurn(const BSpline& curve, double u_a, double u_b, const CurvePoint& from,
                               const CurvePoint& to);

/// An upper bound of |tip''| between u_a and u_b: piecewise linear, so that its ends and the knots decide.
[[nodiscard]] double largestSecondDerivative(const BSpline& curve, double u_a, double u_b);

}  // namespace nineline::smoothing
