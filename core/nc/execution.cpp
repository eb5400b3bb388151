#include "core/nc/execution.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"
#include "core/nc/machine_variables.h"
#include "core/nc/nc_error.h"
#include "core/nc/step.h"
#include "core/nc/tokenizer.h"

namespace nineline::nc {
namespace {

constexpr std::uint32_t kAxisLetters = letterBit('X') | letterBit('Y') | letterBit('Z') | letterBit('U') |
                                       letterBit('V') | letterBit('W') | letterBit('A') | letterBit('B') |
                                       letterBit('C');

/// Faults that leave the block without effect; viewing goes on behind it.
bool isLexical(std::string_view code) {
  return code == code::kBadNumber || code == code::kBadWord || code == code::kBadExpression ||
         code == code::kUnclosedComment || code == code::kRepeatedWord;
}

bool takeFeedAndSpeed(Execution& e) {
  const BlockWords& w = e.words;
  for (const char letter : {'F', 'S'}) {
    if (w.has(letter) && w.of(letter) < 0.0) {
      return failAt(e, code::kBadValue, letter,
                    fmt::format("{} is {}; it cannot be negative", letter, w.of(letter)));
    }
  }
  if (w.has('F')) {
    e.modal.feed_word = w.of('F');
    e.modal.feed_unit = e.modal.inch ? kMillimetresPerInch : 1.0;
    e.executed.feed_stated = true;
  }
  if (w.has('S')) e.modal.spindle_word = w.of('S');
  if (w.has('T')) e.selected_tool = static_cast<int>(std::fmin(1e6, std::fmax(0.0, w.of('T'))));
  return true;
}

/// `Z1E2` is Z1 and a word E2, whatever its writer meant; only threads, data and macro calls have an E.
bool refuseExponent(Execution& e) {
  const BlockWords& w = e.words;
  const bool threads = e.modal.motion >= 32 || e.modal.turning == 920 ||
                       w.motion_action == CodeAction::Thread ||
                       w.motion_action == CodeAction::ThreadOrCycle76;
  if (threads || w.m_codes || w.non_modal == CodeAction::MacroCall || w.non_modal == CodeAction::Data)
    return true;
  for (std::size_t i = 1; i < e.block.words.size(); ++i) {
    const Word& word = e.block.words[i];
    if (word.letter != 'E' || e.block.words[i - 1].end != word.begin) continue;
    return fail(e, code::kBadNumber, word.begin,
                "A number has no exponent in an NC program, found 'E' behind it");
  }
  return true;
}

bool missingAxis(Execution& e) {
  for (const Word& word : e.block.words) {
    if (word.digit != 0 || (letterBit(word.letter) & kAxisLetters) == 0 ||
        e.axis_of_letter[letterIndex(word.letter)] >= 0)
      continue;
    return fail(e, code::kNoSuchAxis, word.begin, fmt::format("The machine has no axis {}", word.letter));
  }
  return true;
}

/// Blocks whose axis words are no motion.
bool executeNonModal(Execution& e) {
  switch (e.words.non_modal) {
    case CodeAction::Dwell:
    case CodeAction::PassWithAxes:
    case CodeAction::MacroModalEnd:
      return true;
    case CodeAction::SpindleLimit:
      return true;
    case CodeAction::ReferenceReturn:
      return executeReferenceReturn(e);
    case CodeAction::Data:
      return executeData(e);
    case CodeAction::SetPosition:
      return setPosition(e);
    case CodeAction::ClearPosition:
      e.offsets.position = e.offsets.suspended = {};
      break;
    case CodeAction::SuspendPosition:
      e.offsets.position = {};
      break;
    case CodeAction::RestorePosition:
      e.offsets.position = e.offsets.suspended;
      break;
    case CodeAction::LocalOffset:
      return setLocalOffset(e);
    case CodeAction::Rotate:
      return rotateFrame(e);
    case CodeAction::LengthDynamic:
      return applyToolLength(e, CodeAction::LengthDynamic);
    case CodeAction::MacroCall:
      return callMacro(e);
    default:
      break;
  }
  e.frame_stale = true;
  return true;
}

void beginCycle(Execution& e) {
  const int code = e.words.motion_tenths / 10;
  const int axis = planeAxes(e)[2];
  if (e.modal.cycle == 0) {
    e.cycle = {};
    e.cycle.initial = axis >= 0 ? e.position[index(axis)] : 0.0;
  }
  e.modal.cycle = code;
}

/// Axis words, or centre words beside a stated G02 G03, move; a cycle moves where it is stated or an axis is
/// named.
bool executeMotions(Execution& e) {
  const BlockWords& w = e.words;
  if (w.motion_action == CodeAction::Cycle) beginCycle(e);
  if (w.motion_action == CodeAction::ThreadOrCycle76) return executeThread76(e);
  if (w.cancels_cycle) {
    e.modal.cycle = 0;
    if (e.dialect == Dialect::LinuxCnc && w.motion_action == CodeAction::Unknown) e.modal.motion = -1;
  }
  if (w.motion_action == CodeAction::RigidTap) {
    e.executed.frame = &e.frame;
    return executeRigidTap(e, e.frame);
  }
  if (e.modal.turning != 0) return executeTurningCycle(e, e.modal.turning);
  if (e.modal.cycle != 0) {
    if (w.axes == 0 && !w.has('R')) return true;
    return executeCycle(e);
  }
  const bool centre = (w.letters & (letterBit('I') | letterBit('J') | letterBit('K'))) != 0 &&
                      (e.modal.motion == 2 || e.modal.motion == 3);
  return w.axes == 0 && !centre ? true : executeMotion(e);
}

/// LinuxCNC's G4 takes P alone: axis words beside it move, after the dwell. Elsewhere X, U, F and S state the
/// time, so that a motion code beside them leaves open what they mean.
bool settleDwell(Execution& e) {
  BlockWords& w = e.words;
  if (e.dialect != Dialect::LinuxCnc) {
    const bool open = w.axes != 0 && w.motion_action != CodeAction::Unknown;
    return !open ||
           failAt(e, code::kCodeConflict, 'G', "G04 and a motion code in one block both want its words");
  }
  w.non_modal = CodeAction::Unknown;
  const bool wants_p =
      w.axes != 0 && (e.modal.motion > 1 || e.modal.cycle != 0 || w.motion_action == CodeAction::Cycle);
  return !wants_p || failAt(e, code::kCodeConflict, 'P', "G4 and the motion of this block both want P");
}

bool executeWords(Execution& e) {
  BlockWords& w = e.words;
  if (w.non_modal == CodeAction::Dwell && !settleDwell(e)) return false;
  if (w.letters != 0) {
    if (w.non_modal != CodeAction::Dwell && w.non_modal != CodeAction::MacroCall &&
        (w.letters & kAxisLetters) != 0) {
      if (!missingAxis(e)) return false;
    }
    if (w.non_modal != CodeAction::Dwell && w.non_modal != CodeAction::MacroCall &&
        w.non_modal != CodeAction::SpindleLimit) {
      if (!takeFeedAndSpeed(e)) return false;
    }
    if (w.has('E') && !refuseExponent(e)) return false;
  }
  if (e.dialect == Dialect::Siemens && w.has('L')) {
    return failAt(e, code::kNoSuchLabel, 'L',
                  fmt::format("The subprogram L{} is not in this file", w.of('L')));
  }
  if (w.unknown_code) {
    const std::string name = fmt::format("G{}", w.unknown_tenths / 10.0);
    if (w.axes != 0)
      return failAt(e, code::kUnknownCode, 'G',
                    fmt::format("{} is not understood and could be motion", name));
    warnOnce(e, code::kPassedCode, fmt::format("{} is not understood; it is passed over", name));
  }
  if (e.frame_stale) refreshFrame(e);
  if (w.length_action != CodeAction::Unknown && !applyToolLength(e, w.length_action)) return false;
  if (e.frame_stale) refreshFrame(e);
  if (w.non_modal != CodeAction::Unknown) {
    if (w.non_modal == CodeAction::WorkOffsetExtended) {
      if (!selectExtendedOffset(e)) return false;
      refreshFrame(e);
    } else {
      return executeNonModal(e) && (!w.m_codes || executeStopCodes(e));
    }
  }
  if (!executeMotions(e)) return false;
  return !w.m_codes || executeStopCodes(e);
}

bool executeStatement(Execution& e) {
  Fault fault;
  readStatement(e.block, e.dialect, *e.parameters, e.statement, fault);
  for (const std::string& name : e.statement.passed) {
    warnOnce(e, code::kPassedCode, fmt::format("'{}' is passed over", name));
  }
  if (fault.found()) return fail(e, fault.code, fault.column, std::move(fault.text));
  for (const Assignment& one : e.statement.definitions) e.parameters->define(one.variable.name, one.value);
  if (e.statement.flow != Flow::None && !executeFlow(e)) return false;
  if (!applyKeywords(e)) return false;
  for (const Assignment& one : e.statement.assignments) {
    std::string why;
    if (!e.parameters->set(one.variable, one.value, why)) return fail(e, code::kNotConstant, one.column, why);
  }
  return true;
}

bool executeBlock(Execution& e) {
  e.gather_keywords = false;
  if (!readPlainWords(e.block, e.dialect)) {
    const bool entered = e.entered_branch;
    if (!executeStatement(e)) return false;
    if (entered) e.entered_branch = false;
  }
  if (e.block.words.empty()) return true;
  if (!gatherWords(e)) return false;
  if (e.gather_keywords) e.words.machine_coordinates |= e.supa;
  e.executed.has_word = e.words.plain;
  const bool done = executeWords(e);
  e.executed.motion_code = e.modal.cycle != 0 ? e.modal.cycle : e.modal.motion;
  return done;
}

/// A lexical fault becomes a diagnostic and the block moves nothing; every other ends execution.
bool settleFault(Execution& e) {
  if (!isLexical(e.failure->code)) return false;
  e.diagnostics.error(e.failure->code, e.failure->text, e.failure->line, e.failure->column);
  if (e.diagnostics.full()) return false;
  e.failure.reset();
  e.executed.motions = {};
  e.executed.rewritable = false;
  return true;
}

/// A second O number at the top level begins another program: the main program is over.
bool isNextProgram(Execution& e) {
  if (e.dialect != Dialect::Fanuc || !e.calls.empty()) return false;
  const Word* const o = e.block.find('O');
  return o && ++e.program_words > 1;
}

}  // namespace

bool fail(Execution& e, const char* code, std::uint32_t column, std::string text) {
  if (!e.failure)
    e.failure = badInput(code, std::move(text), e.source.name(), e.block.line, column + std::size_t{1});
  return false;
}

bool failAt(Execution& e, const char* code, char letter, std::string text) {
  const Word* word = letter != 0 ? e.block.find(letter) : nullptr;
  if (!word && !e.block.words.empty()) word = &e.block.words.front();
  return fail(e, code, word ? word->begin : 0, std::move(text));
}

void warnOnce(Execution& e, const char* code, const std::string& text) {
  if (e.diagnostics.all().size() < 2 * Diagnostics::kMostErrors)
    e.diagnostics.countedWarning(code, text, e.block.line);
}

Execution::Execution(TextSource& text, InterpreterOptions given)
    : source(text), options(std::move(given)), system(std::make_unique<MachineVariables>(*this)) {}
Execution::~Execution() = default;

bool step(Execution& e) {
  e.executed = {};
  if (e.jump.kind != JumpKind::None && !followJump(e)) return false;
  while (!e.ended && e.offset >= e.source.size()) {
    if (!atEndOfText(e)) return false;
  }
  if (e.ended) return false;
  const Result<TextSource::Line> line = e.source.lineAt(e.offset);
  if (!line) {
    e.failure = line.error();
    return false;
  }
  e.line_offset = e.offset;
  e.offset = line->next;
  e.block.line = ++e.line;
  e.block.text = line->text;
  e.block.line_end = line->line_end;
  e.block.skipped = false;
  e.executed.block = &e.block;
  e.executed.frame = &e.frame;
  e.executed.depth = static_cast<int>(e.calls.size());
  e.executed.repeated = e.line <= e.highest_line;
  if (!e.executed.repeated) e.highest_line = e.line;
  e.executed.motion_code = e.modal.cycle != 0 ? e.modal.cycle : e.modal.motion;
  if (e.skip_line) {
    e.skip_line = false;
    e.block.words.clear();
    return true;
  }
  if (e.options.block_skip && startsWithSlash(line->text)) {
    e.block.skipped = true;
    e.block.words.clear();
    return true;
  }
  const bool done = executeBlock(e) || settleFault(e);
  if (done && isNextProgram(e)) {
    warnOnce(e, code::kAssumed, "The main program ends without M30 where the next program begins");
    return endProgram(e);
  }
  return done;
}

void setUpAxes(Execution& e) {
  e.axis_of_letter.fill(-1);
  e.lathe = true;
  bool has_x = false;
  for (int i = 0; i < e.options.axes.count; ++i) {
    const AxisLayout::Axis& axis = e.options.axes.axes[index(i)];
    if (axis.rotary) e.rotary |= axisBit(i);
    if (axis.id.digit == 0) e.axis_of_letter[letterIndex(axis.id.letter)] = static_cast<std::int8_t>(i);
    if (axis.id.letter == 'Y') e.lathe = false;
    has_x = has_x || axis.id.letter == 'X';
  }
  e.increment_of_letter.fill(-1);
  const bool letters_free = e.axis_of_letter[letterIndex('U')] < 0 && e.axis_of_letter[letterIndex('W')] < 0;
  e.turning_codes = e.dialect == Dialect::Fanuc && e.lathe && has_x && letters_free &&
                    (e.signs.incremental_letters || e.signs.return_codes) && !e.signs.distance_codes;
  if (e.dialect == Dialect::Fanuc && e.lathe && letters_free) {
    e.increment_of_letter[letterIndex('U')] = e.axis_of_letter[letterIndex('X')];
    e.increment_of_letter[letterIndex('W')] = e.axis_of_letter[letterIndex('Z')];
  }
  if (e.lathe && has_x && e.axis_of_letter[letterIndex('Z')] >= 0) e.modal.plane = 18;
  e.position = e.options.start;
}

}  // namespace nineline::nc
