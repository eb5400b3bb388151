#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"
#include "core/nc/execution.h"
#include "core/nc/nc_error.h"

namespace nineline::nc {
namespace {

/// Lead of G33: K (LinuxCNC), I J K (Siemens) or F (Fanuc), in mm per turn.
bool findLead(Execution& e, double& lead) {
  const double unit = e.modal.inch ? kMillimetresPerInch : 1.0;
  if (e.dialect == Dialect::Fanuc) {
    lead = e.modal.feed_word * e.modal.feed_unit;
    return true;
  }
  lead = 0.0;
  for (const char letter : {'I', 'J', 'K'}) {
    if (e.words.has(letter)) lead = std::fmax(lead, std::fabs(e.words.of(letter)) * unit);
  }
  if (lead == 0.0) return failAt(e, code::kMissingWord, 'G', "A thread needs its lead");
  return true;
}

void goTo(Execution& e, MotionKind kind, const AxisValues& end, double lead) {
  appendStraight(e, kind, MotionRole::Cycle, end);
  if (kind == MotionKind::Rapid || lead <= 0.0) return;
  e.motions.back().feed_mode = FeedMode::PerRevolution;
  e.motions.back().feed = lead;
}

}  // namespace

bool executeThread(Execution& e, const WordFrame& frame) {
  if (e.words.axes == 0) return true;
  double lead = 0.0;
  if (!findLead(e, lead)) return false;
  Motion& motion = e.single;
  beginMotion(e, motion, MotionKind::Linear, MotionRole::Thread);
  motion.end = endOfWords(e, frame);
  motion.feed_mode = FeedMode::PerRevolution;
  motion.feed = lead;
  e.established |= static_cast<AxisMask>(e.words.axes & ~frame.incremental);
  motion.established = e.established;
  e.position = motion.end;
  e.executed.motions = {&motion, 1};
  e.executed.rewritable = e.words.axes == e.words.plain;
  return true;
}

bool executeRigidTap(Execution& e, const WordFrame& frame) {
  double lead = 0.0;
  if (!findLead(e, lead)) return false;
  if (e.words.axes == 0) return failAt(e, code::kMissingWord, 'G', "G33.1 needs axis words");
  e.motions.clear();
  const AxisValues begin = e.position;
  goTo(e, MotionKind::Linear, endOfWords(e, frame), lead);
  goTo(e, MotionKind::Linear, begin, lead);
  e.executed.motions = e.motions;
  return true;
}

/// Fanuc lathe, code system A: G90 (turning), G92 (threading) along Z, G94 (facing) along X; R is the taper.
bool executeTurningCycle(Execution& e, int tenths) {
  const int x = e.axis_of_letter[letterIndex('X')];
  const int z = e.axis_of_letter[letterIndex('Z')];
  if (x < 0 || z < 0) return failAt(e, code::kNoSuchAxis, 'G', "A turning cycle needs X and Z");
  if (e.words.axes == 0) return true;
  WordFrame frame = e.frame;
  frame.incremental = static_cast<AxisMask>(frame.incremental | e.words.increments);
  AxisValues target = endOfWords(e, frame);
  for (const int axis : {x, z}) {
    if (!contains(e.words.axes, axis)) target[index(axis)] = e.cycle.target[index(axis)];
  }
  e.cycle.target = target;
  const AxisValues begin = e.position;
  if (e.words.has('R')) e.cycle.taper = e.words.of('R') * (e.modal.inch ? kMillimetresPerInch : 1.0);
  const double taper = e.cycle.taper;
  const bool facing = tenths == 940;
  const std::size_t infeed = index(facing ? z : x);
  const std::size_t along = index(facing ? x : z);
  const double lead = tenths == 920 ? e.modal.feed_word * e.modal.feed_unit : 0.0;
  e.motions.clear();
  AxisValues at = begin;
  at[infeed] = target[infeed] + taper;
  goTo(e, MotionKind::Rapid, at, 0.0);
  at[infeed] = target[infeed];
  at[along] = target[along];
  goTo(e, MotionKind::Linear, at, lead);
  at[infeed] = begin[infeed];
  goTo(e, tenths == 920 ? MotionKind::Rapid : MotionKind::Linear, at, 0.0);
  at[along] = begin[along];
  goTo(e, MotionKind::Rapid, at, 0.0);
  e.executed.motions = e.motions;
  return true;
}

}  // namespace nineline::nc
