#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/nc/nc_error.h"
#include "core/nc/siemens_expression.h"
#include "core/nc/siemens_names.h"
#include "core/nc/statement_reader.h"

namespace nineline::nc {
namespace {

constexpr std::string_view kAxisLetters = "XYZUVWABC";

bool isAddress(char letter) {
  return kAxisLetters.find(letter) != std::string_view::npos || (letter >= 'I' && letter <= 'K') ||
         std::string_view("FSMGDHTQP").find(letter) != std::string_view::npos;
}

void skipString(LineReader& r) {
  ++r.at.p;
  while (!r.at.atEnd() && *r.at.p != '"') ++r.at.p;
  if (!r.at.take('"')) r.fail(code::kBadWord, "'\"' expected at the end of the text");
}

/// The text between parentheses, which may be nested and hold strings; the opening one is taken.
std::string_view takeArguments(LineReader& r) {
  const char* const begin = r.at.p;
  int depth = 1;
  bool text = false;
  for (; !r.at.atEnd(); ++r.at.p) {
    const char c = *r.at.p;
    if (c == '"') text = !text;
    if (text) continue;
    if (c == '(') ++depth;
    if (c == ')' && --depth == 0) {
      const std::string_view inside(begin, static_cast<std::size_t>(r.at.p - begin));
      ++r.at.p;
      return inside;
    }
  }
  r.fail(code::kBadExpression, "')' expected at the end of the call");
  return {};
}

/// `AC(`, `IC(`, `DC(` before a value; the parenthesis is taken.
bool takeMode(LineReader& r, WordMode& mode) {
  struct Entry {
    std::string_view text;
    WordMode mode;
  };
  static constexpr Entry kModes[] = {
      {"AC", WordMode::Absolute}, {"IC", WordMode::Increment}, {"DC", WordMode::ShortestWay}};
  for (const Entry& entry : kModes) {
    Cursor ahead = r.at;
    if (!ahead.takeWord(entry.text) || !ahead.take('(')) continue;
    r.at = ahead;
    mode = entry.mode;
    return true;
  }
  Cursor ahead = r.at;
  if (ahead.takeWord("ACP") || ahead.takeWord("ACN"))
    r.fail(code::kUnknownCode, "ACP and ACN are not understood and could be motion");
  return false;
}

bool startsWord(Cursor at) {
  if (!isLetter(at.peek())) return false;
  const std::string letters = at.letters();
  return letters != "DIV" && letters != "MOD" && letters != "AND" && letters != "OR";
}

/// Reads the value of `word` after '='.
void readAssignedWord(LineReader& r, Word word) {
  r.at.skipBlanks();
  word.value_begin = r.at.column();
  if (r.at.peek() == '"') return skipString(r);  // T="NAME"
  const bool wrapped = takeMode(r, word.mode);
  if (r.fault.found()) return;
  Decimal number;
  const char* const end = readDecimal(r.at.p, r.at.last, number);
  Cursor behind = r.at;
  if (end) {
    behind.p = end;
    behind.skipBlanks();
  }
  // A number stands alone where no operator follows it: the words DIV, MOD, AND, OR are letters, too.
  const bool plain = end && !wrapped && (behind.atEnd() || *behind.p == ';' || startsWord(behind));
  word.expression = !plain;
  word.value = evaluateSiemens(r);
  if (wrapped && !r.fault.found() && !r.at.take(')'))
    r.fail(code::kBadExpression, "')' expected after the value");
  if (r.fault.found()) return;
  if (!word.expression) {
    word.decimal_point = number.point;
    word.decimals = number.decimals;
  }
  word.end = r.at.column();
  if (!word.expression) word.end = static_cast<std::uint32_t>(end - r.at.line);
  r.block.words.push_back(word);
}

void assignVariable(LineReader& r, Variable variable, std::uint32_t column) {
  const double value = evaluateSiemens(r);
  if (!r.fault.found()) r.out.assignments.push_back({std::move(variable), {value, false}, column});
}

/// A letter followed by a number, by `=`, by digits and `=`, or by `[ ]=`.
void readLetter(LineReader& r) {
  Word word;
  word.letter = upperOf(*r.at.p);
  word.begin = r.at.column();
  ++r.at.p;
  r.at.skipBlanks();
  word.value_begin = r.at.column();
  if (word.letter == 'R' && r.at.take('[')) {
    const double number = evaluateSiemens(r);
    if (!r.at.take(']') || !r.at.take('=')) return r.fail(code::kBadExpression, "']=' expected after R[");
    if (!(number >= 0.0 && number < 1e6))
      return r.fail(code::kBadValue, fmt::format("R[{}] does not exist", number));
    return assignVariable(r, Variable{static_cast<int>(number), {}}, word.begin);
  }
  if (r.at.take('=')) {
    if (isAddress(word.letter)) return readAssignedWord(r, word);
    return assignVariable(r, Variable{-1, std::string(1, word.letter)}, word.begin);
  }
  if (!readPlainValue(r, word)) {
    return r.fail(code::kBadNumber,
                  fmt::format("{} needs a number, found '{}'", word.letter, printable(r.at.rest(), 16)));
  }
  if (r.fault.found()) return;
  if (!r.at.take('=')) {
    r.block.words.push_back(word);
    return;
  }
  if (word.decimal_point || word.value < 0.0 || word.value > 1e6)
    return r.fail(code::kBadWord, "An index before '=' must be a whole number");
  if (word.letter == 'R') return assignVariable(r, Variable{static_cast<int>(word.value), {}}, word.begin);
  word.digit = static_cast<std::uint8_t>(std::min(word.value, 99.0));
  readAssignedWord(r, word);
}

void readDefinition(LineReader& r) {
  r.at.skipBlanks();
  const std::string type = takeName(r.at);
  if (type != "REAL" && type != "INT" && type != "BOOL") {
    r.at.p = r.at.last;  // texts, axes and frames hold no number
    return;
  }
  do {
    r.at.skipBlanks();
    const std::string name = takeName(r.at);
    if (name.empty()) return r.fail(code::kBadWord, "A name expected after DEF");
    if (r.at.take('[')) return r.fail(code::kNotConstant, "Arrays of variables are not executed");
    Assignment one{Variable{-1, name}, {}, r.at.column()};
    if (r.at.take('=')) one.value.number = evaluateSiemens(r);
    r.out.definitions.push_back(std::move(one));
  } while (!r.fault.found() && r.at.take(','));
}

void readJump(LineReader& r, char direction, bool taken) {
  r.at.skipBlanks();
  r.out.flow_column = r.at.column();
  const std::string name = takeName(r.at);
  if (name.empty()) return r.fail(code::kBadFlow, "A label expected after GOTO");
  if (!taken) return;
  r.out.flow = Flow::Goto;
  r.out.direction = direction;
  if (name[0] == 'N' && name.size() > 1 && name.size() < 10 &&
      name.find_first_not_of("0123456789", 1) == std::string::npos) {
    r.out.number = std::atol(name.c_str() + 1);
  } else {
    r.out.label = name;
  }
}

bool readGoto(LineReader& r, const std::string& name, bool taken) {
  if (name != "GOTO" && name != "GOTOF" && name != "GOTOB" && name != "GOTOC") return false;
  readJump(r, name == "GOTOF" ? '+' : name == "GOTOB" ? '-' : '\0', taken);
  return true;
}

bool readFlow(LineReader& r, const std::string& name, std::uint32_t column) {
  if (readGoto(r, name, true)) return true;
  r.out.flow_column = column;
  if (name == "IF") {
    r.out.truth = evaluateSiemens(r) != 0.0;
    r.at.skipBlanks();
    const Cursor begin = r.at;
    const std::string next = takeName(r.at);
    if (r.fault.found() || readGoto(r, next, r.out.truth)) return true;
    r.at = begin;
    r.out.flow = Flow::If;
    return true;
  }
  if (name == "ELSE") r.out.flow = Flow::Else;
  if (name == "ENDIF") r.out.flow = Flow::EndIf;
  if (name == "ENDWHILE") r.out.flow = Flow::EndWhile;
  if (name == "WHILE") {
    r.out.truth = evaluateSiemens(r) != 0.0;
    r.out.flow = Flow::While;
  }
  return r.out.flow != Flow::None;
}

/// CYCLE800: passed over where every shift and angle is zero (the reset), else it turns the workpiece's
/// frame.
bool isSwivelReset(std::string_view arguments) {
  std::size_t place = 0;
  for (const std::string_view argument : split(arguments, ',')) {
    const std::optional<double> value = parseNumber(trimmed(argument));
    const bool geometry = place >= 4 && place <= 12;
    if (geometry && !trimmed(argument).empty() && (!value || *value != 0.0)) return false;
    ++place;
  }
  return true;
}

void readCall(LineReader& r, const std::string& name, std::uint32_t column) {
  const std::string_view arguments = takeArguments(r);
  if (r.fault.found()) return;
  if (name == "CYCLE800") {
    if (!isSwivelReset(arguments))
      r.fault.set(code::kUnknownCode, column,
                  "CYCLE800 turns the frame of the workpiece, which is not understood");
    return;
  }
  if (name == "SETAL") return r.fault.set(code::kStopped, column, "The program raises an alarm (SETAL)");
  if (isPassedName(name)) return;
  if (name == "TRAORI") return r.out.keywords.push_back(Keyword::TipControlOn);
  r.fault.set(code::kUnknownCode, column, fmt::format("{}( ) is not understood and could be motion", name));
}

void readNamedValue(LineReader& r, const std::string& name, std::uint32_t column) {
  const auto address = [&](char letter) {
    Word word;
    word.letter = letter;
    word.begin = column;
    readAssignedWord(r, word);
  };
  if (name == "CR") return address('R');
  if (name == "TURN") return address('P');
  if (isPassedName(name)) {
    r.at.skipBlanks();
    if (r.at.peek() == '"') return skipString(r);
    WordMode mode{};
    const bool wrapped = takeMode(r, mode);
    static_cast<void>(evaluateSiemens(r));
    if (wrapped) r.at.take(')');
    return;
  }
  if (isCornerName(name)) {
    if (evaluateSiemens(r) == 0.0 && !r.fault.found()) return;
    return r.fault.set(code::kUnknownCode, column,
                       fmt::format("{}= is not understood and could be motion", name));
  }
  r.at.skipBlanks();
  if (r.at.peek() == '"') return skipString(r);
  assignVariable(r, Variable{-1, name}, column);
}

bool readKeyword(LineReader& r, const std::string& name, std::uint32_t column) {
  struct Entry {
    std::string_view name;
    Keyword keyword;
  };
  static constexpr Entry kKeywords[] = {
      {"SUPA", Keyword::Supa},         {"TRAORI", Keyword::TipControlOn}, {"TRAFOOF", Keyword::TipControlOff},
      {"DIAMON", Keyword::DiameterOn}, {"DIAMOF", Keyword::DiameterOff},  {"CIP", Keyword::ThreePointArc},
      {"CT", Keyword::TangentArc},     {"RET", Keyword::Return}};
  for (const Entry& entry : kKeywords) {
    if (name != entry.name) continue;
    r.out.keywords.push_back(entry.keyword);
    return true;
  }
  if (isFrameName(name)) {
    if (!skipToItem(r)) return true;  // alone in the block: the frame is reset
    r.fault.set(code::kUnknownCode, column,
                fmt::format("{} changes the frame of the workpiece, which is not understood", name));
    return true;
  }
  return isPassedName(name);
}

void readName(LineReader& r) {
  const std::uint32_t column = r.at.column();
  const std::string name = takeName(r.at);
  if (name == "DEF") return readDefinition(r);
  if (readFlow(r, name, column)) return;
  r.at.skipBlanks();
  if (r.at.peek() == ':' && r.at.peek(1) != '=') return void(++r.at.p);  // a label
  if (r.at.take('(')) return readCall(r, name, column);
  if (r.at.take('=')) return readNamedValue(r, name, column);
  if (r.at.peek() == '[') {
    r.out.passed.push_back(name + "[ ]");
    if (!isPassedName(name))
      r.fault.set(code::kNotConstant, column, fmt::format("{}[ ] is not understood", name));
    r.at.p = r.at.last;
    return;
  }
  if (name == "PROC" || name == "EXTERN" || name == "MSG") return void(r.at.p = r.at.last);
  if (readKeyword(r, name, column)) return;
  if (name == "MCALL") {
    if (!skipToItem(r)) return;
    return r.fault.set(code::kUnknownCode, column,
                       "A modal call (MCALL) is not understood and could be motion");
  }
  r.fault.set(
      code::kUnknownCode, column,
      fmt::format("'{}' is not understood and could be a subprogram with motion", printable(name, 24)));
}

bool startsName(const Cursor& at) {
  if (at.peek() == '_') return true;
  const char next = at.peek(1);
  return isLetter(at.peek()) && (isLetter(next) || next == '_');
}

}  // namespace

void readSiemensStatement(LineReader& r) {
  while (skipToItem(r)) {
    const char c = r.at.peek();
    if (c == ':' && isDigit(r.at.peek(1))) {
      ++r.at.p;
      while (!r.at.atEnd() && isDigit(*r.at.p)) ++r.at.p;
    } else if (startsName(r.at)) {
      readName(r);
    } else if (isLetter(c)) {
      readLetter(r);
    } else if (c == '$') {
      r.fail(code::kNotConstant,
             fmt::format("'{}' is a system variable of the control", printable(r.at.rest(), 16)));
    } else {
      r.fail(code::kBadWord,
             fmt::format("'{}' starts no word; a letter and a number expected", printable(r.at.rest(), 12)));
    }
    if (r.fault.found()) return;
  }
}

}  // namespace nineline::nc
