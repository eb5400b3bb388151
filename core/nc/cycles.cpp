#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"
#include "core/nc/execution.h"
#include "core/nc/nc_error.h"

namespace nineline::nc {
namespace {

constexpr double kPeckGap =
    0.254;  ///< mm: what G73 backs off and G83 leaves before the last depth (LinuxCNC's 0.01 inch)
constexpr long kMostRepeats = 100'000;
constexpr std::size_t kMostPecks = 100'000;

/// One canned cycle worked out in machine coordinates of the drilling axis.
struct Drilling {
  std::size_t axis = 0;
  int code = 81;
  double r = 0.0, bottom = 0.0, clear = 0.0, peck = 0.0;
  int direction = 1;  ///< +1: R lies above the bottom
};

void goTo(Execution& e, MotionKind kind, const Drilling& d, double level) {
  AxisValues end = e.position;
  end[d.axis] = level;
  appendStraight(e, kind, MotionRole::Cycle, end);
}

bool drillInPecks(Execution& e, const Drilling& d) {
  const double size = d.r - d.bottom;
  if (d.peck <= 0.0 || size / d.peck > static_cast<double>(kMostPecks)) {
    return failAt(e, code::kBadValue, 'Q',
                  fmt::format("G{} needs a depth Q above zero for each peck", d.code));
  }
  for (double depth = d.r - d.peck; depth > d.bottom; depth -= d.peck) {
    goTo(e, MotionKind::Linear, d, depth);
    if (d.code == 73) {
      goTo(e, MotionKind::Rapid, d, depth + kPeckGap);
    } else {
      goTo(e, MotionKind::Rapid, d, d.r);
      goTo(e, MotionKind::Rapid, d, depth + kPeckGap);
    }
  }
  goTo(e, MotionKind::Linear, d, d.bottom);
  return true;
}

bool drill(Execution& e, const Drilling& d) {
  if (d.code == 73 || d.code == 83) {
    if (!drillInPecks(e, d)) return false;
  } else {
    goTo(e, MotionKind::Linear, d, d.bottom);
  }
  const bool feed_out = d.code == 74 || d.code == 84 || d.code == 85 || d.code == 89;
  if (!feed_out) {
    goTo(e, MotionKind::Rapid, d, d.clear);
    return true;
  }
  const bool to_clear = d.code == 89 && e.dialect == Dialect::LinuxCnc;
  goTo(e, MotionKind::Linear, d, to_clear ? d.clear : d.r);
  if (!to_clear && d.r != d.clear) goTo(e, MotionKind::Rapid, d, d.clear);
  return true;
}

bool rememberWords(Execution& e, int axis) {
  const BlockWords& w = e.words;
  CycleWords& c = e.cycle;
  if (w.has('R')) c.r = w.of('R');
  if (contains(w.axes, axis)) c.depth = w.value[index(axis)];
  if (w.has('Q')) c.peck = std::fabs(w.of('Q'));
  if (!c.r)
    return failAt(e, code::kMissingWord, 'G', "A drilling cycle needs R, the plane to which it returns");
  if (!c.depth) return failAt(e, code::kMissingWord, 'G', "A drilling cycle needs the depth");
  return true;
}

bool setUp(Execution& e, int axis, Drilling& d) {
  const double unit = e.frame.factor[index(axis)];
  const double shift = e.frame.shift[index(axis)];
  d.axis = index(axis);
  d.code = e.modal.cycle;
  const bool incremental = contains(e.frame.incremental, axis);
  const double base = e.cycle.initial;
  d.r = incremental ? base + *e.cycle.r * unit : *e.cycle.r * unit + shift;
  d.bottom = incremental ? d.r + *e.cycle.depth * unit : *e.cycle.depth * unit + shift;
  d.peck = e.cycle.peck.value_or(0.0) * unit;
  if (d.r < d.bottom) return failAt(e, code::kBadValue, 'R', "R lies below the bottom of the hole");
  d.clear = e.modal.return_to_plane ? d.r : std::fmax(d.r, base);
  return true;
}

bool countOfRepeats(Execution& e, long& repeats) {
  const char letter = e.words.has('L') ? 'L' : e.words.has('K') && e.dialect == Dialect::Fanuc ? 'K' : 0;
  repeats = 1;
  if (letter == 0) return true;
  const double count = e.words.of(letter);
  if (!(count >= 0.0 && count <= static_cast<double>(kMostRepeats)) || count != std::floor(count)) {
    return failAt(e, code::kBadValue, letter, fmt::format("{} is no number of repeats", count));
  }
  repeats = static_cast<long>(count);
  return true;
}

}  // namespace

bool executeCycle(Execution& e) {
  const int code = e.modal.cycle;
  const std::array<int, 3> axes = planeAxes(e);
  if (axes[2] < 0)
    return failAt(e, code::kNoSuchAxis, 'G', "The cycle needs a drilling axis that the machine lacks");
  if (code == 87 || code == 88 || (code == 74 && e.lathe && e.dialect == Dialect::Fanuc) || (code == 76)) {
    return failAt(e, code::kUnknownCode, 'G',
                  fmt::format("The cycle G{} is not understood and could be motion", code));
  }
  if (e.lathe && e.dialect == Dialect::Fanuc && code >= 83 && code <= 89) {
    return failAt(
        e, code::kUnknownCode, 'G',
        fmt::format("The drilling cycle G{} of a lathe is not understood and could be motion", code));
  }
  if (e.frame_stale) refreshFrame(e);
  if (!rememberWords(e, axes[2])) return false;
  Drilling d;
  long repeats = 1;
  if (!setUp(e, axes[2], d) || !countOfRepeats(e, repeats)) return false;
  e.motions.clear();
  const AxisMask drilling_bit = axisBit(axes[2]);
  BlockWords& w = e.words;
  const AxisMask named = w.axes;
  w.axes = static_cast<AxisMask>(w.axes & ~drilling_bit);
  WordFrame frame = e.frame;
  frame.incremental = static_cast<AxisMask>(frame.incremental | w.increments);
  if (repeats > 0 && e.position[d.axis] < d.r) goTo(e, MotionKind::Rapid, d, d.r);
  for (long n = 0; n < repeats && e.motions.size() < kMostPecks; ++n) {
    const AxisValues above = endOfWords(e, frame);
    if (above != e.position) appendStraight(e, MotionKind::Rapid, MotionRole::Cycle, above);
    if (e.position[d.axis] != d.r) goTo(e, MotionKind::Rapid, d, d.r);
    if (!drill(e, d)) return false;
  }
  w.axes = named;
  e.established |= static_cast<AxisMask>(named & ~frame.incremental);
  e.executed.motions = e.motions;
  return true;
}

}  // namespace nineline::nc
