// Blocks that turn rotary axes alone: what F becomes where linear axes join (resources/docs/adr/006).
#include <algorithm>
#include <cmath>

#include "core/compensation/program_corrector.h"

namespace nineline::compensation {

using nc::AxisMask;
using nc::AxisValues;
using nc::ExecutedBlock;
using nc::Motion;

void ProgramCorrector::chooseTurning(const ExecutedBlock& executed, const Motion& motion, bool at_end) {
  turning_ = turnWritingOf(motion, layout_, stated_, interpreter_.dialect(), options_.turning);
  if (turning_ == TurnWriting::NoTurn) return;
  // Behind a block that ends or leaves the program no line can put F back; a computed F cannot be restated.
  const nc::Word* feed = executed.block->find('F');
  const bool plain = feed == nullptr || !feed->expression;
  if (turning_ == TurnWriting::RestateFeed && (at_end || !plain)) turning_ = TurnWriting::Alone;
  feed_word_ = executed.feed_stated && feed != nullptr && plain ? feed->value : feedWordOf(motion, true);
  feed_in_force_.reset();
  if (!executed.feed_stated) feed_in_force_ = feed_word_;
  warnTurning(motion.line);
}

/// Goes to the end of a piece with the linear axes where the turn stays what it is, without them elsewhere.
void ProgramCorrector::moveBeside(const Motion& motion, const Piece& piece, AxisMask named) {
  const EmittedPosition before = emitted_;
  emitted_.moveTo(frame_, piece.end, named, writable_, decimals_, words_);
  const Travel travel = travelOf(before.position(), emitted_.position(), layout_);
  if (travel.linear == 0.0 || (turning_ != TurnWriting::Alone && isSlight(travel, motion.feed_unit))) return;
  emitted_ = before;
  AxisValues target = piece.end;
  const AxisMask linear = linearAxes();
  for (int i = 0; i < layout_.count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (nc::contains(linear, i)) target[k] = before.position()[k];
  }
  emitted_.moveTo(frame_, target, named, static_cast<AxisMask>(writable_ & ~linear), decimals_, words_);
  planner_.forget();
}

void ProgramCorrector::stateTurningFeed(const Motion& motion, const Piece& piece, const AxisValues& from) {
  if (turning_ != TurnWriting::RestateFeed) return;
  const Travel travel = travelOf(from, emitted_.position(), layout_);
  const bool together = !piece.take_up && travel.linear > 0.0 && travel.turned > 0.0;
  double word = feed_word_;
  int decimals = decimalsOf(word);
  if (together) {
    constexpr int kDigits = 6;
    word = restatedFeed(feed_word_, travel, motion.feed_unit);
    decimals = std::clamp(kDigits - 1 - static_cast<int>(std::floor(std::log10(word))), 0, 9);
  }
  if (feed_in_force_ == word) return;
  changed_ = editor_.setWord('F', word, decimals) || changed_;
  feed_in_force_ = word;
}

void ProgramCorrector::putFeedBack(const nc::Block& block, std::string_view line_end) {
  if (turning_ != TurnWriting::RestateFeed || !feed_in_force_ || *feed_in_force_ == feed_word_) return;
  editor_.beginNew(block);
  editor_.setWord('F', feed_word_, decimalsOf(feed_word_));
  editor_.finish(line_);
  line_ += line_end;
  ++report_.inserted;
}

}  // namespace nineline::compensation
