#include <cmath>

#include "core/base/units.h"
#include "core/nc/execution.h"

namespace nineline::nc {
namespace {

/// Axis indices of the active rotation's plane; false where the machine lacks one of them.
bool rotationPlane(const Execution& e, int plane, std::array<std::int8_t, 2>& axes) {
  const char first = plane == 17 ? 'X' : plane == 18 ? 'Z' : 'Y';
  const char second = plane == 17 ? 'Y' : plane == 18 ? 'X' : 'Z';
  axes = {e.axis_of_letter[letterIndex(first)], e.axis_of_letter[letterIndex(second)]};
  return axes[0] >= 0 && axes[1] >= 0;
}

void turn(const WordFrame& frame, double& u, double& v) {
  const double turned = frame.cosine * u - frame.sine * v;
  v = frame.sine * u + frame.cosine * v;
  u = turned;
}

}  // namespace

void refreshFrame(Execution& e) {
  WordFrame& frame = e.frame;
  const Offsets& o = e.offsets;
  const AxisValues* const work = o.active >= 0 ? &o.work[index(o.active)] : nullptr;
  frame.rotation_plane = {-1, -1};
  frame.cosine = 1.0;
  frame.sine = 0.0;
  for (int i = 0; i < e.options.axes.count; ++i) {
    const AxisLayout::Axis& axis = e.options.axes.axes[index(i)];
    const bool halved = axis.diameter || (e.modal.diameter && axis.id == AxisId{'X', 0});
    const double unit = e.modal.inch ? kMillimetresPerInch : 1.0;
    frame.factor[index(i)] = axis.rotary ? radFromDeg(1.0) : halved ? unit * 0.5 : unit;
    frame.shift[index(i)] = o.external[index(i)] + (work ? (*work)[index(i)] : 0.0) + o.tool[index(i)];
  }
  AxisValues inner{};  // inside a rotation about the work offset
  for (int i = 0; i < e.options.axes.count; ++i) inner[index(i)] = o.local[index(i)] + o.position[index(i)];
  const double work_rotation =
      work && e.dialect == Dialect::LinuxCnc ? o.work_rotation[index(o.active)] : 0.0;
  if (work_rotation != 0.0 && rotationPlane(e, 17, frame.rotation_plane)) {
    frame.cosine = std::cos(work_rotation);
    frame.sine = std::sin(work_rotation);
    turn(frame, inner[index(frame.rotation_plane[0])], inner[index(frame.rotation_plane[1])]);
  } else if (o.rotated && rotationPlane(e, o.rotation_plane, frame.rotation_plane)) {
    frame.cosine = std::cos(o.rotation);
    frame.sine = std::sin(o.rotation);
    double u = o.rotation_centre[0];
    double v = o.rotation_centre[1];
    turn(frame, u, v);
    inner[index(frame.rotation_plane[0])] += o.rotation_centre[0] - u;
    inner[index(frame.rotation_plane[1])] += o.rotation_centre[1] - v;
  } else {
    frame.rotation_plane = {-1, -1};
  }
  for (int i = 0; i < e.options.axes.count; ++i) frame.shift[index(i)] += inner[index(i)];
  frame.incremental = e.modal.incremental
                          ? static_cast<AxisMask>((1U << static_cast<unsigned>(e.options.axes.count)) - 1U)
                          : AxisMask{0};
  e.frame_stale = false;
}

}  // namespace nineline::nc
