#pragma once

#include <optional>
#include <vector>

#include "core/base/result.h"

namespace nineline::measurement {

/// Radial deviations along one circular path, in the order of travel.
struct CircularPath {
  std::vector<double> angle;  ///< polar angle of the nominal point in the plane, rad; may run on past a turn
  std::vector<double> deviation;  ///< distance from the set centre minus the nominal radius, mm
};

/// One circular test: the path of either sense, or both.
struct CircularTest {
  double radius = 0.0;  ///< nominal, mm
  std::optional<CircularPath> clockwise;
  std::optional<CircularPath> counterclockwise;
};

/// A circle laid through points by least squares of their distances from it.
struct CircleFit {
  double centre_u = 0.0,
         centre_v = 0.0;        ///< from the set centre, along the plane's first and second axis, mm
  double radius_change = 0.0;   ///< its radius minus the nominal one, mm
  double G = 0.0;               ///< largest minus smallest distance from its centre, mm
  double G_minimum_zone = 0.0;  ///< the same for the centre that makes it smallest, mm
};

/// The figures of ISO 230-4, mm. Those of a sense that was not driven are absent.
struct Iso2304 {
  std::optional<CircleFit> clockwise, counterclockwise;
  CircleFit all;                    ///< of both paths together; its G is the bidirectional G(b)
  bool is_full_circle = false;      ///< no gap of more than 10° in any path
  double F_max = 0.0, F_min = 0.0;  ///< radial deviation; from the fitted centre on full circles
  double F_max_as_set = 0.0, F_min_as_set = 0.0;  ///< from the centre as set up
  double D = 0.0;           ///< radius of the circle through both paths minus the nominal one
  std::optional<double> H;  ///< hysteresis: largest radial difference between the two paths
};

/// Fails on a radius that is not above 0, on paths of different lengths or with fewer than eight points, on
/// numbers that are not finite, and where the points do not determine a circle.
[[nodiscard]] Result<Iso2304> evaluateIso2304(const CircularTest& test);

}  // namespace nineline::measurement
