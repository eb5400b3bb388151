#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"
#include "core/nc/execution.h"
#include "core/nc/nc_error.h"

namespace nineline::nc {
namespace {

/// The frame of this block's words: the modal one, or a copy where words of the block say otherwise.
const WordFrame& frameOfBlock(Execution& e) {
  const BlockWords& w = e.words;
  if (!w.machine_coordinates && (w.increments | w.absolutes) == 0) [[likely]]
    return e.frame;
  e.block_frame = e.frame;
  WordFrame& frame = e.block_frame;
  if (w.machine_coordinates) {
    frame.shift = {};
    frame.rotation_plane = {-1, -1};
    frame.cosine = 1.0;
    frame.sine = 0.0;
    frame.incremental = 0;
    return frame;
  }
  frame.incremental = static_cast<AxisMask>((frame.incremental | w.increments) & ~w.absolutes);
  return frame;
}

/// DC( ): the way shorter than half a turn to the same angle.
void goShortestWay(const Execution& e, AxisValues& end) {
  for (int i = 0; i < e.options.axes.count; ++i) {
    if (!contains(e.words.shortest, i)) continue;
    end[index(i)] = e.position[index(i)] + std::remainder(end[index(i)] - e.position[index(i)], kTurn);
  }
}

bool isRewritable(const Execution& e) {
  const BlockWords& w = e.words;
  return w.axes == w.plain && w.shortest == 0 && !w.machine_coordinates;
}

AxisMask establishedBy(const Execution& e, const WordFrame& frame) {
  AxisMask stated = static_cast<AxisMask>(e.words.axes & ~frame.incremental);
  if (frame.rotation_plane[0] >= 0) {
    const AxisMask plane =
        static_cast<AxisMask>(axisBit(frame.rotation_plane[0]) | axisBit(frame.rotation_plane[1]));
    if (((stated | e.established) & plane) != plane) stated = static_cast<AxisMask>(stated & ~plane);
  }
  return stated;
}

/// Whether rotary axes alone move, so that F counts degrees. A linear axis that is named where it stands does
/// not move; where nothing moves, the names decide.
bool turnsOnly(const Execution& e, const Motion& motion) {
  constexpr double kStandstill = 1e-9;  // mm, rad: what adding an offset and taking it off leaves
  AxisMask moved = 0;
  for (int i = 0; i < e.options.axes.count; ++i) {
    if (std::abs(motion.end[index(i)] - motion.start[index(i)]) > kStandstill) moved |= axisBit(i);
  }
  if (moved == 0) moved = motion.commanded;
  return moved != 0 && (moved & ~e.rotary) == 0;
}

}  // namespace

std::array<int, 3> planeAxes(const Execution& e) {
  const int x = e.axis_of_letter[letterIndex('X')];
  const int y = e.axis_of_letter[letterIndex('Y')];
  const int z = e.axis_of_letter[letterIndex('Z')];
  if (e.modal.plane == 18) return {z, x, y};
  if (e.modal.plane == 19) return {y, z, x};
  return {x, y, z};
}

AxisValues endOfWords(Execution& e, const WordFrame& frame) {
  const BlockWords& w = e.words;
  AxisValues end = e.position;
  if (frame.rotation_plane[0] < 0) [[likely]] {
    for (AxisMask rest = w.axes; rest != 0; rest = static_cast<AxisMask>(rest & (rest - 1U))) {
      const auto i = static_cast<std::size_t>(std::countr_zero(rest));
      const double moved = w.value[i] * frame.factor[i];
      end[i] = (frame.incremental & (1U << i)) != 0 ? end[i] + moved : moved + frame.shift[i];
    }
    return end;
  }
  AxisValues words = frame.wordsOf(e.position, e.options.axes.count);
  for (int i = 0; i < e.options.axes.count; ++i) {
    if (!contains(w.axes, i)) continue;
    words[index(i)] =
        contains(frame.incremental, i) ? words[index(i)] + w.value[index(i)] : w.value[index(i)];
  }
  const AxisValues turned = frame.positionOf(words, e.options.axes.count);
  for (int i = 0; i < e.options.axes.count; ++i) {
    const bool in_plane = i == frame.rotation_plane[0] || i == frame.rotation_plane[1];
    if (contains(w.axes, i) || in_plane) end[index(i)] = turned[index(i)];
  }
  return end;
}

void beginMotion(Execution& e, Motion& motion, MotionKind kind, MotionRole role) {
  motion.kind = kind;
  motion.role = role;
  motion.feed_mode = e.modal.feed_mode;
  motion.tool_centre_point = e.modal.tip_control;
  motion.cutter_compensation = e.modal.cutter;
  motion.commanded = e.words.axes;
  motion.line = e.block.line;
  motion.start = e.position;
  motion.spindle_speed = e.modal.surface_speed ? 0.0 : e.modal.spindle_word * (kTurn / 60.0);
}

void finishFeed(Execution& e, Motion& motion) {
  const ModalState& m = e.modal;
  motion.feed_unit = m.feed_unit;
  if (motion.kind == MotionKind::Rapid) {
    motion.feed = 0.0;
  } else if (m.feed_mode == FeedMode::InverseTime) {
    motion.feed = m.feed_word / 60.0;
  } else if (m.feed_mode == FeedMode::PerRevolution) {
    motion.feed = m.feed_word * m.feed_unit;
  } else {
    const bool degrees = motion.kind == MotionKind::Linear && turnsOnly(e, motion);
    motion.feed = degrees ? radFromDeg(m.feed_word) / 60.0 : m.feed_word * m.feed_unit / 60.0;
  }
}

void appendStraight(Execution& e, MotionKind kind, MotionRole role, const AxisValues& end) {
  Motion& motion = e.motions.emplace_back();
  beginMotion(e, motion, kind, role);
  motion.end = end;
  for (int i = 0; i < e.options.axes.count; ++i) {
    if (end[index(i)] != motion.start[index(i)]) motion.commanded |= axisBit(i);
  }
  finishFeed(e, motion);
  e.position = end;
  motion.established = e.established;
}

bool executeMotion(Execution& e) {
  const WordFrame& frame = frameOfBlock(e);
  e.executed.frame = &frame;
  const int mode = e.modal.motion;
  if (mode == 2 || mode == 3) return executeArc(e, frame);
  if (mode < 0)
    return failAt(e, code::kNoMotionMode, 0, "Axis words stand in the block, but no motion is active (G80)");
  if (mode >= 32) return executeThread(e, frame);
  if (e.words.axes == 0) return true;
  Motion& motion = e.single;
  const bool machine = e.words.machine_coordinates;
  if (machine && e.modal.incremental && e.dialect == Dialect::LinuxCnc) {
    return failAt(e, code::kBadValue, 'G', "G53 needs absolute words (G90)");
  }
  beginMotion(e, motion, mode == 0 ? MotionKind::Rapid : MotionKind::Linear,
              machine ? MotionRole::Machine : MotionRole::Block);
  motion.end = endOfWords(e, frame);
  if (e.words.shortest != 0) goShortestWay(e, motion.end);
  finishFeed(e, motion);
  e.established |= establishedBy(e, frame);
  motion.established = e.established;
  e.position = motion.end;
  e.executed.motions = {&motion, 1};
  e.executed.rewritable = isRewritable(e);
  return true;
}

}  // namespace nineline::nc
