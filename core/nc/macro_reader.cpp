#include <fmt/format.h>

#include <cmath>

#include "core/base/text.h"
#include "core/nc/expression.h"
#include "core/nc/nc_error.h"
#include "core/nc/statement_reader.h"

namespace nineline::nc {
namespace {

long labelNumber(LineReader& r, const char* what) {
  Expression expression(r.dialect, r.parameters, r.fault);
  const Cursor begin = r.at;
  const double number = expression.value(r.at).number;
  if (r.fault.found()) return -1;
  if (!(number >= 0.0 && number <= 99'999'999.0) || number != std::floor(number)) {
    r.fault.set(code::kBadValue, begin.column(),
                fmt::format("{} needs a whole number, found {}", what, number));
  }
  return static_cast<long>(number);
}

void readAssignment(LineReader& r) {
  Expression expression(r.dialect, r.parameters, r.fault);
  Assignment assignment;
  assignment.column = r.at.column();
  ++r.at.p;
  assignment.variable = expression.variable(r.at);
  if (r.fault.found()) return;
  if (!r.at.take('=')) return r.fail(code::kBadExpression, "'=' expected after the variable");
  // Fanuc needs no brackets around an expression; LinuxCNC takes one value, so that words may follow.
  assignment.value = r.dialect == Dialect::Fanuc ? expression.whole(r.at) : expression.value(r.at);
  r.out.assignments.push_back(std::move(assignment));
}

void readGoto(LineReader& r, bool taken) {
  r.at.skipBlanks();
  if (r.at.peek() == 'N') ++r.at.p;
  const long number = labelNumber(r, "GOTO");
  if (!taken) return;
  r.out.flow = Flow::Goto;
  r.out.number = number;
}

void readIf(LineReader& r) {
  Expression expression(r.dialect, r.parameters, r.fault);
  const bool truth = expression.bracketed(r.at).number != 0.0;
  if (r.fault.found()) return;
  r.at.skipBlanks();
  if (r.at.takeWord("GOTO")) return readGoto(r, truth);
  if (!r.at.takeWord("THEN"))
    return r.fail(code::kBadExpression, "GOTO or THEN expected after the condition of IF");
  if (!truth) r.at.p = r.at.last;
}

void readLoop(LineReader& r, bool with_condition) {
  Expression expression(r.dialect, r.parameters, r.fault);
  if (with_condition) {
    r.out.truth = expression.bracketed(r.at).number != 0.0;
    r.at.skipBlanks();
    if (!r.fault.found() && !r.at.takeWord("DO"))
      r.fail(code::kBadExpression, "DO expected after the condition of WHILE");
  }
  r.out.number = r.fault.found() ? -1 : labelNumber(r, "DO");
  r.out.flow = Flow::WhileDo;
}

/// Keywords of Fanuc's macro language; false where none stands here.
bool readFanucKeyword(LineReader& r) {
  r.out.flow_column = r.at.column();
  if (r.at.takeWord("IF")) return readIf(r), true;
  if (r.at.takeWord("GOTO")) return readGoto(r, true), true;
  if (r.at.takeWord("WHILE")) return readLoop(r, true), true;
  if (r.at.takeWord("END")) {
    r.out.number = labelNumber(r, "END");
    r.out.flow = Flow::End;
    return true;
  }
  if (r.at.takeWord("DO")) return readLoop(r, false), true;
  for (const std::string_view name : {"POPEN", "PCLOS", "DPRNT", "BPRNT", "SETVN"}) {
    if (!r.at.takeWord(name)) continue;
    r.out.passed.emplace_back(name);
    r.at.p = r.at.last;
    return true;
  }
  return false;
}

/// Joins `1. 5` to 1.5, as RS274 allows blanks anywhere.
bool readSpacedNumber(LineReader& r, Word& word) {
  std::string joined;
  const char* p = r.at.p;
  const char* end = p;
  for (; p != r.at.last &&
         (isDigit(*p) || *p == '.' || isBlank(*p) || (joined.empty() && (*p == '-' || *p == '+')));
       ++p) {
    if (isBlank(*p)) continue;
    joined += *p;
    end = p + 1;
  }
  Decimal number;
  const char* const used = readDecimal(joined.data(), joined.data() + joined.size(), number);
  if (!used || used != joined.data() + joined.size() || !(std::fabs(number.value) <= 1e12)) return false;
  r.at.p = end;
  word.value = number.value;
  word.decimal_point = number.point;
  word.decimals = number.decimals;
  word.end = r.at.column();
  return true;
}

bool isNumberStart(const Cursor& at) {
  const char c = at.peek();
  const char next = at.peek(1);
  return isDigit(c) || c == '.' || ((c == '-' || c == '+') && (isDigit(next) || next == '.'));
}

/// The bracketed values after a keyword. A condition is read as well where it will not be used: it is cheap,
/// and a variable without value is then no fault (`else if` behind a branch that was taken).
void readOWordValues(LineReader& r, Expression& expression) {
  while (!r.fault.found() && skipToItem(r) && r.at.peek() == '[')
    r.out.arguments.push_back(expression.bracketed(r.at));
  if (r.fault.found()) return;
  const bool condition = r.out.flow == Flow::If || r.out.flow == Flow::ElseIf || r.out.flow == Flow::While ||
                         r.out.flow == Flow::EndWhile || r.out.flow == Flow::Repeat;
  const bool needed = condition && r.out.flow != Flow::EndWhile;
  if (needed && r.out.arguments.size() != 1)
    return r.fail(code::kBadFlow, "One '[condition]' expected after the keyword");
  if (condition && !r.out.arguments.empty()) {
    r.out.truth = r.out.arguments.front().number != 0.0;
    r.out.count = r.out.arguments.front().number;
  }
}

void readLetterWord(LineReader& r) {
  Word word;
  word.letter = upperOf(*r.at.p);
  word.begin = r.at.column();
  ++r.at.p;
  r.at.skipBlanks();
  if (r.at.take('=')) r.at.skipBlanks();  // Okuma and others write X=10
  word.value_begin = r.at.column();
  if (isNumberStart(r.at)) {
    if (r.dialect == Dialect::LinuxCnc) {
      if (!readSpacedNumber(r, word))
        r.fail(code::kBadNumber,
               fmt::format("{} needs a number, found '{}'", word.letter, printable(r.at.rest(), 16)));
    } else {
      readPlainValue(r, word);
    }
    if (!r.fault.found()) r.block.words.push_back(word);
    return;
  }
  const char next = r.at.peek();
  const bool sign = next == '-' || next == '+';
  const char first = sign ? r.at.peek(1) : next;
  const bool starts_value =
      first == '[' || first == '#' || (r.dialect == Dialect::LinuxCnc && isLetter(first));
  if (!starts_value) {
    return r.fail(code::kBadNumber,
                  fmt::format("{} needs a number, found '{}'", word.letter, printable(r.at.rest(), 16)));
  }
  Expression expression(r.dialect, r.parameters, r.fault);
  const Value value = expression.value(r.at);
  word.expression = true;
  word.value = value.number;
  word.end = r.at.column();
  if (!r.fault.found() && !value.null) r.block.words.push_back(word);
}

}  // namespace

void readMacroStatement(LineReader& r) {
  while (skipToItem(r)) {
    const char c = r.at.peek();
    if (c == '#') {
      readAssignment(r);
    } else if (c == ':' && r.block.words.empty()) {
      Word word;
      word.letter = 'O';
      word.begin = r.at.column();
      ++r.at.p;
      r.at.skipBlanks();
      word.value_begin = r.at.column();
      if (!readPlainValue(r, word)) return r.fail(code::kBadNumber, "':' needs a program number");
      r.block.words.push_back(word);
    } else if (c == '/') {
      ++r.at.p;  // block skip inside a block: the rest runs, as with block skip off
    } else if (c == 'O' && r.dialect == Dialect::LinuxCnc) {
      ++r.at.p;
      readOWord(r);
    } else if (isLetter(c)) {
      if (r.dialect != Dialect::Fanuc || !readFanucKeyword(r)) readLetterWord(r);
    } else if (c == ',') {
      r.fail(code::kUnknownCode,
             fmt::format("'{}' (chamfer, corner radius or angle) is not understood and could be motion",
                         printable(r.at.rest(), 8)));
    } else {
      r.fail(code::kBadWord,
             fmt::format("'{}' starts no word; a letter and a number expected", printable(r.at.rest(), 12)));
    }
    if (r.fault.found()) return;
  }
}

void readOWord(LineReader& r) {
  Expression expression(r.dialect, r.parameters, r.fault);
  const std::uint32_t column = r.at.column() - 1;
  r.at.skipBlanks();
  if (r.at.peek() == '<') {
    r.out.label = expression.variable(r.at).name;
  } else {
    r.out.number = labelNumber(r, "O");
    r.out.label = fmt::format("{}", r.out.number);
  }
  if (r.fault.found()) return;
  const LineMark mark = markOf(fmt::format("o<x>{}", std::string(r.at.rest())), r.dialect);
  r.out.flow = mark.flow;
  r.out.flow_column = column;
  if (mark.flow == Flow::None) {
    Word word;
    word.letter = 'O';
    word.begin = column;
    word.value = static_cast<double>(r.out.number);
    word.end = r.at.column();
    r.at.skipBlanks();
    if (isLetter(r.at.peek()) && r.at.letters().size() > 1) {
      return r.fail(code::kBadFlow,
                    fmt::format("'{}' after an O word is not known", printable(r.at.rest(), 16)));
    }
    r.block.words.push_back(word);
    return;
  }
  while (!r.at.atEnd() && (isLetter(*r.at.p) || isBlank(*r.at.p))) ++r.at.p;
  readOWordValues(r, expression);
}

}  // namespace nineline::nc
