#include <algorithm>
#include <cmath>

#include "core/compensation/arc_geometry.h"
#include "core/compensation/program_corrector.h"

namespace nineline::compensation {

using nc::AxisMask;
using nc::AxisValues;
using nc::ExecutedBlock;
using nc::Motion;
using nc::MotionKind;
using nc::MotionRole;

namespace {

/// The feed motion of a drilling cycle that goes deepest, and the axis along which it drills; −1 where there
/// is none.
int drillingAxis(const ExecutedBlock& executed, int axes, Motion& deepest) {
  int axis = -1;
  double longest = 0.0;
  const Motion* first = nullptr;  // starts on the R plane
  for (const Motion& motion : executed.motions) {
    if (motion.kind != MotionKind::Linear) continue;
    if (first == nullptr) first = &motion;
    for (int i = 0; i < axes; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const double depth = std::abs(motion.end[k] - first->start[k]);
      if (motion.end[k] == motion.start[k] || depth <= longest) continue;
      longest = depth;
      axis = i;
      deepest = motion;
    }
  }
  return axis;
}

bool movesAcross(const Motion& motion, int drilling_axis, int axes) {
  for (int i = 0; i < axes; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (i != drilling_axis && motion.end[k] != motion.start[k]) return true;
  }
  return false;
}

bool isDrilling(int code) { return code == 73 || (code >= 81 && code <= 89); }

}  // namespace

bool ProgramCorrector::canCorrectCycle(const ExecutedBlock& executed) const {
  const bool cycle = std::all_of(executed.motions.begin(), executed.motions.end(), [](const Motion& motion) {
    return motion.role == MotionRole::Cycle && motion.kind != MotionKind::Arc;
  });
  const bool plain = std::none_of(executed.block->words.begin(), executed.block->words.end(),
                                  [](const nc::Word& word) { return word.expression; });
  return cycle && plain && isDrilling(executed.motion_code) && executed.frame->incremental == 0 &&
         executed.frame->rotation_plane[0] < 0;
}

/// The hole is put where its bottom belongs: the words of the plane, of the depth and of the R plane get the
/// correction of that one point. What the errors change over the depth remains, and the check shows it.
Result<void> ProgramCorrector::correctCycle(const ExecutedBlock& executed) {
  Motion bottom;
  const int axis = drillingAxis(executed, layout_.count, bottom);
  if (axis < 0) return keepAsItIs(executed);
  const Motion& last = executed.motions.back();
  turning_ = TurnWriting::NoTurn;
  writable_ = writableAxes(executed, last);
  frame_ = shiftedFrame(*executed.frame);
  if (Result<void> planned = planner_.plan(bottom, scopeOf(false), bottom.start, pieces_); !planned)
    return planned;
  const AxisMask plane = static_cast<AxisMask>(planner_.freeAxes() & ~nc::axisBit(axis));
  const auto along = static_cast<std::size_t>(axis);
  const double deeper = pieces_.back().end[along] - bottom.end[along];
  // Where the original stands over the hole already, the corrected program does too: no motion is added.
  const bool moves_over =  // a tool below the R plane rises first
      std::any_of(executed.motions.begin(), executed.motions.end(),
                  [&](const Motion& motion) { return movesAcross(motion, axis, layout_.count); });
  AxisValues target = moves_over ? pieces_.back().end : emitted_.position();
  target[along] = emitted_.position()[along];

  line_.clear();
  editor_.begin(*executed.block);
  const double initial = emitted_.position()[along];
  emitted_.moveTo(frame_, target, static_cast<AxisMask>(executed.has_word & ~nc::axisBit(axis)), plane,
                  decimals_, words_);
  for (const EmittedPosition::Word& word : words_) {
    const auto k = static_cast<std::size_t>(word.axis);
    editor_.setAxis(layout_.axes[k].id, word.value, decimals_[k], nc::contains(executed.has_word, word.axis));
  }
  // Depth and R plane move alike, so that a cycle pecks as often as before. The depth is modal: a hole that
  // needs another one states it.
  const nc::Word* retract = executed.block->find('R');
  const bool pecks = executed.motion_code == 73 || executed.motion_code == 83;
  const double factor = frame_.factor[along];
  const double change =
      pecks && retract == nullptr ? retract_change_ / factor : roundTo(deeper / factor, decimals_[along]);
  const double depth = roundTo(frame_.wordsOf(bottom.end, layout_.count)[along] + change, decimals_[along]);
  if (nc::contains(executed.has_word, axis) || (!pecks && depth != cycle_depth_))
    editor_.setAxis(layout_.axes[along].id, depth, decimals_[along], nc::contains(executed.has_word, axis));
  cycle_depth_ = depth;
  if (retract != nullptr) {
    editor_.setWord('R', roundTo(retract->value + change, decimals_[along]), decimals_[along]);
    retract_change_ = change * factor;
  }
  editor_.finish(line_);
  line_ += executed.block->line_end;

  const bool to_initial = std::abs(last.end[along] - ideal_position_[along]) < 1e-9;
  AxisValues end = last.end;
  end[along] = to_initial ? initial : last.end[along] + retract_change_;
  emitted_.jumpTo(end, nc::axisBit(axis));
  for (std::size_t i = 0; i < executed.motions.size(); ++i) log_.addWhole();
  for (const Motion& motion : executed.motions) planner_.pass(motion);
  ideal_position_ = last.end;
  ++report_.corrected;
  return assembler_.put(executed.block->line, line_);
}

Result<void> ProgramCorrector::keepAsItIs(const ExecutedBlock& executed) {
  for (const Motion& motion : executed.motions) {
    planner_.pass(motion);
    log_.addWhole();
    AxisMask moved = motion.commanded;
    for (int i = 0; i < layout_.count; ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (motion.end[k] != motion.start[k]) moved = static_cast<AxisMask>(moved | nc::axisBit(i));
    }
    emitted_.jumpTo(motion.end, moved);
    if (motion.role == MotionRole::Cycle) {
      report_.diagnostics.countedWarning(
          "compensation.cycle", "This canned cycle stays as programmed; its deviation remains.", motion.line);
    }
  }
  ideal_position_ = executed.motions.back().end;
  return keep(executed);
}

}  // namespace nineline::compensation
