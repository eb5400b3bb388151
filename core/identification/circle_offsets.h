#pragma once

#include <vector>

#include "core/identification/rigid_fit.h"

namespace nineline::identification {

/// Places of one ball on the turning body while only the rotary axis moved, mm, in a frame that does not
/// turn. In the order of increasing angle; the steps may be unequal but must stay below half a turn.
using CirclePoints = std::vector<Vector3d>;

/// A circle in space through points.
struct SpaceCircle {
  Vector3d centre = Vector3d::Zero();   ///< mm
  Vector3d normal = Vector3d::UnitZ();  ///< unit, counter-clockwise seen from its tip
  double radius = 0.0;                  ///< mm
  double rms = 0.0;                     ///< of the distances from the circle, mm
  double sigma_centre = 0.0;            ///< standard uncertainty in the plane, largest direction, mm
  double sigma_tilt = 0.0;              ///< standard uncertainty of the normal, largest direction, rad
};

/// Plane and circle by least squares. Fails on fewer than three points or points in a line.
[[nodiscard]] Result<SpaceCircle> fitSpaceCircle(const CirclePoints& points);

/// A rotary axis found from circles.
struct FoundAxis {
  Vector3d point = Vector3d::Zero();  ///< where it pierces the plane through `place` across the nominal axis
  Vector3d direction = Vector3d::UnitZ();  ///< unit, the sense of positive turning
  /// Location errors against the nominal line: displacement of the axis at `place` and the rotation vector
  /// that turns the nominal direction into the found one (no part along it). For a C axis X0C, Y0C and A0C,
  /// B0C.
  SmallMotion location;
  double tilt_of_planes = 0.0;  ///< angle between the mean normal of the circles and `direction`, rad
  std::vector<SpaceCircle> circles;
};

/// The nominal axis: a point of it (the joint's frame) and its direction.
struct NominalAxis {
  Vector3d place = Vector3d::Zero();
  Vector3d direction = Vector3d::UnitZ();
};

/// One circle gives the direction from its plane; two or more, from balls at different heights, from the line
/// through their centres as well, which are weighted together by their uncertainties. Fails like
/// fitSpaceCircle, and when the found axis lies more than 45° off the nominal one (wrong axis or wrong order
/// of the points).
[[nodiscard]] Result<FoundAxis> findRotaryAxis(const std::vector<CirclePoints>& circles,
                                               const NominalAxis& nominal);

}  // namespace nineline::identification
