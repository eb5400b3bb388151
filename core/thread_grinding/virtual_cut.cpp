#include "core/thread_grinding/virtual_cut.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace nineline::thread_grinding {
namespace {

ThreadPoint between(const VirtualMove& move, double t) {
  return {std::lerp(move.from.x, move.to.x, t), std::lerp(move.from.z, move.to.z, t),
          std::lerp(move.from.gamma, move.to.gamma, t)};
}

/// The part [low, high] of 0…1 in which a + (b − a) t >= 0; empty (low > high) when there is none.
void clip(double a, double b, double& low, double& high) {
  if (a < 0.0 && b < 0.0) high = -1.0;
  if (a < 0.0 && b >= 0.0) low = std::max(low, a / (a - b));
  if (a >= 0.0 && b < 0.0) high = std::min(high, a / (a - b));
}

}  // namespace

VirtualCut::Contact VirtualCut::contactAt(const ThreadPoint& point) const {
  // w = Rz(−γ)(x, h, 0): the ideal machine, theory of the grinder with the work zero on the work axis.
  const double h = blank_.contact_height;
  const double wz = blank_.z_at_zero - point.z;
  const double radius = std::hypot(point.x, h);
  const double crest = blank_.crest_radius + blank_.taper * wz;
  const double depth = blank_.type == ThreadType::External ? crest - radius : radius - crest;
  return {std::atan2(h, point.x) - point.gamma, wz, depth};
}

void VirtualCut::report(std::string text) {
  if (!fault_) fault_ = std::move(text);
}

void VirtualCut::add(const VirtualMove& move) {
  const Contact a = contactAt(move.from);
  const Contact b = contactAt(move.to);
  double low = 0.0;
  double high = 1.0;
  clip(a.wz - blank_.tolerance, b.wz - blank_.tolerance, low, high);
  clip(blank_.length - blank_.tolerance - a.wz, blank_.length - blank_.tolerance - b.wz, low, high);
  clip(a.depth - blank_.tolerance, b.depth - blank_.tolerance, low, high);
  if (high - low <= 1e-9) {
    finish();
    return;
  }
  if (move.rapid) report(fmt::format("line {}: a rapid motion passes through the work", move.line));
  if (between(move, low).x <= 0.0 || between(move, high).x <= 0.0)
    report(fmt::format("line {}: the wheel stands on the far side of the work axis", move.line));
  if (contacts_.empty()) {
    first_line_ = move.line;
    contacts_.push_back(contactAt(between(move, low)));
  }
  contacts_.push_back(contactAt(between(move, high)));
  if (high < 1.0) finish();
}

void VirtualCut::finish() {
  if (contacts_.size() >= 2) runs_.push_back(fittedRun());
  contacts_.clear();
}

GrooveRun VirtualCut::fittedRun() const {
  GrooveRun run;
  const double count = static_cast<double>(contacts_.size());
  for (const Contact& contact : contacts_) {
    run.middle_angle += contact.angle / count;
    run.middle_wz += contact.wz / count;
  }
  double angle_angle = 0.0;
  double angle_wz = 0.0;
  for (const Contact& contact : contacts_) {
    const double angle = contact.angle - run.middle_angle;
    angle_angle += angle * angle;
    angle_wz += angle * (contact.wz - run.middle_wz);
  }
  run.slope = angle_angle > 0.0 ? angle_wz / angle_angle : 0.0;
  run.depth = run.least_depth = contacts_.front().depth;
  run.first_wz = contacts_.front().wz;
  run.last_wz = contacts_.back().wz;
  run.line = first_line_;
  for (const Contact& contact : contacts_) {
    const double line_wz = run.middle_wz + run.slope * (contact.angle - run.middle_angle);
    run.residual = std::max(run.residual, std::abs(contact.wz - line_wz));
    run.depth = std::max(run.depth, contact.depth);
    run.least_depth = std::min(run.least_depth, contact.depth);
  }
  return run;
}

}  // namespace nineline::thread_grinding
