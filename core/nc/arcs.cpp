#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"
#include "core/nc/execution.h"
#include "core/nc/nc_error.h"

namespace nineline::nc {
namespace {

constexpr double kFullTurnSlack = 1e-6;  ///< rad: an arc shorter than this is a full turn, as LinuxCNC has it
constexpr double kLinuxCncRadiusSlack = 1.27e-3;  ///< mm: LinuxCNC's default for centre and radius arcs
constexpr double kRadiusSlack = 1e-2;             ///< mm: the usual setting of Fanuc and Siemens
constexpr double kRelativeRadiusSlack = 1e-3;

double radiusSlack(const Execution& e) {
  return e.dialect == Dialect::LinuxCnc ? kLinuxCncRadiusSlack : kRadiusSlack;
}

struct ArcPlane {
  std::size_t u, v;
  char u_letter, v_letter;  ///< of the centre words: I J, K I, J K
};

bool findPlane(Execution& e, ArcPlane& plane) {
  const std::array<int, 3> axes = planeAxes(e);
  if (axes[0] < 0 || axes[1] < 0) {
    return failAt(e, code::kNoSuchAxis, 'G',
                  fmt::format("An arc in the plane of G{} needs axes that the machine lacks", e.modal.plane));
  }
  plane = {index(axes[0]), index(axes[1]),
           e.modal.plane == 17   ? 'I'
           : e.modal.plane == 18 ? 'K'
                                 : 'J',
           e.modal.plane == 17   ? 'J'
           : e.modal.plane == 18 ? 'I'
                                 : 'K'};
  return true;
}

/// Centre from I J K: increments from the start, or (G90.1) words.
void centreFromWords(Execution& e, const WordFrame& frame, const ArcPlane& plane, Motion& motion) {
  const BlockWords& w = e.words;
  const double unit = e.modal.inch ? kMillimetresPerInch : 1.0;
  const double u = w.of(plane.u_letter, 0.0) * unit;
  const double v = w.of(plane.v_letter, 0.0) * unit;
  AxisValues centre{};
  centre[plane.u] = u / frame.factor[plane.u];
  centre[plane.v] = v / frame.factor[plane.v];
  const bool u_absolute = e.modal.arc_absolute || (w.absolute_centre & letterBit(plane.u_letter)) != 0;
  const bool v_absolute = e.modal.arc_absolute || (w.absolute_centre & letterBit(plane.v_letter)) != 0;
  e.executed.centre_absolute = u_absolute && v_absolute;
  e.executed.centre_mixed = u_absolute != v_absolute;
  if (!u_absolute && !v_absolute) {
    const AxisValues offset = frame.displacementOf(centre, e.options.axes.count);
    motion.centre = {motion.start[plane.u] + offset[plane.u], motion.start[plane.v] + offset[plane.v]};
    return;
  }
  const AxisValues start = frame.wordsOf(motion.start, e.options.axes.count);
  if (!u_absolute) centre[plane.u] += start[plane.u];
  if (!v_absolute) centre[plane.v] += start[plane.v];
  const AxisValues position = frame.positionOf(centre, e.options.axes.count);
  motion.centre = {position[plane.u], position[plane.v]};
}

bool centreFromRadius(Execution& e, const ArcPlane& plane, bool ccw, Motion& motion) {
  const double radius = e.words.of('R') * (e.modal.inch ? kMillimetresPerInch : 1.0);
  const double du = motion.end[plane.u] - motion.start[plane.u];
  const double dv = motion.end[plane.v] - motion.start[plane.v];
  const double half = std::hypot(du, dv) / 2.0;
  if (half == 0.0)
    return failAt(e, code::kBadArc, 'R', "A radius arc needs an end that differs from its start");
  if (half - std::fabs(radius) > radiusSlack(e)) {
    return failAt(e, code::kBadArc, 'R',
                  fmt::format("The radius {:.6g} mm is too small: start and end lie {:.6g} mm apart",
                              std::fabs(radius), 2.0 * half));
  }
  const double height = half < std::fabs(radius) ? std::sqrt(radius * radius - half * half) : 0.0;
  const double side = (radius < 0.0) == ccw ? -height : height;  // left of the chord for a short G03
  motion.centre = {motion.start[plane.u] + du / 2.0 - side * dv / (2.0 * half),
                   motion.start[plane.v] + dv / 2.0 + side * du / (2.0 * half)};
  return true;
}

bool checkRadii(Execution& e, const ArcPlane& plane, const Motion& motion) {
  const double start =
      std::hypot(motion.start[plane.u] - motion.centre[0], motion.start[plane.v] - motion.centre[1]);
  const double end =
      std::hypot(motion.end[plane.u] - motion.centre[0], motion.end[plane.v] - motion.centre[1]);
  const double gap = std::fabs(start - end);
  if (start <= 0.0 || end <= 0.0) return failAt(e, code::kBadArc, plane.u_letter, "The arc has radius zero");
  if (gap > 100.0 * radiusSlack(e) ||
      (gap > radiusSlack(e) && gap > kRelativeRadiusSlack * std::fmax(start, end))) {
    return failAt(
        e, code::kBadArc, plane.u_letter,
        fmt::format("The radius is {:.6g} mm at the start of the arc and {:.6g} mm at its end", start, end));
  }
  return true;
}

void computeSweep(const ArcPlane& plane, bool ccw, double turns, Motion& motion) {
  const double su = motion.start[plane.u] - motion.centre[0];
  const double sv = motion.start[plane.v] - motion.centre[1];
  const double eu = motion.end[plane.u] - motion.centre[0];
  const double ev = motion.end[plane.v] - motion.centre[1];
  double sweep = std::atan2(su * ev - sv * eu, su * eu + sv * ev);
  if (!ccw) sweep = -sweep;
  if (sweep < kFullTurnSlack) sweep += kTurn;
  sweep += turns * kTurn;
  motion.sweep = ccw ? sweep : -sweep;
}

/// LinuxCNC: P is the number of turns; Siemens: TURN is what is added, gathered as P.
bool extraTurns(Execution& e, double& turns) {
  turns = 0.0;
  if (e.dialect == Dialect::Fanuc || !e.words.has('P')) return true;
  const double p = e.words.of('P');
  const double least = e.dialect == Dialect::LinuxCnc ? 1.0 : 0.0;
  if (p != std::floor(p) || p < least || p > 10000.0)
    return failAt(e, code::kBadValue, 'P', fmt::format("{} is no number of turns", p));
  turns = p - least;
  return true;
}

}  // namespace

bool executeArc(Execution& e, const WordFrame& frame) {
  const BlockWords& w = e.words;
  ArcPlane plane{};
  const bool has_centre = (w.letters & (letterBit('I') | letterBit('J') | letterBit('K'))) != 0;
  if (w.axes == 0 && !has_centre) return true;
  if (!findPlane(e, plane)) return false;
  Motion& motion = e.single;
  beginMotion(e, motion, MotionKind::Arc, w.machine_coordinates ? MotionRole::Machine : MotionRole::Block);
  if (w.machine_coordinates)
    return failAt(e, code::kBadArc, 'G', "An arc in machine coordinates (G53) is not possible");
  const bool turned = frame.rotation_plane[0] >= 0;
  if (turned && (index(frame.rotation_plane[0]) != plane.u || index(frame.rotation_plane[1]) != plane.v)) {
    return failAt(e, code::kBadArc, 'G',
                  "An arc outside the plane in which the frame is turned is not possible");
  }
  motion.end = endOfWords(e, frame);
  const bool ccw = e.modal.motion == 3;
  motion.plane = {static_cast<std::int8_t>(plane.u), static_cast<std::int8_t>(plane.v)};
  double turns = 0.0;
  if (!extraTurns(e, turns)) return false;
  if (w.has('R')) {
    if (has_centre && e.dialect == Dialect::LinuxCnc)
      return failAt(e, code::kCodeConflict, 'R', "An arc has either a radius or a centre");
    if (!centreFromRadius(e, plane, ccw, motion)) return false;
  } else {
    if (!w.has(plane.u_letter) && !w.has(plane.v_letter)) {
      return failAt(e, code::kMissingWord, 0,
                    fmt::format("An arc needs {}, {} or R", plane.u_letter, plane.v_letter));
    }
    centreFromWords(e, frame, plane, motion);
    if (!checkRadii(e, plane, motion)) return false;
  }
  computeSweep(plane, ccw, turns, motion);
  finishFeed(e, motion);
  e.established |= static_cast<AxisMask>(w.axes & ~frame.incremental);
  motion.established = e.established;
  e.position = motion.end;
  e.executed.motions = {&motion, 1};
  e.executed.rewritable = w.axes == w.plain && !e.executed.centre_mixed;
  return true;
}

}  // namespace nineline::nc
