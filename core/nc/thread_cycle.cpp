#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"
#include "core/nc/execution.h"
#include "core/nc/nc_error.h"

namespace nineline::nc {
namespace {

constexpr std::size_t kMostPasses = 10'000;

/// LinuxCNC's G76 in machine coordinates, mm: the drive line lies at `drive`, thread peaks `peak` beside it.
struct ThreadCycle {
  std::size_t x = 0, z = 0;
  double drive = 0.0, begin = 0.0, target = 0.0;
  double side = -1.0;  ///< sense of infeed: −1 external, +1 internal
  double peak = 0.0, first = 0.0, depth = 0.0;
  double pitch = 0.0, taper_pitch = 0.0, taper = 0.0;
  double slope = 0.0;  ///< tangent of the compound angle
  double degression = 1.0;
  long spring = 0;
  bool taper_in = false, taper_out = false;
};

void goTo(Execution& e, const ThreadCycle& c, MotionKind kind, double x, double z, double lead) {
  AxisValues end = e.position;
  end[c.x] = x;
  end[c.z] = z;
  appendStraight(e, kind, MotionRole::Cycle, end);
  if (kind == MotionKind::Rapid) return;
  e.motions.back().feed_mode = FeedMode::PerRevolution;
  e.motions.back().feed = lead;
}

void cutPass(Execution& e, const ThreadCycle& c, double infeed) {
  const double full = c.peak + c.depth;
  const double shift = (infeed - c.peak) * c.slope;
  const double bottom = c.drive + c.side * infeed;
  const double clear = bottom - c.side * full;
  const double start = c.begin - shift;
  const double end = c.target - shift;
  goTo(e, c, MotionKind::Rapid, clear, start, 0.0);
  if (c.taper != 0.0 && c.taper_in) {
    goTo(e, c, MotionKind::Rapid, bottom - c.side * c.depth, start, 0.0);
    goTo(e, c, MotionKind::Linear, bottom, start - c.taper, c.taper_pitch);
  } else {
    goTo(e, c, MotionKind::Rapid, bottom, start, 0.0);
  }
  if (c.taper != 0.0 && c.taper_out) {
    goTo(e, c, MotionKind::Linear, bottom, end + c.taper, c.pitch);
    goTo(e, c, MotionKind::Linear, bottom - c.side * c.depth, end, c.taper_pitch);
  } else {
    goTo(e, c, MotionKind::Linear, bottom, end, c.pitch);
  }
  goTo(e, c, MotionKind::Rapid, clear, end, 0.0);
}

bool readCycle(Execution& e, ThreadCycle& c) {
  const BlockWords& w = e.words;
  const double unit = e.modal.inch ? kMillimetresPerInch : 1.0;
  for (const char letter : {'P', 'I', 'J', 'K'}) {
    if (!w.has(letter)) return failAt(e, code::kMissingWord, 'G', fmt::format("G76 needs {}", letter));
  }
  c.pitch = std::fabs(w.of('P')) * unit;
  c.peak = std::fabs(w.of('I')) * unit;
  c.first = std::fabs(w.of('J')) * unit;
  c.depth = std::fabs(w.of('K')) * unit;
  c.side = w.of('I') > 0.0 ? 1.0 : -1.0;
  c.degression = std::fmax(1.0, w.of('R', 1.0));
  c.slope = std::tan(radFromDeg(w.of('Q', 0.0)));
  c.taper = std::fmax(0.0, w.of('E', 0.0) * unit);
  c.taper_pitch = c.taper > 0.0 ? c.pitch * std::hypot(c.taper, c.peak + c.depth) / c.taper : c.pitch;
  const double ends = w.of('L', 0.0);
  c.taper_in = ends == 1.0 || ends == 3.0;
  c.taper_out = ends == 2.0 || ends == 3.0;
  const double spring = w.of('H', 0.0);
  if (!(c.pitch > 0.0) || !(c.first > 0.0) || !(c.depth > c.first) || !(spring >= 0.0 && spring <= 1000.0)) {
    return failAt(e, code::kBadValue, 'G',
                  "G76 needs P and J above zero, K larger than J, and H from 0 to 1000");
  }
  c.spring = static_cast<long>(spring);
  return true;
}

}  // namespace

bool executeThread76(Execution& e) {
  if (e.dialect != Dialect::LinuxCnc) {
    return failAt(e, code::kUnknownCode, 'G',
                  "The cycle G76 of this control is not understood and could be motion");
  }
  const std::array<int, 3> axes = planeAxes(e);
  if (e.modal.plane != 18 || axes[0] < 0 || axes[1] < 0)
    return failAt(e, code::kBadValue, 'G', "G76 needs the plane G18");
  if (e.modal.diameter)
    return failAt(e, code::kUnknownCode, 'G',
                  "G76 with diameters (G7) is not understood and could be motion");
  ThreadCycle c;
  if (!readCycle(e, c)) return false;
  c.z = index(axes[0]);
  c.x = index(axes[1]);
  c.drive = e.position[c.x];
  c.begin = e.position[c.z];
  const double end = endOfWords(e, e.frame)[c.z];
  c.target = end + c.depth * c.slope;
  if (end > c.begin) c.taper = -c.taper;
  e.motions.clear();
  const double full = c.peak + c.depth;
  std::size_t pass = 1;
  for (double infeed = c.peak + c.first; infeed < full && pass < kMostPasses; ++pass) {
    cutPass(e, c, infeed);
    infeed = c.peak + c.first * std::pow(static_cast<double>(pass + 1), 1.0 / c.degression);
  }
  for (long n = 0; n <= c.spring; ++n) cutPass(e, c, full);
  goTo(e, c, MotionKind::Rapid, c.drive, end, 0.0);
  e.executed.motions = e.motions;
  return true;
}

}  // namespace nineline::nc
