#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"
#include "core/nc/execution.h"
#include "core/nc/nc_error.h"

namespace nineline::nc {
namespace {

constexpr int kExtended = 100;  ///< index of G54.1 P1
constexpr int kMostExtended = 300;
constexpr std::size_t kMostTools = 100'000;

/// Value of an axis word as an offset: mm or rad, with units and diameter, no shift.
double offsetOf(const Execution& e, int axis) {
  return e.words.value[index(axis)] * e.frame.factor[index(axis)];
}

bool activate(Execution& e, int number) {
  if (e.offsets.work.size() <= index(number)) {
    e.offsets.work.resize(index(number) + 1);
    e.offsets.work_rotation.resize(index(number) + 1);
  }
  e.offsets.active = number;
  e.frame_stale = true;
  return true;
}

bool writeWorkOffset(Execution& e, bool from_position) {
  const double p = e.words.of('P', -1.0);
  if (!e.words.has('P'))
    return failAt(e, code::kMissingWord, 'L', "G10 L2 needs P, the number of the work offset");
  const double most = e.words.of('L') == 20.0 && e.dialect == Dialect::Fanuc ? kMostExtended : 9.0;
  if (!(p >= 0.0 && p <= most) || p != std::floor(p))
    return failAt(e, code::kBadValue, 'P', fmt::format("There is no work offset {}", p));
  const bool extended = e.dialect == Dialect::Fanuc && e.words.of('L') == 20.0;
  const bool external = e.dialect == Dialect::Fanuc && p == 0.0;
  const int active = e.offsets.active;
  const int number = p == 0.0 ? active : static_cast<int>(p) - 1 + (extended ? kExtended : 0);
  if (!external) {
    activate(e, number);
    e.offsets.active = active;
  }
  if (e.frame_stale) refreshFrame(e);
  AxisValues& offset = external ? e.offsets.external : e.offsets.work[index(number)];
  const bool increment = e.modal.incremental && e.dialect == Dialect::Fanuc;
  if (from_position) {
    activate(e, number);
    if (e.words.has('R')) e.offsets.work_rotation[index(number)] = radFromDeg(e.words.of('R'));
    refreshFrame(e);
    const AxisValues words = e.frame.wordsOf(e.position, e.options.axes.count);
    AxisValues wanted = words;
    for (int i = 0; i < e.options.axes.count; ++i) {
      if (contains(e.words.axes, i)) wanted[index(i)] = e.words.value[index(i)];
    }
    const AxisValues stands = e.frame.positionOf(wanted, e.options.axes.count);
    AxisValues& target = e.offsets.work[index(number)];
    for (int i = 0; i < e.options.axes.count; ++i)
      target[index(i)] += e.position[index(i)] - stands[index(i)];
    e.offsets.active = active;
  } else {
    for (int i = 0; i < e.options.axes.count; ++i) {
      if (contains(e.words.axes, i)) offset[index(i)] = (increment ? offset[index(i)] : 0.0) + offsetOf(e, i);
    }
    if (e.words.has('R') && e.dialect == Dialect::LinuxCnc)
      e.offsets.work_rotation[index(number)] = radFromDeg(e.words.of('R'));
  }
  e.frame_stale = true;
  return true;
}

/// LinuxCNC G10 L1 (offsets as given), L10, L11 (so that the position reads the words).
bool writeTool(Execution& e, bool from_position) {
  const double p = e.words.of('P', -1.0);
  if (!(p >= 1.0 && p <= static_cast<double>(kMostTools)) || p != std::floor(p)) {
    return failAt(e, code::kBadValue, 'P', "G10 L1 needs P, the number of a tool");
  }
  if (e.frame_stale) refreshFrame(e);
  AxisValues& tool = e.offsets.tools[static_cast<int>(p)];
  if (!from_position) {
    for (int i = 0; i < e.options.axes.count; ++i) {
      if (contains(e.words.axes, i)) tool[index(i)] = offsetOf(e, i);
    }
    return true;
  }
  WordFrame plain = e.frame;
  for (int i = 0; i < e.options.axes.count; ++i) plain.shift[index(i)] -= e.offsets.tool[index(i)];
  const AxisValues base = plain.wordsOf(
      [&] {
        AxisValues position = e.position;
        for (int i = 0; i < e.options.axes.count; ++i) position[index(i)] -= tool[index(i)];
        return position;
      }(),
      e.options.axes.count);
  AxisValues wanted = base;
  for (int i = 0; i < e.options.axes.count; ++i) {
    if (contains(e.words.axes, i)) wanted[index(i)] = e.words.value[index(i)];
  }
  const AxisValues stands = plain.positionOf(wanted, e.options.axes.count);
  for (int i = 0; i < e.options.axes.count; ++i) tool[index(i)] = e.position[index(i)] - stands[index(i)];
  return true;
}

/// Fanuc G10 L10…L13 P R: L10 is the length, L11 its wear, L12 and L13 the radius.
bool writeFanucTool(Execution& e) {
  const int z = e.axis_of_letter[letterIndex('Z')];
  if (!e.words.has('P') || !e.words.has('R') || z < 0) {
    warnOnce(e, code::kPassedCode, "A tool offset written by G10 is passed over");
    return true;
  }
  const double p = e.words.of('P');
  if (!(p >= 0.0 && p <= 999.0))
    return failAt(e, code::kBadValue, 'P', fmt::format("There is no tool offset {}", p));
  if (e.words.of('L') >= 12.0) return true;
  double& length = e.offsets.tools[static_cast<int>(p)][index(z)];
  const double value = e.words.of('R') * (e.modal.inch ? kMillimetresPerInch : 1.0);
  length = e.words.of('L') == 11.0 || e.modal.incremental ? length + value : value;
  return true;
}

}  // namespace

void loadOffsets(Execution& e) {
  e.offsets.work.assign(9, AxisValues{});
  e.offsets.work_rotation.assign(9, 0.0);
  for (const auto& [name, values] : e.options.work_offsets) {
    int number = -1;
    if (name.starts_with("G54.1P")) {
      number = kExtended - 1 + std::atoi(name.c_str() + 6);
    } else if (name.size() >= 3 && name[0] == 'G') {
      const double value = std::atof(name.c_str() + 1);
      number = value >= 505.0 ? kExtended + static_cast<int>(value) - 505
                              : static_cast<int>(std::floor(value)) - 54 +
                                    static_cast<int>(std::lround((value - std::floor(value)) * 10.0));
    }
    if (number < 0 || number > kExtended + kMostExtended) continue;
    const int active = e.offsets.active;
    activate(e, number);
    e.offsets.active = active;
    e.offsets.work[index(number)] = values;
  }
  const int z = e.axis_of_letter[letterIndex('Z')];
  for (const auto& [number, length] : e.options.tool_lengths) {
    if (z >= 0) e.offsets.tools[number][index(z)] = length;
  }
}

bool selectWorkOffset(Execution& e, int tenths) {
  const int number = tenths >= 5050 ? kExtended + tenths / 10 - 505 : tenths / 10 - 54 + tenths % 10;
  if (e.offsets.active == number) return true;
  return activate(e, number);
}

bool selectExtendedOffset(Execution& e) {
  const double p = e.words.of('P', 0.0);
  if (!(p >= 1.0 && p <= kMostExtended) || p != std::floor(p)) {
    return failAt(e, code::kBadValue, 'P',
                  "G54.1 needs P, the number of an extended work offset from 1 to 300");
  }
  return activate(e, kExtended + static_cast<int>(p) - 1);
}

bool executeData(Execution& e) {
  const double l = e.words.of('L', -1.0);
  const bool linux_cnc = e.dialect == Dialect::LinuxCnc;
  if (e.frame_stale) refreshFrame(e);
  if (l == 2.0) return writeWorkOffset(e, false);
  if (l == 20.0) return writeWorkOffset(e, linux_cnc);
  if (linux_cnc && l == 1.0) return writeTool(e, false);
  if (linux_cnc && (l == 10.0 || l == 11.0)) return writeTool(e, true);
  if (linux_cnc && l == 0.0) return true;
  if (!linux_cnc && (l < 0.0 || l == 1.0 || (l >= 10.0 && l <= 13.0))) return writeFanucTool(e);
  if (!linux_cnc) {
    warnOnce(e, code::kPassedCode, fmt::format("G10 L{} is passed over", l));
    return true;
  }
  return failAt(e, code::kBadValue, 'L', fmt::format("G10 L{} is not understood", l));
}

bool setPosition(Execution& e) {
  if (e.words.axes == 0) {
    if (e.words.has('S')) return true;  // the limit of the spindle's speed
    return failAt(e, code::kMissingWord, 'G', "G92 needs axis words");
  }
  if (e.words.has('S') && e.dialect == Dialect::Fanuc)
    warnOnce(e, code::kAssumed, "G92 with S and axis words sets the position");
  if (e.frame_stale) refreshFrame(e);
  const AxisValues words = e.frame.wordsOf(e.position, e.options.axes.count);
  for (int i = 0; i < e.options.axes.count; ++i) {
    if (!contains(e.words.axes, i)) continue;
    if (e.words.increments & axisBit(i)) {
      e.offsets.position[index(i)] -= offsetOf(e, i);
    } else {
      e.offsets.position[index(i)] += (words[index(i)] - e.words.value[index(i)]) * e.frame.factor[index(i)];
    }
  }
  e.offsets.suspended = e.offsets.position;
  e.frame_stale = true;
  return true;
}

bool setLocalOffset(Execution& e) {
  if (e.frame_stale) refreshFrame(e);
  AxisValues& target = e.dialect == Dialect::LinuxCnc ? e.offsets.position : e.offsets.local;
  for (int i = 0; i < e.options.axes.count; ++i) {
    if (contains(e.words.axes, i)) target[index(i)] = offsetOf(e, i);
  }
  if (e.dialect == Dialect::LinuxCnc) e.offsets.suspended = target;
  e.frame_stale = true;
  return true;
}

bool rotateFrame(Execution& e) {
  const std::array<int, 3> axes = planeAxes(e);
  if (axes[0] < 0 || axes[1] < 0)
    return failAt(e, code::kNoSuchAxis, 'G', "G68 needs both axes of the plane");
  if (!e.words.has('R')) return failAt(e, code::kMissingWord, 'G', "G68 needs R, the angle");
  if ((e.words.axes & ~(axisBit(axes[0]) | axisBit(axes[1]))) != 0 ||
      (e.words.letters & (letterBit('I') | letterBit('J') | letterBit('K'))) != 0) {
    return failAt(e, code::kUnknownCode, 'G', "G68 in space is not understood and could be motion");
  }
  if (e.frame_stale) refreshFrame(e);
  const AxisValues words = e.frame.wordsOf(e.position, e.options.axes.count);
  for (std::size_t k = 0; k < 2; ++k) {
    const std::size_t axis = index(axes[k]);
    const double word = contains(e.words.axes, axes[k]) ? e.words.value[axis] : words[axis];
    e.offsets.rotation_centre[k] = word * e.frame.factor[axis];
  }
  e.offsets.rotation =
      radFromDeg(e.words.of('R')) + (e.modal.incremental && e.offsets.rotated ? e.offsets.rotation : 0.0);
  e.offsets.rotated = true;
  e.offsets.rotation_plane = e.modal.plane;
  e.frame_stale = true;
  return true;
}

}  // namespace nineline::nc
