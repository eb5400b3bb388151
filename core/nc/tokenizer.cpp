#include "core/nc/tokenizer.h"

#include "core/nc/characters.h"
#include "core/nc/dialect.h"
#include "core/nc/number.h"

namespace nineline::nc {
namespace {

constexpr double kLargest = 1e12;  ///< no plain word is larger; what is goes to the careful reader

const char* skipBlanks(const char* p, const char* last) {
  while (p != last && isBlank(*p)) ++p;
  return p;
}

/// Letters whose word may be written `X=1.5` or `C2=12.5` without being an assignment.
constexpr bool takesEqualSign(char letter) {
  return (letter >= 'A' && letter <= 'C') || (letter >= 'U' && letter <= 'Z') || letter == 'F' ||
         letter == 'S' || letter == 'M' || (letter >= 'I' && letter <= 'K');
}

/// The value after `=`; the digits before it are the axis digit.
const char* readEqualValue(const char* p, const char* last, Word& word, Decimal& number, const char* line) {
  if (!takesEqualSign(word.letter)) return nullptr;
  p = skipBlanks(p + 1, last);
  word.value_begin = static_cast<std::uint32_t>(p - line);
  return readDecimal(p, last, number);
}

/// One word at `p`, whose first character is a letter; nullptr where it is no plain one.
const char* readWord(const char* p, const char* last, const char* line, Word& word) {
  word.letter = upperOf(*p);
  word.digit = 0;
  word.expression = false;
  word.begin = static_cast<std::uint32_t>(p - line);
  ++p;
  if (p != last && isBlank(*p)) p = skipBlanks(p, last);
  word.value_begin = static_cast<std::uint32_t>(p - line);
  Decimal number;
  const char* end = p != last && *p == '=' ? nullptr : readDecimal(p, last, number);
  if (!end) {
    if (p == last || *p != '=') return nullptr;
    end = readEqualValue(p, last, word, number, line);
  } else if (end != last && *end == '=') [[unlikely]] {
    if (number.point || !(number.value >= 0.0 && number.value < 100.0) || !isDigit(*p)) return nullptr;
    word.digit = static_cast<std::uint8_t>(number.value);
    end = readEqualValue(end, last, word, number, line);
  }
  if (!end || !(number.value <= kLargest && number.value >= -kLargest)) return nullptr;
  word.decimal_point = number.point;
  word.decimals = number.decimals;
  word.value = number.value;
  word.end = static_cast<std::uint32_t>(end - line);
  return end;
}

/// LinuxCNC: `(abort,…)` and `;py,…` are comments that act; they begin with this letter.
bool mayAct(const char* p, const char* last, char letter) {
  p = skipBlanks(p, last);
  return p != last && upperOf(*p) == letter;
}

/// After a word only a blank, a letter or a comment may follow; anything else makes it an expression.
bool endsWord(const char* p, const char* last) {
  if (p == last) return true;
  const CharacterClass next = classOf(*p);
  if (next == CharacterClass::Blank) {
    p = skipBlanks(p, last);
    return p == last || isLetter(*p) || classOf(*p) == CharacterClass::Semicolon || *p == '(';
  }
  return next == CharacterClass::Letter || next == CharacterClass::Semicolon ||
         next == CharacterClass::Parenthesis;
}

}  // namespace

bool startsWithSlash(std::string_view text) {
  for (const char c : text) {
    if (!isBlank(c)) return c == '/';
  }
  return false;
}

bool readPlainWords(Block& block, Dialect dialect) {
  block.words.clear();
  const char* const line = block.text.data();
  const char* const last = line + block.text.size();
  const char* p = line;
  if (block.line == 1 && block.text.starts_with("\xef\xbb\xbf")) p += 3;
  p = skipBlanks(p, last);
  if (p != last && *p == '/') {
    do ++p;
    while (p != last && isDigit(*p));
  }
  while (p != last) {
    switch (classOf(*p)) {
      case CharacterClass::Blank:
        ++p;
        break;
      case CharacterClass::Letter: {
        Word& word = block.words.emplace_back();
        p = readWord(p, last, line, word);
        if (!p || !endsWord(p, last)) return false;
        break;
      }
      case CharacterClass::Semicolon:
        return dialect != Dialect::LinuxCnc || !mayAct(p + 1, last, 'P');
      case CharacterClass::Parenthesis: {
        if (dialect == Dialect::Siemens || (dialect == Dialect::LinuxCnc && mayAct(p + 1, last, 'A')))
          return false;
        do ++p;
        while (p != last && *p != ')');
        if (p == last) return false;
        ++p;
        break;
      }
      case CharacterClass::Percent:
        return block.words.empty();  // a tape mark: whatever follows it on the line is a title
      default:
        return false;
    }
  }
  return true;
}

}  // namespace nineline::nc
