#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/nc/characters.h"
#include "core/nc/number.h"

namespace nineline::nc {

/// A place in a line, moved by those who read it.
struct Cursor {
  const char* line;
  const char* p;
  const char* last;

  explicit Cursor(std::string_view text) : line(text.data()), p(line), last(line + text.size()) {}

  void skipBlanks() {
    while (p != last && isBlank(*p)) ++p;
  }
  [[nodiscard]] bool atEnd() const { return p == last; }
  /// The character at the cursor, upper case; 0 at the end.
  [[nodiscard]] char peek(std::ptrdiff_t ahead = 0) const {
    return last - p > ahead ? upperOf(p[ahead]) : '\0';
  }
  [[nodiscard]] std::uint32_t column() const { return static_cast<std::uint32_t>(p - line); }
  /// Skips blanks and takes the character if it stands there.
  bool take(char c) {
    skipBlanks();
    if (p == last || *p != c) return false;
    ++p;
    return true;
  }
  /// The letters from here, upper case, not taken. With `blanks`, blanks between them are passed over.
  [[nodiscard]] std::string letters() const {
    std::string word;
    for (const char* q = p; q != last && isLetter(*q); ++q) word += upperOf(*q);
    return word;
  }
  /// True when the letters from here start with `word` (upper case); takes it then.
  bool takeWord(std::string_view word) {
    const char* q = p;
    for (const char c : word) {
      if (q == last || upperOf(*q) != c) return false;
      ++q;
    }
    p = q;
    return true;
  }
  /// What stands here, for a message.
  [[nodiscard]] std::string_view rest() const { return {p, static_cast<std::size_t>(last - p)}; }
};

}  // namespace nineline::nc
