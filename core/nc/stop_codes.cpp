#include <fmt/format.h>

#include <cmath>

#include "core/nc/execution.h"
#include "core/nc/nc_error.h"

namespace nineline::nc {
namespace {

constexpr double kLargestProgram = 99'999'999.0;

bool wholeNumber(double value) {
  return value >= 0.0 && value <= kLargestProgram && value == std::floor(value);
}

/// P of M98: up to four digits a program; more digits are repeats before the last four.
bool callProgram(Execution& e, const Word& word) {
  if (!e.words.has('P'))
    return fail(e, code::kMissingWord, word.begin, "M98 needs P, the number of a subprogram");
  const double p = e.words.of('P');
  const double l = e.words.of('L', 1.0);
  if (!wholeNumber(p)) return failAt(e, code::kBadValue, 'P', fmt::format("{} is no program number", p));
  if (!wholeNumber(l)) return failAt(e, code::kBadValue, 'L', fmt::format("{} is no number of repeats", l));
  e.jump.kind = JumpKind::CallNumber;
  e.jump.number = static_cast<long>(p);
  e.jump.repeats = static_cast<long>(l);
  e.jump.own_variables = false;
  e.jump.label.clear();
  e.jump.column = word.begin;
  if (e.dialect == Dialect::Fanuc && e.jump.number > 9999 && !e.words.has('L')) {
    e.jump.repeats = e.jump.number / 10000;
    e.jump.number %= 10000;
  }
  if (e.jump.repeats == 0) e.jump.kind = JumpKind::None;
  return true;
}

bool callBlockNumber(Execution& e, const Word& word) {
  if (!e.words.has('P') || !wholeNumber(e.words.of('P')))
    return fail(e, code::kMissingWord, word.begin, "M97 needs P, the number of a block");
  e.jump.kind = JumpKind::CallBlock;
  e.jump.number = static_cast<long>(e.words.of('P'));
  e.jump.repeats = static_cast<long>(std::fmax(1.0, e.words.of('L', 1.0)));
  e.jump.own_variables = false;
  e.jump.label.clear();
  e.jump.column = word.begin;
  return true;
}

bool returnOrEnd(Execution& e, const Word& word) {
  if (e.calls.empty()) {
    if (e.dialect != Dialect::Siemens)
      warnOnce(e, code::kAssumed, "M99 in the main program repeats it for ever; one pass is executed");
    return endProgram(e);
  }
  const bool to_block = e.words.has('P') && e.dialect == Dialect::Fanuc;
  if (to_block) e.calls.back().repeats = 1;
  if (!returnFromCall(e)) return false;
  if (!to_block) return true;
  if (!wholeNumber(e.words.of('P')))
    return failAt(e, code::kBadValue, 'P', "M99 P needs the number of a block");
  e.jump = {};
  e.jump.kind = JumpKind::Goto;
  e.jump.number = static_cast<long>(e.words.of('P'));
  e.jump.column = word.begin;
  return true;
}

bool isRunTimeCode(const Execution& e, int code) { return e.dialect == Dialect::LinuxCnc && code == 66; }

bool executeMachineCode(Execution& e, const Word& word) {
  const int code = word.value >= 0.0 && word.value < 100'000.0 ? static_cast<int>(word.value) : -1;
  if (code < 0 || word.value != code)
    return fail(e, code::kBadValue, word.begin, fmt::format("M{} is no M code", word.value));
  switch (code) {
    case 2:
    case 30:
      return endProgram(e);
    case 98:
      return callProgram(e, word);
    case 97:
      if (e.dialect == Dialect::Fanuc) return callBlockNumber(e, word);
      break;
    case 99:
      return returnOrEnd(e, word);
    case 17:
      if (e.dialect == Dialect::Siemens) return returnOrEnd(e, word);
      return true;
    case 6:
      changeTool(e);
      return true;
    case 61:
      if (e.dialect == Dialect::LinuxCnc && e.words.has('Q'))
        e.current_tool = static_cast<int>(std::fmin(1e5, std::fmax(0.0, e.words.of('Q'))));
      return true;
    case 428:
    case 429:
    case 430:
      if (e.dialect == Dialect::LinuxCnc) {
        e.modal.tip_control = code != 429;
        return true;
      }
      break;
    default:
      break;
  }
  if (isRunTimeCode(e, code)) return true;  // its result #5399 is what cannot be known
  if (code <= 19 || (code >= 30 && code <= 99) || code > 999) return true;
  std::uint64_t& seen = e.warned_codes[static_cast<std::size_t>(code / 64)];
  const std::uint64_t bit = std::uint64_t{1} << (code % 64);
  if ((seen & bit) == 0) {
    seen |= bit;
    e.diagnostics.countedWarning(code::kPassedCode,
                                 fmt::format("M{} is passed over: what it does is up to the machine", code),
                                 e.block.line);
  }
  return true;
}

}  // namespace

bool executeStopCodes(Execution& e) {
  for (const Word& word : e.block.words) {
    if (word.letter == 'M' && word.digit == 0 && !executeMachineCode(e, word)) return false;
  }
  return true;
}

}  // namespace nineline::nc
