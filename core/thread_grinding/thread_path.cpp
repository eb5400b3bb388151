#include "core/thread_grinding/thread_path.h"

#include <cmath>

#include "core/base/contract.h"

namespace nineline::thread_grinding {

double startPhase(int index, int starts) {
  NL_EXPECTS(starts >= 1 && index >= 0 && index < starts, index, starts);
  return kTurn * index / starts;
}

ThreadPoint pointAt(const ThreadPath& path, double wz) {
  const double radius = path.radius + path.taper * wz;
  NL_EXPECTS(std::abs(path.contact_height) < radius, path.contact_height, radius);
  const double groove_angle = signOf(path.hand) * kTurn * wz / path.lead + path.phase;
  ThreadPoint point;
  point.x = path.contact_height == 0.0
                ? radius
                : std::sqrt((radius - path.contact_height) * (radius + path.contact_height));
  point.z = path.z_at_zero - (wz + path.axial_shift);
  point.gamma = std::asin(path.contact_height / radius) - groove_angle;
  return point;
}

}  // namespace nineline::thread_grinding
