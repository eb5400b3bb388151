#include "core/thread_grinding/thread_geometry.h"

#include <cmath>

namespace nineline::thread_grinding {

ThreadGeometry threadGeometry(double major_diameter, double pitch, int starts, double profile_angle,
                              std::optional<double> depth) {
  ThreadGeometry thread;
  const bool iso = std::abs(profile_angle - kIsoProfileAngle) < 1e-9;
  thread.pitch = pitch;
  thread.lead = starts * pitch;
  thread.half_angle = profile_angle / 2.0;
  const double height = iso ? std::sqrt(3.0) / 2.0 * pitch : pitch / (2.0 * std::tan(thread.half_angle));
  const double flank_depth = depth.value_or(0.0);
  thread.triangle_height = height;
  thread.major_diameter = major_diameter;
  thread.pitch_diameter = major_diameter - (iso ? 0.75 * height : flank_depth);
  thread.internal_minor_diameter = major_diameter - (iso ? 1.25 * height : 2.0 * flank_depth);
  thread.root_diameter = major_diameter - (iso ? 17.0 / 12.0 * height : 2.0 * flank_depth);
  thread.external_depth = (major_diameter - thread.root_diameter) / 2.0;
  thread.internal_depth = (major_diameter - thread.internal_minor_diameter) / 2.0;
  thread.root_radius = iso ? height / 6.0 : 0.0;
  thread.helix_angle = std::atan(thread.lead / (kPi * thread.pitch_diameter));
  thread.root_helix_angle = std::atan(thread.lead / (kPi * thread.root_diameter));
  thread.normal_half_angle = std::atan(std::tan(thread.half_angle) * std::cos(thread.helix_angle));
  return thread;
}

}  // namespace nineline::thread_grinding
