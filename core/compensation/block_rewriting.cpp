#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/compensation/arc_geometry.h"
#include "core/compensation/program_corrector.h"

namespace nineline::compensation {

using nc::AxisMask;
using nc::AxisValues;
using nc::ExecutedBlock;
using nc::Motion;
using nc::MotionKind;

namespace {

/// M codes that act when the motion has ended: program stop and end, calls.
bool actsAtEnd(double code) {
  static constexpr std::array<double, 7> kCodes = {0, 1, 2, 30, 60, 98, 99};
  return std::find(kCodes.begin(), kCodes.end(), code) != kCodes.end();
}

/// Spindle off acts at the end on some controls and before the motion on others (LinuxCNC): such a block
/// stays one block. Coolant off is taken as LinuxCNC takes it, with the start.
bool dependsOnControl(double code) { return code == 5.0; }

struct Timing {
  bool at_start = false;
  bool at_end = false;
};

Timing timingOf(const nc::Block& block) {
  Timing timing;
  for (const nc::Word& word : block.words) {
    if (word.letter == 'M') (actsAtEnd(word.value) ? timing.at_end : timing.at_start) = true;
    if (word.letter == 'M' && dependsOnControl(word.value)) timing.at_end = true;
    if (word.letter == 'S' || word.letter == 'T') timing.at_start = true;
  }
  return timing;
}

constexpr double kCrossingFeed = 600.0;  // 1/min: play is crossed in a tenth of a second

/// The fewest decimals that state a feed to six.
int feedDecimals(double feed) {
  constexpr int kMost = 6;
  int decimals = 0;
  while (decimals < kMost && roundTo(feed, decimals) != roundTo(feed, kMost)) ++decimals;
  return decimals;
}

/// I J K belong to X Y Z and to the axes parallel to them.
char centreAddress(char axis) {
  switch (axis) {
    case 'X':
    case 'U':
      return 'I';
    case 'Y':
    case 'V':
      return 'J';
    default:
      return 'K';
  }
}

bool statesMotionCode(const nc::Block& block, int code) {
  return std::any_of(block.words.begin(), block.words.end(), [code](const nc::Word& word) {
    return word.letter == 'G' && word.value == static_cast<double>(code);
  });
}

/// G90, G54, G43 and the like take effect on the block's own line, so that no line of it may stand before.
bool setsModes(const nc::Block& block, int motion_code) {
  return std::any_of(block.words.begin(), block.words.end(), [motion_code](const nc::Word& word) {
    return word.letter == 'G' && word.value != static_cast<double>(motion_code);
  });
}

}  // namespace

Result<void> ProgramCorrector::correctMotion(const ExecutedBlock& executed, const Motion& motion) {
  const nc::Block& block = *executed.block;
  const Timing timing = timingOf(block);
  chooseTurning(executed, motion, timing.at_end);
  writable_ = writableAxes(executed, motion);
  frame_ = shiftedFrame(*executed.frame);
  const bool several_turns = motion.kind == MotionKind::Arc && std::abs(motion.sweep) > kTurn + 1e-9;
  const bool own_first = setsModes(block, executed.motion_code);
  // Parts of a block in inverse time need feeds of their own, which cannot be written into an expression.
  const nc::Word* const feed = block.find('F');
  const bool fixed_feed =
      motion.feed_mode == nc::FeedMode::InverseTime && feed != nullptr && feed->expression;
  const bool may_split = !((timing.at_start || own_first) && timing.at_end) && !several_turns && !fixed_feed;
  if (Result<void> planned = planner_.plan(motion, scopeOf(may_split), emitted_.position(), pieces_);
      !planned)
    return planned;
  const bool drops_take_up = own_first && motion.kind == MotionKind::Arc && pieces_.front().take_up;
  if (drops_take_up) pieces_.erase(pieces_.begin());
  if (planner_.exceeded() || drops_take_up) warnExceeded(block.line);
  writable_ = planner_.freeAxes();

  // The block's own line carries the first real piece, or the last one where an M code must wait for the end.
  std::size_t own = pieces_.size() - 1;
  if (!timing.at_end) {
    own = 0;
    while (pieces_[own].take_up && !own_first) ++own;
  }
  line_.clear();
  changed_ = false;
  own_line_follows_ = own > 0;
  written_.clear();
  const std::string_view line_end = block.line_end.empty() ? std::string_view("\n") : block.line_end;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    Piece& piece = pieces_[i];
    if (i != 0 && !piece.take_up && !written_.empty()) piece.from = written_.back().to;
    if (i == own) {
      writeOwnLine(executed, motion, piece);
    } else if (writeInsertedLine(executed, motion, piece, i < own)) {
      ++report_.inserted;
    } else {
      continue;  // shorter than the words resolve
    }
    written_.push_back(piece);
    line_ += line_end;
  }
  written_.back().to = pieces_.back().to;
  putFeedBack(block, line_end);
  // Only the last line of a file may lack its end.
  if (block.line_end.empty()) line_.pop_back();
  log_.add(written_);
  if (changed_ || written_.size() > 1) ++report_.corrected;
  return assembler_.put(block.line, line_);
}

MotionPlanner::Scope ProgramCorrector::scopeOf(bool may_split) const {
  MotionPlanner::Scope scope;
  scope.free = writable_;
  scope.held = turning_ == TurnWriting::Alone ? linearAxes() : AxisMask{0};
  scope.may_split = may_split;
  for (int i = 0; i < layout_.count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    scope.grid[k] = nc::contains(frame_.incremental, i) ? emitted_.position()[k] : frame_.shift[k];
  }
  return scope;
}

