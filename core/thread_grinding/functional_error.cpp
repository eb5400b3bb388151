#include "core/thread_grinding/functional_error.h"

#include <cmath>

namespace nineline::thread_grinding {

FunctionalError functionalError(const ContactDisplacement& displacement, Hand hand, double lead,
                                double radius, double half_angle) {
  FunctionalError error;
  const double r = radius + displacement.radial;
  const double t = displacement.tangential;
  error.axial_lead = displacement.axial - signOf(hand) * lead / kTurn * std::atan2(t, r);
  // hypot(r, t) − radius without the cancellation
  error.radial = displacement.radial + t * t / (std::hypot(r, t) + r);
  const double radial_part = error.radial * std::sin(half_angle);
  error.flank_plus = error.axial_lead * std::cos(half_angle) - radial_part;
  error.flank_minus = -error.axial_lead * std::cos(half_angle) - radial_part;
  error.pitch_diameter = 2.0 * error.radial;
  return error;
}

}  // namespace nineline::thread_grinding
