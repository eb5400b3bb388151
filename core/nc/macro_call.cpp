#include <fmt/format.h>

#include <cmath>

#include "core/nc/nc_error.h"
#include "core/nc/step.h"

namespace nineline::nc {
namespace {

/// Local variable of an argument letter (argument specification I); 0: no argument.
int variableOf(char letter) {
  switch (letter) {
    case 'A':
      return 1;
    case 'B':
      return 2;
    case 'C':
      return 3;
    case 'D':
      return 7;
    case 'E':
      return 8;
    case 'F':
      return 9;
    case 'H':
      return 11;
    case 'I':
      return 4;
    case 'J':
      return 5;
    case 'K':
      return 6;
    case 'M':
      return 13;
    default:
      return letter >= 'Q' && letter <= 'Z' ? letter - 'Q' + 17 : 0;
  }
}

}  // namespace

bool callMacro(Execution& e) {
  if (e.words.non_modal_code == 660)
    return failAt(e, code::kUnknownCode, 'G', "The modal macro call G66 is not executed and could be motion");
  const double p = e.words.of('P', -1.0);
  if (!(p >= 0.0 && p <= 99'999'999.0) || p != std::floor(p))
    return failAt(e, code::kMissingWord, 'G', "G65 needs P, the number of a program");
  e.jump.kind = JumpKind::CallNumber;
  e.jump.number = static_cast<long>(p);
  e.jump.repeats = static_cast<long>(std::fmin(1e8, std::fmax(1.0, e.words.of('L', 1.0))));
  e.jump.own_variables = true;
  e.jump.label.clear();
  e.jump.arguments.assign(34, Value{0.0, true});
  for (const Word& word : e.block.words) {
    const int variable =
        word.letter == 'G' || word.letter == 'P' || word.letter == 'L' ? 0 : variableOf(word.letter);
    if (variable > 0) e.jump.arguments[index(variable)] = {word.value, false};
  }
  e.words.m_codes = false;
  return true;
}

bool applyKeywords(Execution& e) {
  e.supa = false;
  for (const Keyword keyword : e.statement.keywords) {
    switch (keyword) {
      case Keyword::Supa:
        e.supa = true;
        break;
      case Keyword::TipControlOn:
        e.modal.tip_control = true;
        break;
      case Keyword::TipControlOff:
        e.modal.tip_control = false;
        break;
      case Keyword::DiameterOn:
        e.modal.diameter = true;
        e.frame_stale = true;
        break;
      case Keyword::DiameterOff:
        e.modal.diameter = false;
        e.frame_stale = true;
        break;
      case Keyword::ThreePointArc:
        return fail(e, code::kUnknownCode, 0, "CIP is not understood and is motion");
      case Keyword::TangentArc:
        return fail(e, code::kUnknownCode, 0, "CT is not understood and is motion");
      case Keyword::Return:
        return e.calls.empty() ? endProgram(e) : returnFromCall(e);
    }
  }
  e.gather_keywords = true;
  return true;
}

}  // namespace nineline::nc
