#pragma once

#include <optional>

#include "core/base/units.h"

namespace nineline::thread_grinding {

/// Right: the groove moves away along +wz while it turns counter-clockwise about +wz.
enum class Hand { Right, Left };
enum class ThreadType { External, Internal };

/// +1 for a right-hand thread, −1 for a left-hand one.
[[nodiscard]] constexpr double signOf(Hand hand) { return hand == Hand::Right ? 1.0 : -1.0; }

/// The profile angle of ISO 68-1, both flanks together.
inline constexpr double kIsoProfileAngle = kPi / 3.0;

/// Sizes of a thread: ISO 68-1 for a profile angle of 60°. Lengths in mm, angles in rad.
struct ThreadGeometry {
  double pitch = 0.0;
  double lead = 0.0;                     ///< starts · pitch
  double half_angle = kPi / 6.0;         ///< of the profile in the axial section
  double triangle_height = 0.0;          ///< H
  double major_diameter = 0.0;           ///< d, D
  double pitch_diameter = 0.0;           ///< d2, D2
  double internal_minor_diameter = 0.0;  ///< d1, D1
  double root_diameter = 0.0;            ///< d3: of the external thread with rounded root
  double external_depth = 0.0;           ///< h3 = (d − d3)/2
  double internal_depth = 0.0;           ///< (D − D1)/2
  double root_radius = 0.0;              ///< H/6, tangent to d3
  double helix_angle = 0.0;              ///< at d2, always positive
  double root_helix_angle = 0.0;         ///< at d3
  double normal_half_angle = 0.0;        ///< of the profile in the section normal to the helix at d2
};

/// H = P/(2 tan α), d2 = d − 3/4 H, d1 = d − 5/4 H, d3 = d − 17/12 H (ISO 68-1). Another profile angle has no
/// standard depth: `depth` is then used, with d2 = d − depth and d3 = d1 = d − 2 depth. Values are computed
/// as they come: a root diameter below zero is the caller's to refuse.
[[nodiscard]] ThreadGeometry threadGeometry(double major_diameter, double pitch, int starts,
                                            double profile_angle = kIsoProfileAngle,
                                            std::optional<double> depth = {});

}  // namespace nineline::thread_grinding
