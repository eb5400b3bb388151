#pragma once

#include "core/thread_grinding/thread_geometry.h"

namespace nineline::thread_grinding {

/// What a displaced contact does to the thread (mm).
struct FunctionalError {
  double axial_lead = 0.0;   ///< along the workpiece axis, the groove's shift away from its screw line
  double radial = 0.0;       ///< growth of the contact radius
  double flank_plus = 0.0;   ///< normal to the flank that faces +wz
  double flank_minus = 0.0;  ///< normal to the flank that faces −wz
  double pitch_diameter = 0.0;
};

/// Displacement of the contact in the workpiece frame, mm.
struct ContactDisplacement {
  double radial = 0.0;
  double tangential = 0.0;
  double axial = 0.0;
};

/// A thread lies unchanged under its own screw motion, so only two of three displacements act:
/// e_f = e_a − σ L/2π atan2(e_t, r + e_r), e_rad = √((r + e_r)² + e_t²) − r, e_n± = (±e_f − e_rad tan α) cos
/// α. `lead` > 0, `radius` > 0 of the contact, `half_angle` of the profile.
[[nodiscard]] FunctionalError functionalError(const ContactDisplacement& displacement, Hand hand, double lead,
                                              double radius, double half_angle = kIsoProfileAngle / 2.0);

}  // namespace nineline::thread_grinding
