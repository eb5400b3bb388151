#pragma once

#include <vector>

#include "core/identification/rigid_fit.h"

namespace nineline::identification {

/// The six errors of a rotary axis at one angle, in local axes 1, 2, 3 that do not turn with it: 1 along the
/// axis; (X, Y, Z) for A, (Y, Z, X) for B, (Z, X, Y) for C. The rotation is R3(e3) R2(e2) R1(e1).
struct RotaryPose {
  Vector3d d = Vector3d::Zero();  ///< mm
  Vector3d e = Vector3d::Zero();  ///< rad
};

/// Where the balls of the mandrel and the angular target sit (theory.md, 2.3).
struct RotaryTargets {
  double h1 = 0.0;      ///< plane of ball 1 and of the angular target, from the reference point along 1, mm
  double h2 = 0.0;      ///< plane of ball 2, mm
  double radius = 0.0;  ///< of the angular target, mm
};

/// Readings at one angle: measured minus ideal. The indicator on ball i stands still and meets it at the
/// axis.
struct RotaryReadings {
  double axial = 0.0;         ///< ball 1 along 1, mm
  double y1 = 0.0, z1 = 0.0;  ///< ball 1 along 2 and 3, mm
  double y2 = 0.0, z2 = 0.0;  ///< ball 2 along 2 and 3, mm
  double turn = 0.0;          ///< angle of the target seen from the ideal axis, measured minus commanded, rad
};

/// What the instruments read for a pose: exact rigid body.
[[nodiscard]] RotaryReadings predictRotaryReadings(const RotaryTargets& targets, const RotaryPose& pose,
                                                   double angle);

/// The exact inverse of predictRotaryReadings, theory.md eq. (9). `angle` commanded, rad. Fails where the
/// planes coincide, the radius is not above 0, or no rigid motion gives the readings.
[[nodiscard]] Result<RotaryPose> exactRotaryPose(const RotaryTargets& targets, const RotaryReadings& readings,
                                                 double angle);

/// The literature's first-order formulas with their errata repaired (theory.md, 2.3, [E5] to [E11]); for
/// comparison only.
[[nodiscard]] Result<RotaryPose> firstOrderRotaryPose(const RotaryTargets& targets,
                                                      const RotaryReadings& readings, double angle);

/// The pose as a translation and rotation vector in the local, standing axes.
[[nodiscard]] SmallMotion motionOf(const RotaryPose& pose);

/// The same in the frame that turns with the axis: what a rotary table of an error model holds by default.
[[nodiscard]] SmallMotion turningMotionOf(const RotaryPose& pose, double angle);

/// Local axes 1, 2, 3 → bed axes X, Y, Z for the rotary axis 'A', 'B' or 'C'. Requires one of these letters.
[[nodiscard]] SmallMotion inBedAxes(const SmallMotion& local, char axis);

/// What turns with the mandrel instead of belonging to the axis: how far each ball's centre lies off the
/// axis.
struct MandrelEccentricity {
  /// At angle 0, along 2 and 3, mm; they turn with the axis.
  double u1 = 0.0, v1 = 0.0;  ///< ball 1
  double u2 = 0.0, v2 = 0.0;  ///< ball 2
  /// Mean place and direction of the axis: location errors (X0C, Y0C and B0C, A0C of a C axis).
  double offset2 = 0.0, offset3 = 0.0;  ///< of the axis at the reference point, mm
  double tilt2 = 0.0, tilt3 = 0.0;      ///< rotation of the axis about 2 and 3, rad
};

/// Fits the turning part of the radial readings (a vector that turns once with the axis; the one that turns
/// against it is an error of the axis and stays) and takes it out of `readings`. Fails on fewer than four
/// different angles. The mean stays in the readings and is reported as location.
[[nodiscard]] Result<MandrelEccentricity> removeMandrelEccentricity(const RotaryTargets& targets,
                                                                    const std::vector<double>& angles,
                                                                    std::vector<RotaryReadings>& readings);

}  // namespace nineline::identification
