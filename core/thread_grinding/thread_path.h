#pragma once

#include "core/thread_grinding/thread_geometry.h"

namespace nineline::thread_grinding {

/// Axis positions in model coordinates (signs and zeros of the machine's words not applied): mm, mm, rad.
struct ThreadPoint {
  double x = 0.0;      ///< contact against the work axis, towards the wheel slide
  double z = 0.0;      ///< table
  double gamma = 0.0;  ///< work spindle, not wrapped
};

/// The screw line on which the contact travels: σ wz = L/2π (φ − phase), φ the groove's angle on the
/// workpiece.
struct ThreadPath {
  Hand hand = Hand::Right;
  double lead = 1.0;            ///< mm per turn, > 0
  double phase = 0.0;           ///< rad: angle of the groove at wz = 0
  double radius = 0.0;          ///< mm: of the contact at wz = 0
  double taper = 0.0;           ///< mm of radius for each mm of wz
  double z_at_zero = 0.0;       ///< mm: z where wz = 0 meets the wheel (K0)
  double axial_shift = 0.0;     ///< mm: of the groove along wz (flank infeed)
  double contact_height = 0.0;  ///< mm: of the grinding point over the work axis (h)
};

/// Angle of start `index` of `starts`, rad.
[[nodiscard]] double startPhase(int index, int starts);

/// z = K0 − wz; contact at the angle θ with r sin θ = h, hence x = r cos θ and γ = θ − φ. Requires |h| < r.
[[nodiscard]] ThreadPoint pointAt(const ThreadPath& path, double wz);

}  // namespace nineline::thread_grinding