int ProgramCorrector::codeOf(const ExecutedBlock& executed, const Motion& motion, const Piece& piece) const {
  if (!piece.take_up) return executed.motion_code;
  const bool feed_known = motion.feed > 0.0 && !executed.feed_stated;
  if (motion.kind == MotionKind::Linear && feed_known) return executed.motion_code;
  return feed_known ? 1 : 0;
}

void ProgramCorrector::writeOwnLine(const ExecutedBlock& executed, const Motion& motion, const Piece& piece) {
  const nc::Block& block = *executed.block;
  editor_.begin(block);
  if (own_line_follows_ && active_code_ != executed.motion_code &&
      !statesMotionCode(block, executed.motion_code)) {
    editor_.addCode(executed.motion_code);
  }
  active_code_ = executed.motion_code;
  const AxisValues from = emitted_.position();
  writeAxisWords(motion, piece, executed.has_word, executed.centre_absolute, block.find('R') != nullptr);
  stateTurningFeed(motion, piece, from);
  if (motion.feed_mode == nc::FeedMode::InverseTime && pieces_.size() > 1) {
    const nc::Word* feed = block.find('F');
    if (feed != nullptr && !piece.take_up) {
      const double value = feed->value / (piece.to - piece.from);
      editor_.setWord('F', value, feedDecimals(value));
    }
  }
  editor_.finish(line_);
}

bool ProgramCorrector::writeInsertedLine(const ExecutedBlock& executed, const Motion& motion,
                                         const Piece& piece, bool before_own) {
  const nc::Block& block = *executed.block;
  const AxisValues from = emitted_.position();
  const int modal = active_code_;
  editor_.beginNew(block);
  const int code = codeOf(executed, motion, piece);
  const bool code_on_own_line = before_own && statesMotionCode(block, executed.motion_code);
  if (active_code_ != code || code_on_own_line) editor_.addCode(code);
  active_code_ = code;
  writeAxisWords(motion, piece, piece.take_up ? AxisMask{0} : executed.has_word, executed.centre_absolute,
                 false);
  if (emitted_.position() == from && !piece.arc) {
    active_code_ = modal;
    return false;
  }
  const nc::Word* feed = block.find('F');
  const bool inverse = motion.feed_mode == nc::FeedMode::InverseTime;
  if (turning_ == TurnWriting::RestateFeed) {
    stateTurningFeed(motion, piece, from);
  } else if (feed != nullptr && (inverse || (before_own && !piece.take_up))) {
    const double share = inverse ? piece.to - piece.from : 1.0;
    const double value =
        piece.take_up && inverse ? std::max(feed->value, kCrossingFeed) : feed->value / share;
    editor_.setWord('F', value, feedDecimals(value));
  }
  editor_.finish(line_);
  return true;
}

void ProgramCorrector::writeAxisWords(const Motion& motion, const Piece& piece, AxisMask named,
                                      bool centre_absolute, bool by_radius) {
  const AxisValues from = emitted_.position();
  if (turning_ == TurnWriting::NoTurn || piece.take_up) {
    emitted_.moveTo(frame_, piece.end, named, writable_, decimals_, words_);
  } else {
    moveBeside(motion, piece, named);
  }
  for (const EmittedPosition::Word& word : words_) {
    const auto k = static_cast<std::size_t>(word.axis);
    const bool stated = nc::contains(named, word.axis);
    changed_ = editor_.setAxis(layout_.axes[k].id, word.value, decimals_[k], stated) || changed_;
  }
  if (piece.arc) writeCentre(motion, piece, from, centre_absolute, by_radius);
}

/// The centre lies as far from the rounded start as from the rounded end; R stays R where it states the
/// centre well.
void ProgramCorrector::writeCentre(const Motion& motion, const Piece& piece, const AxisValues& from,
                                   bool centre_absolute, bool by_radius) {
  const auto first = static_cast<std::size_t>(motion.plane[0]);
  const auto second = static_cast<std::size_t>(motion.plane[1]);
  const AxisValues& to = emitted_.position();
  const Eigen::Vector2d a(from[first], from[second]);
  const Eigen::Vector2d b(to[first], to[second]);
  const Eigen::Vector2d centre = centreBetween(a, b, {piece.centre[0], piece.centre[1]});
  const double unit = frame_.factor[first] * (layout_.axes[first].diameter ? 2.0 : 1.0);
  const double radius = (a - centre).norm();
  if (by_radius) {
    if (0.5 * (b - a).norm() < 0.95 * radius) {
      const double sign = std::abs(piece.sweep) > kPi ? -1.0 : 1.0;
      changed_ =
          editor_.setWord('R', roundTo(sign * radius / unit, decimals_[first]), decimals_[first]) || changed_;
      return;
    }
    editor_.removeWord('R');
  }
  AxisValues place = to;
  place[first] = centre.x();
  place[second] = centre.y();
  AxisValues offset{};
  offset[first] = centre.x() - from[first];
  offset[second] = centre.y() - from[second];
  const AxisValues words =
      centre_absolute ? frame_.wordsOf(place, layout_.count) : frame_.incrementWordsOf(offset, layout_.count);
  for (const std::size_t k : {first, second}) {
    const double scale = !centre_absolute && layout_.axes[k].diameter ? 0.5 : 1.0;
    const double value = roundTo(words[k] * scale, decimals_[k]);
    changed_ = editor_.setWord(centreAddress(layout_.axes[k].id.letter), value, decimals_[k]) || changed_;
  }
}

}  // namespace nineline::compensation
