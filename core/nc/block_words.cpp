#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"
#include "core/nc/execution.h"
#include "core/nc/nc_error.h"

namespace nineline::nc {
namespace {

const char* groupName(unsigned group) {
  static constexpr const char* kNames[] = {"",
                                           "motion",
                                           "plane",
                                           "distance",
                                           "arc distance",
                                           "feed mode",
                                           "units",
                                           "cutter compensation",
                                           "tool length",
                                           "cycle",
                                           "return level",
                                           "",
                                           "work offset",
                                           "path",
                                           "spindle",
                                           "diameter",
                                           "rotation"};
  return group < std::size(kNames) ? kNames[group] : "";
}

/// Modal codes that only set a value; false where the action is none of them.
bool applySimpleModal(Execution& e, CodeAction action, int tenths) {
  ModalState& m = e.modal;
  switch (action) {
    case CodeAction::Plane:
      m.plane = tenths / 10;
      return true;
    case CodeAction::Inch:
      e.frame_stale |= !m.inch;
      m.inch = true;
      return true;
    case CodeAction::Millimetre:
      e.frame_stale |= m.inch;
      m.inch = false;
      return true;
    case CodeAction::CutterOff:
      m.cutter = 0;
      return true;
    case CodeAction::CutterLeft:
      m.cutter = -1;
      return true;
    case CodeAction::CutterRight:
      m.cutter = 1;
      return true;
    case CodeAction::Absolute:
      e.frame_stale |= m.incremental;
      m.incremental = false;
      return true;
    case CodeAction::Incremental:
      e.frame_stale |= !m.incremental;
      m.incremental = true;
      return true;
    case CodeAction::ArcAbsolute:
      m.arc_absolute = true;
      return true;
    case CodeAction::ArcIncremental:
      m.arc_absolute = false;
      return true;
    case CodeAction::SurfaceSpeed:
      m.surface_speed = true;
      return true;
    case CodeAction::SpindleSpeed:
      m.surface_speed = false;
      return true;
    case CodeAction::DiameterOn:
      m.diameter = true;
      e.frame_stale = true;
      return true;
    case CodeAction::DiameterOff:
      m.diameter = false;
      e.frame_stale = true;
      return true;
    case CodeAction::RotateOff:
      e.offsets.rotated = false;
      e.frame_stale = true;
      return true;
    case CodeAction::Pass:
      return true;
    default:
      return false;
  }
}

void setFeedMode(Execution& e, FeedMode mode) {
  if (e.modal.feed_mode != mode) e.modal.feed_word = 0.0;
  e.modal.feed_mode = mode;
}

/// G98 and G99 are the return level of cycles or, on Fanuc lathes of code system A, the feed mode.
void applyReturn(Execution& e, bool plane) {
  if (e.turning_codes) {
    setFeedMode(e, plane ? FeedMode::PerRevolution : FeedMode::PerMinute);
  } else {
    e.modal.return_to_plane = plane;
  }
}

bool refuse(Execution& e, const Word& word, int tenths) {
  const std::string name =
      tenths % 10 ? fmt::format("G{}.{}", tenths / 10, tenths % 10) : fmt::format("G{}", tenths / 10);
  return fail(e, code::kUnknownCode, word.begin,
              fmt::format("{} is not understood and could be motion", name));
}

bool claim(Execution& e, CodeAction action, int tenths, const Word& word) {
  BlockWords& w = e.words;
  if (w.non_modal != CodeAction::Unknown && w.non_modal != action) {
    return fail(
        e, code::kCodeConflict, word.begin,
        fmt::format("G{} and G{} in one block both want its words", w.non_modal_code / 10, tenths / 10));
  }
  w.non_modal = action;
  w.non_modal_code = tenths;
  return true;
}

void setMotion(Execution& e, CodeAction action, int tenths) {
  e.words.motion_action = action;
  e.words.motion_tenths = tenths;
  if (action == CodeAction::Motion || action == CodeAction::Thread) {
    e.modal.motion = tenths / 10;
    e.modal.cycle = 0;
    e.modal.turning = 0;
  }
}

/// Turning cycles G90, G92, G94 of Fanuc lathes (code system A) stand where other controls have modal codes.
/// G92 with a feed cuts a thread on any Fanuc lathe.
bool isTurningCycle(const Execution& e, int tenths) {
  if (tenths != 900 && tenths != 940 && tenths != 920) return false;
  if (e.turning_codes) return true;
  return tenths == 920 && e.lathe && e.dialect == Dialect::Fanuc && e.block.find('F') &&
         (e.block.find('X') || e.block.find('Z'));
}

bool applyCode(Execution& e, const Word& word, int tenths, const CodeEntry& entry) {
  if (isTurningCycle(e, tenths)) {
    e.modal.turning = tenths;
    e.modal.cycle = 0;
    e.cycle.taper = 0.0;
    e.cycle.target = e.position;
    return true;
  }
  if (applySimpleModal(e, entry.action, tenths)) return true;
  switch (entry.action) {
    case CodeAction::Motion:
    case CodeAction::Thread:
      setMotion(e, entry.action, tenths);
      return true;
    case CodeAction::RigidTap:
      setMotion(e, entry.action, tenths);
      return true;
    case CodeAction::Cycle:
      setMotion(e, entry.action, tenths);
      return true;
    case CodeAction::ThreadOrCycle76:
      setMotion(e, entry.action, tenths);
      return true;
    case CodeAction::CancelCycle:
      e.words.cancels_cycle = true;
      return true;
    case CodeAction::InverseTime:
      setFeedMode(e, FeedMode::InverseTime);
      return true;
    case CodeAction::PerMinute:
      setFeedMode(e, FeedMode::PerMinute);
      return true;
    case CodeAction::PerRevolution:
      setFeedMode(e, FeedMode::PerRevolution);
      return true;
    case CodeAction::ReturnInitial:
      applyReturn(e, false);
      return true;
    case CodeAction::ReturnPlane:
      applyReturn(e, true);
      return true;
    case CodeAction::MachineCoordinates:
      e.words.machine_coordinates = true;
      return true;
    case CodeAction::WorkOffset:
      return selectWorkOffset(e, tenths);
    case CodeAction::NoWorkOffset:
      e.offsets.active = -1;
      e.frame_stale = true;
      return true;
    case CodeAction::LengthPlus:
    case CodeAction::LengthMinus:
    case CodeAction::LengthDynamic:
    case CodeAction::LengthAdd:
    case CodeAction::LengthOff:
    case CodeAction::TipControl:
      if (entry.action == CodeAction::LengthDynamic) return claim(e, entry.action, tenths, word);
      e.words.length_action = entry.action;
      return true;
    case CodeAction::Refuse:
    case CodeAction::Polar:
      return refuse(e, word, tenths);
    case CodeAction::Unknown:
      e.words.unknown_code = true;
      e.words.unknown_tenths = tenths;
      return true;
    default:
      return claim(e, entry.action, tenths, word);
  }
}

bool readCode(Execution& e, const Word& word) {
  const double scaled = word.value * 10.0;
  const int tenths = static_cast<int>(scaled + 0.5);
  if (!(scaled >= 0.0 && scaled < 9999.5) || std::fabs(scaled - tenths) > 1e-6) {
    return fail(e, code::kBadValue, word.begin, fmt::format("G{} is no G code", word.value));
  }
  const CodeEntry entry = (*e.codes)[static_cast<std::size_t>(tenths)];
  if (entry.group != 0) {
    const std::uint32_t bit = 1U << entry.group;
    if ((e.words.groups & bit) != 0 && e.dialect == Dialect::LinuxCnc) {
      return fail(e, code::kCodeConflict, word.begin,
                  fmt::format("Two codes of the group '{}' in one block", groupName(entry.group)));
    }
    e.words.groups |= bit;
  }
  return applyCode(e, word, tenths, entry);
}

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
      return readCode(e, word);
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
