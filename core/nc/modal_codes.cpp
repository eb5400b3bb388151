#include <fmt/format.h>

#include <cmath>

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

void stale(Execution& e, bool changed) { e.frame_stale = e.frame_stale || changed; }

/// Modal codes that change how words become positions; false where the action is none of them.
bool applyWordModal(Execution& e, CodeAction action) {
  ModalState& m = e.modal;
  const auto set = [&e](bool& value, bool to) {
    stale(e, value != to);
    value = to;
    return true;
  };
  switch (action) {
    case CodeAction::Inch:
      return set(m.inch, true);
    case CodeAction::Millimetre:
      return set(m.inch, false);
    case CodeAction::Absolute:
      return set(m.incremental, false);
    case CodeAction::Incremental:
      return set(m.incremental, true);
    case CodeAction::DiameterOn:
      return set(m.diameter, true);
    case CodeAction::DiameterOff:
      return set(m.diameter, false);
    case CodeAction::RotateOff:
      return set(e.offsets.rotated, false);
    case CodeAction::NoWorkOffset:
      e.offsets.active = -1;
      stale(e, true);
      return true;
    default:
      return false;
  }
}

/// Modal codes that only set a value; false where the action is none of them.
bool applySimpleModal(Execution& e, CodeAction action, int tenths) {
  ModalState& m = e.modal;
  switch (action) {
    case CodeAction::Plane:
      m.plane = tenths / 10;
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

/// Feed mode and return level; false where the action is none of them.
bool applyFeedModal(Execution& e, CodeAction action) {
  switch (action) {
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
    default:
      return false;
  }
}

void beginTurningCycle(Execution& e, int tenths) {
  e.modal.turning = tenths;
  e.modal.cycle = 0;
  e.cycle.taper = 0.0;
  e.cycle.target = e.position;
}

bool applyCode(Execution& e, const Word& word, int tenths, const CodeEntry& entry) {
  if (isTurningCycle(e, tenths)) return beginTurningCycle(e, tenths), true;
  const CodeAction action = entry.action;
  switch (action) {
    case CodeAction::Motion:
    case CodeAction::Thread:
    case CodeAction::RigidTap:
    case CodeAction::Cycle:
    case CodeAction::ThreadOrCycle76:
      setMotion(e, action, tenths);
      return true;
    case CodeAction::CancelCycle:
      e.words.cancels_cycle = true;
      return true;
    case CodeAction::MachineCoordinates:
      e.words.machine_coordinates = true;
      return true;
    case CodeAction::WorkOffset:
      return selectWorkOffset(e, tenths);
    case CodeAction::LengthPlus:
    case CodeAction::LengthMinus:
    case CodeAction::LengthAdd:
    case CodeAction::LengthOff:
    case CodeAction::TipControl:
      e.words.length_action = action;
      return true;
    case CodeAction::Refuse:
    case CodeAction::Polar:
      return refuse(e, word, tenths);
    case CodeAction::Unknown:
      e.words.unknown_code = true;
      e.words.unknown_tenths = tenths;
      return true;
    default:
      break;
  }
  if (applyWordModal(e, action) || applySimpleModal(e, action, tenths) || applyFeedModal(e, action))
    return true;
  return claim(e, action, tenths, word);
}

}  // namespace

bool executeCode(Execution& e, const Word& word) {
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

}  // namespace nineline::nc
