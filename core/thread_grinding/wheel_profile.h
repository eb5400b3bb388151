#pragma once

#include "core/base/result.h"
#include "core/thread_grinding/thread_geometry.h"

namespace nineline::thread_grinding {

/// A wheel against an external thread. Its axis passes through (a, 0, 0) along (0, −sin ψ, cos ψ), a = root
/// radius
/// + wheel radius; the workpiece axis is z, z = 0 the middle of the groove.
struct WheelSetup {
  double wheel_diameter = 400.0;  ///< mm
  double tilt = 0.0;  ///< rad: ψ; right for the groove when +helix angle (right hand), − (left hand)
};

/// Where the flank circle of one radius touches the wheel.
struct WheelPoint {
  double axial = 0.0;   ///< ζ, mm along the wheel axis from the wheel's middle
  double radius = 0.0;  ///< ρ, mm from the wheel axis
  double angle = 0.0;   ///< θ, rad: of the contact on the workpiece
};

/// The point of the conjugate wheel profile that grinds flank `side` (±1) of the thread at radius `r`: there
/// the flank's normal meets the wheel axis, (S − c)·(u × n) = 0. Fails with NoAnswer where no contact is
/// found.
[[nodiscard]] Result<WheelPoint> conjugateWheelPoint(const ThreadGeometry& thread, Hand hand,
                                                     const WheelSetup& wheel, int side, double r);

/// Half width of the conjugate profile on the wheel's pitch line ρ = a − d2/2, mm. Smaller than that of the
/// rightly tilted wheel by what a badly tilted wheel overcuts on each flank.
[[nodiscard]] Result<double> halfWidthAtPitchLine(const ThreadGeometry& thread, Hand hand,
                                                  const WheelSetup& wheel);

/// Change of the pitch diameter (mm, never positive) when a wheel profiled for its right tilt is run at
/// `wheel.tilt`: contact calculation.
[[nodiscard]] Result<double> pitchDiameterChange(const ThreadGeometry& thread, Hand hand,
                                                 const WheelSetup& wheel);

/// The closed rule for large tilt errors: overcut of each flank Δψ² R/(2 tan α), 1/R = 2/d2 + 1/(a − d2/2),
/// mm. 1 % right for M48x1.5, 4 % for M48x5.
[[nodiscard]] double overcutRule(const ThreadGeometry& thread, const WheelSetup& wheel, double tilt_error);

}  // namespace nineline::thread_grinding
