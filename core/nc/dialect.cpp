#include "core/nc/dialect.h"

#include <algorithm>
#include <string>

#include "core/base/text.h"
#include "core/nc/characters.h"
#include "core/nc/text_source.h"

namespace nineline::nc {
namespace {

constexpr std::uint64_t kLooked = std::uint64_t{64} << 10;

struct Score {
  int siemens = 0;
  int linux_cnc = 0;
  bool cycles = false;
};

bool hasAny(std::string_view line, std::initializer_list<std::string_view> texts) {
  return std::any_of(texts.begin(), texts.end(),
                     [&](std::string_view text) { return line.find(text) != std::string_view::npos; });
}

/// The line without comments and blanks, upper case. `(` is a comment unless letters stand right before it.
std::string bare(std::string_view text) {
  std::string line;
  bool comment = false;
  for (const char c : text) {
    if (c == ';') break;
    if (c == '(' && (line.empty() || !(isLetter(line.back()) || isDigit(line.back())))) comment = true;
    if (!comment && !isBlank(c)) line += upperOf(c);
    if (c == ')') comment = false;
  }
  return line;
}

/// `R1=` or `C2=`: a letter, digits, an equal sign.
bool hasIndexedAssignment(const std::string& line) {
  for (std::size_t i = line.find('='); i != std::string::npos; i = line.find('=', i + 1)) {
    std::size_t k = i;
    while (k > 0 && isDigit(line[k - 1])) --k;
    if (k < i && k > 0 && line[k - 1] == 'R' && (k == 1 || !isLetter(line[k - 2]))) return true;
  }
  return false;
}

void score(std::string_view text, Score& s) {
  const std::string line = bare(text);
  if (text.find("%_N_") != std::string_view::npos || text.find(";$PATH") != std::string_view::npos)
    s.siemens += 20;
  if (line.starts_with("%MPF") || line.starts_with("%SPF")) s.siemens += 20;
  if (hasAny(line, {"DEFREAL", "DEFINT", "CYCLE8", "CYCLE9", "MSG(", "TRAFOOF", "TRAORI", "SUPA",
                    "CR=", "=AC(", "=IC(", "=DC(", "G710", "GOTOF", "GOTOB", "TURN="}))
    s.siemens += 5;
  if (hasIndexedAssignment(line)) s.siemens += 3;
  if (hasAny(line, {"O<", "#<", "ENDSUB", "ENDIF", "ENDWHILE", "ENDREPEAT"}) && !hasAny(line, {"MSG("}))
    s.linux_cnc += 4;
  if (line.starts_with("O") && hasAny(line, {"CALL", "SUB", "IF[", "WHILE[", "REPEAT["})) s.linux_cnc += 5;
  if (hasAny(line,
             {"G33.1", "G43.1", "G10L20P", "G90.1", "G91.1", "G92.1", "G92.2", "G59.1", "G59.2", "G59.3"}))
    s.linux_cnc += 3;
}

void note(const std::string& line, DialectSigns& signs, bool& cycles) {
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const char next = line[i + 1];
    const bool value = isDigit(next) || next == '-' || next == '.' || next == '#' || next == '[';
    const bool starts = i == 0 || !isLetter(line[i - 1]);
    if ((line[i] == 'U' || line[i] == 'W') && value && starts) signs.incremental_letters = true;
    if (line[i] != 'G' || !starts) continue;
    const int code = std::atoi(line.c_str() + i + 1);
    if (code == 98 || code == 99) signs.return_codes = true;
    if (code == 91 || code == 95 || (code == 94 && line.find('X') == std::string::npos))
      signs.distance_codes = true;
    if (code >= 73 && code <= 89 && code != 80 && code != 76 && code != 75) cycles = true;
  }
}

}  // namespace

Result<DialectSigns> recogniseDialect(TextSource& source) {
  DialectSigns signs;
  Score s;
  const std::string name = upper(source.name());
  if (name.ends_with(".NGC")) s.linux_cnc += 10;
  if (name.ends_with(".MPF") || name.ends_with(".SPF") || name.ends_with(".MPF.TXT")) s.siemens += 10;
  const std::uint64_t end = std::min<std::uint64_t>(source.size(), kLooked);
  bool cycles = false;
  for (std::uint64_t offset = 0; offset < end;) {
    const Result<TextSource::Line> line = source.lineAt(offset);
    if (!line) return line.error();
    score(line->text, s);
    note(bare(line->text), signs, cycles);
    offset = line->next;
  }
  signs.return_codes = signs.return_codes && !cycles;
  if (s.siemens > s.linux_cnc && s.siemens >= 3) signs.dialect = Dialect::Siemens;
  if (s.linux_cnc > s.siemens && s.linux_cnc >= 3) signs.dialect = Dialect::LinuxCnc;
  return signs;
}

}  // namespace nineline::nc
