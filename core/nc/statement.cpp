#include "core/nc/statement.h"

#include <fmt/format.h>

#include "core/base/text.h"
#include "core/nc/nc_error.h"
#include "core/nc/statement_reader.h"

namespace nineline::nc {
namespace {

/// A LinuxCNC comment that acts: `(abort,…)` stops the program, `;py,` runs Python.
void checkActiveComment(LineReader& reader, std::string_view comment) {
  if (reader.dialect != Dialect::LinuxCnc) return;
  std::string start;
  for (const char c : comment.substr(0, 40)) {
    if (!isBlank(c)) start += upperOf(c);
  }
  if (start.starts_with("ABORT,"))
    reader.fail(code::kStopped, fmt::format("The program stops itself: {}", printable(trimmed(comment))));
  if (start.starts_with("PY,"))
    reader.fail(code::kNotConstant, "Python code is run by the control; it cannot be executed here");
}

bool skipComment(LineReader& reader) {
  Cursor& at = reader.at;
  const std::string_view rest = at.rest();
  const std::size_t end = rest.find(')');
  if (end == std::string_view::npos) {
    if (reader.dialect == Dialect::LinuxCnc) {
      reader.fail(code::kUnclosedComment, "The comment that begins here is not closed by ')'");
    } else {
      reader.out.passed.emplace_back("comment without ')'");
    }
    at.p = at.last;
    return false;
  }
  checkActiveComment(reader, rest.substr(1, end - 1));
  at.p += end + 1;
  return true;
}

/// The digits at the cursor as a number, −1 where none stand.
long takeInteger(Cursor& at) {
  at.skipBlanks();
  long number = -1;
  while (!at.atEnd() && isDigit(*at.p) && number < 100'000'000) {
    number = (number < 0 ? 0 : number * 10) + (*at.p - '0');
    ++at.p;
  }
  return number;
}

std::string lettersWithoutBlanks(const Cursor& at) {
  std::string word;
  for (const char* p = at.p; p != at.last && (isLetter(*p) || isBlank(*p)); ++p) {
    if (isLetter(*p)) word += upperOf(*p);
  }
  return word;
}

Flow flowOf(std::string_view keyword) {
  struct Entry {
    std::string_view text;
    Flow flow;
  };
  static constexpr Entry kEntries[] = {{"SUB", Flow::Sub},
                                       {"ENDSUB", Flow::EndSub},
                                       {"RETURN", Flow::Return},
                                       {"CALL", Flow::Call},
                                       {"IF", Flow::If},
                                       {"ELSEIF", Flow::ElseIf},
                                       {"ELSE", Flow::Else},
                                       {"ENDIF", Flow::EndIf},
                                       {"WHILE", Flow::While},
                                       {"ENDWHILE", Flow::EndWhile},
                                       {"DO", Flow::Do},
                                       {"REPEAT", Flow::Repeat},
                                       {"ENDREPEAT", Flow::EndRepeat},
                                       {"BREAK", Flow::Break},
                                       {"CONTINUE", Flow::Continue}};
  for (const Entry& entry : kEntries) {
    if (keyword == entry.text) return entry.flow;
  }
  return Flow::None;
}

}  // namespace

void Statement::clear() {
  flow = Flow::None;
  number = 0;
  label.clear();
  direction = 0;
  truth = true;
  count = 0.0;
  arguments.clear();
  assignments.clear();
  keywords.clear();
  definitions.clear();
  passed.clear();
}

bool skipToItem(LineReader& reader) {
  Cursor& at = reader.at;
  while (!reader.fault.found()) {
    at.skipBlanks();
    if (at.atEnd()) return false;
    if (*at.p == ';') {
      checkActiveComment(reader, at.rest().substr(1));
      at.p = at.last;
      return false;
    }
    if (*at.p == '(' && reader.dialect != Dialect::Siemens) {
      if (!skipComment(reader)) return false;
      continue;
    }
    return true;
  }
  return false;
}

bool readPlainValue(LineReader& reader, Word& word) {
  Cursor& at = reader.at;
  Decimal number;
  const char* end = readDecimal(at.p, at.last, number);
  if (!end) return false;
  if (!(number.value <= 1e12 && number.value >= -1e12)) {
    reader.fail(code::kBadNumber, fmt::format("{} needs a number of usual size, found '{}'", word.letter,
                                              printable({at.p, static_cast<std::size_t>(end - at.p)}, 24)));
    return true;
  }
  at.p = end;
  word.value = number.value;
  word.decimal_point = number.point;
  word.decimals = number.decimals;
  word.end = at.column();
  return true;
}

void readStatement(Block& block, Dialect dialect, const Parameters& parameters, Statement& statement,
                   Fault& fault) {
  block.words.clear();
  statement.clear();
  LineReader reader{block, dialect, parameters, statement, fault, Cursor(block.text)};
  if (block.line == 1 && block.text.starts_with("\xef\xbb\xbf")) reader.at.p += 3;
  if (!skipToItem(reader)) return;
  if (*reader.at.p == '%') return;  // a tape mark: whatever follows is a title
  if (reader.at.take('/')) takeInteger(reader.at);
  if (dialect == Dialect::Siemens) {
    readSiemensStatement(reader);
  } else {
    readMacroStatement(reader);
  }
}

bool mayBeMark(std::string_view text) {
  for (const char c : text) {
    if (isBlank(c)) continue;
    const char first = upperOf(c);
    return !(first == 'G' || first == 'X' || first == 'Y' || first == 'Z' || first == 'M') ||
           text.find(':') != std::string_view::npos;
  }
  return false;
}

LineMark markOf(std::string_view text, Dialect dialect) {
  LineMark mark;
  Cursor at(text);
  if (text.starts_with("\xef\xbb\xbf")) at.p += 3;
  at.skipBlanks();
  if (at.take('%')) at.skipBlanks();
  if (at.take('/')) takeInteger(at);
  at.skipBlanks();
  if (at.peek() == 'N') {
    ++at.p;
    mark.block_number = takeInteger(at);
    at.skipBlanks();
  }
  if (dialect == Dialect::Siemens) {
    const char* const begin = at.p;
    while (!at.atEnd() && (isLetter(*at.p) || isDigit(*at.p) || *at.p == '_')) ++at.p;
    const std::string name = upper({begin, static_cast<std::size_t>(at.p - begin)});
    if (at.take(':')) {
      mark.block_label = name;
    } else {
      mark.flow = flowOf(name);
      const bool jumps = mark.flow == Flow::If && upper(at.rest()).find("GOTO") != std::string::npos;
      if (jumps) mark.flow = Flow::None;
    }
    return mark;
  }
  const char first = at.peek();
  if (first == 'O' || first == ':') {
    ++at.p;
    at.skipBlanks();
    mark.is_o_word = true;
    if (at.take('<')) {
      while (!at.atEnd() && *at.p != '>') {
        if (!isBlank(*at.p)) mark.label += static_cast<char>(isLetter(*at.p) ? *at.p | 32 : *at.p);
        ++at.p;
      }
      at.take('>');
    } else {
      mark.number = takeInteger(at);
      mark.label = fmt::format("{}", mark.number);
    }
    if (dialect == Dialect::LinuxCnc) mark.flow = flowOf(lettersWithoutBlanks(at));
    return mark;
  }
  if (dialect != Dialect::Fanuc || (first != 'W' && first != 'E' && first != 'D')) return mark;
  if (at.takeWord("END")) {
    mark.number = takeInteger(at);
    mark.flow = mark.number >= 0 ? Flow::End : Flow::None;
  } else if (at.takeWord("WHILE") || at.takeWord("DO")) {
    const std::string rest = upper(at.rest());
    const std::size_t place = rest.rfind("DO");
    Cursor behind(place == std::string::npos ? std::string_view(rest)
                                             : std::string_view(rest).substr(place + 2));
    mark.number = takeInteger(behind);
    mark.flow = mark.number >= 0 ? Flow::WhileDo : Flow::None;
  }
  return mark;
}

}  // namespace nineline::nc
