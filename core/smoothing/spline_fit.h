#pragma once

#include <optional>
#include <span>

#include "core/smoothing/bspline.h"

namespace nineline::smoothing {

/// The cubic B-spline over these knots that lies nearest to the data in the sense of least squares, the first
/// and the last point met exactly (theory.md, 5.2, E19). Nothing when the knots leave a control point without
/// data or when the smallest pivot falls below `weakest` of the largest.
/// Work: linear in the points; the normal equations have seven bands and are factorised as L D Lᵀ.
[[nodiscard]] std::optional<BSpline> fitSpline(std::span<const double> parameters, const PointRows& points,
                                               std::vector<double> knots, double weakest = 1e-6);

}  // namespace nineline::smoothing
