#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"
#include "core/nc/execution.h"
#include "core/nc/nc_error.h"

namespace nineline::nc {
namespace {

bool repeated(Execution& e, const Word& word) {
  return fail(e, code::kRepeatedWord, word.begin,
              fmt::format("The word {} stands twice in the block", word.letter));
}

bool addAxis(Execution& e, const Word& word, int axis, bool increment) {
  BlockWords& w = e.words;
  const AxisMask bit = axisBit(axis);
  if ((w.axes & bit) != 0) return repeated(e, word);
  w.axes |= bit;
  if (!word.expression) w.plain |= bit;
  if (increment || word.mode == WordMode::Increment) w.increments |= bit;
  if (word.mode == WordMode::Absolute || word.mode == WordMode::ShortestWay) w.absolutes |= bit;
  if (word.mode == WordMode::ShortestWay) w.shortest |= bit;
  w.value[index(axis)] = word.value;
  return true;
}

constexpr std::uint32_t kAxisLetters = letterBit('X') | letterBit('Y') | letterBit('Z') | letterBit('U') |
                                       letterBit('V') | letterBit('W') | letterBit('A') | letterBit('B') |
                                       letterBit('C');

/// An axis letter with a digit (`C2=`), or another word with one (`S1=`, `M1=`, `I1=`).
bool addDigitWord(Execution& e, const Word& word) {
  if ((letterBit(word.letter) & kAxisLetters) != 0) {
    const AxisId id{word.letter, word.digit};
    const int axis = e.options.axes.find(id);
    if (axis < 0)
      return fail(e, code::kNoSuchAxis, word.begin, fmt::format("The machine has no axis {}", id.text()));
    return addAxis(e, word, axis, false);
  }
  if (word.letter == 'S' || word.letter == 'M') return true;  // another spindle
  return fail(e, code::kUnknownCode, word.begin,
              fmt::format("{}{}= is not understood and could be motion", word.letter, word.digit));
}

bool addWord(Execution& e, const Word& word) {
  if (word.digit != 0) return addDigitWord(e, word);
  const int axis = e.axis_of_letter[letterIndex(word.letter)];
  if (axis >= 0) return addAxis(e, word, axis, false);
  switch (word.letter) {
    case 'G':
      return executeCode(e, word);
    case 'N':
    case 'O':
      return true;
    case 'M':
      e.words.m_codes = true;
      return true;
    case 'U':
    case 'V':
    case 'W': {
      const int target = e.increment_of_letter[letterIndex(word.letter)];
      const bool elsewhere =
          e.words.non_modal == CodeAction::MacroCall || e.words.non_modal == CodeAction::Dwell;
      if (target >= 0 && !elsewhere) return addAxis(e, word, target, true);
      break;
    }
    default:
      break;
  }
  const std::uint32_t bit = letterBit(word.letter);
  const bool twice = (e.words.letters & bit) != 0;
  if (twice && (e.dialect == Dialect::LinuxCnc || (word.letter >= 'I' && word.letter <= 'K') ||
                word.letter == 'R' || (bit & kAxisLetters) != 0)) {
    return repeated(e, word);
  }
  e.words.letters |= bit;
  if (word.mode == WordMode::Absolute) e.words.absolute_centre |= bit;
  e.words.letter[letterIndex(word.letter)] = word.value;
  return true;
}

}  // namespace

bool gatherWords(Execution& e) {
  BlockWords& w = e.words;
  w.axes = w.plain = w.increments = w.absolutes = w.shortest = 0;
  w.letters = w.groups = w.absolute_centre = 0;
  w.non_modal = w.motion_action = w.length_action = CodeAction::Unknown;
  w.machine_coordinates = w.unknown_code = w.cancels_cycle = w.m_codes = false;
  for (const Word& word : e.block.words) {
    if (!addWord(e, word)) return false;
  }
  return true;
}

}  // namespace nineline::nc
