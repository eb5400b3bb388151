#include "core/measurement/delimited_text.h"

#include <fmt/format.h>
#include <iconv.h>

#include <algorithm>
#include <optional>

#include "core/base/text.h"

namespace nineline::measurement {

namespace {

constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";
constexpr std::string_view kUtf16LittleMark = "\xFF\xFE";
constexpr std::string_view kUtf16BigMark = "\xFE\xFF";

/// The bytes in UTF-8; nothing where they do not belong to the encoding.
std::optional<std::string> convert(std::string_view bytes, const char* encoding) {
  const iconv_t converter = iconv_open("UTF-8", encoding);
  if (converter == reinterpret_cast<iconv_t>(-1)) return std::nullopt;
  std::string input(bytes);
  std::string output(4 * bytes.size() + 16, '\0');
  char* from = input.data();
  char* to = output.data();
  std::size_t from_left = input.size();
  std::size_t to_left = output.size();
  const std::size_t done = iconv(converter, &from, &from_left, &to, &to_left);
  iconv_close(converter);
  if (done == static_cast<std::size_t>(-1) || from_left != 0) return std::nullopt;
  output.resize(output.size() - to_left);
  return output;
}

std::size_t lineOf(std::string_view text, std::size_t position) {
  return 1 + static_cast<std::size_t>(
                 std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(position), '\n'));
}

}  // namespace

Result<DecodedText> decodeText(std::string_view bytes, const std::string& source) {
  const auto refused = [&](std::size_t line) {
    return badInput("text.encoding", "The bytes are no text in UTF-8, UTF-16 or GBK; save the file as UTF-8.",
                    source, line);
  };
  for (const auto& [mark, encoding] :
       {std::pair{kUtf16LittleMark, "UTF-16LE"}, {kUtf16BigMark, "UTF-16BE"}}) {
    if (!bytes.starts_with(mark)) continue;
    std::optional<std::string> text = convert(bytes.substr(mark.size()), encoding);
    if (!text) return refused(0);
    return DecodedText{std::move(*text), "UTF-16"};
  }
  if (bytes.starts_with(kUtf8Mark)) bytes.remove_prefix(kUtf8Mark.size());
  if (const std::size_t zero = bytes.find('\0'); zero != std::string_view::npos) {
    return refused(lineOf(bytes, zero));
  }
  if (isUtf8(bytes)) return DecodedText{std::string(bytes), "UTF-8"};
  std::optional<std::string> text = convert(bytes, "GB18030");
  if (!text) return refused(0);
  return DecodedText{std::move(*text), "GBK"};
}

std::vector<TextLine> linesOf(std::string_view text) {
  std::vector<TextLine> lines;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    lines.push_back({text.substr(begin, end - begin), lines.size() + 1});
    begin = end + 1;
    if (end + 1 < text.size() && text[end] == '\r' && text[end + 1] == '\n') ++begin;
  }
  return lines;
}

std::vector<Cell> cellsOf(std::string_view line, char separator) {
  std::vector<Cell> cells;
  std::size_t begin = 0;
  for (;;) {
    bool quoted = false;
    std::size_t end = begin;
    while (end < line.size() && (quoted || line[end] != separator)) quoted ^= line[end++] == '"';
    const std::string_view raw = line.substr(begin, end - begin);
    std::string_view bare = trimmed(raw);
    const std::size_t place = bare.empty() ? begin : static_cast<std::size_t>(bare.data() - line.data());
    std::string text(bare);
    if (bare.size() >= 2 && bare.front() == '"' && bare.back() == '"') {
      text.clear();
      bare = bare.substr(1, bare.size() - 2);
      for (std::size_t i = 0; i < bare.size(); ++i) {
        text += bare[i];
        if (bare[i] == '"' && i + 1 < bare.size() && bare[i + 1] == '"') ++i;
      }
      text = std::string(trimmed(text));
    }
    cells.push_back({std::move(text), place + 1});
    if (end >= line.size()) return cells;
    begin = end + 1;
  }
}

char separatorOf(std::string_view line) {
  for (const char separator : {'\t', ';', ','}) {
    if (line.find(separator) != std::string_view::npos) return separator;
  }
  return ',';
}

bool isEmptyLine(std::string_view line) {
  return line.find_first_not_of(" \t;,\"") == std::string_view::npos;
}

}  // namespace nineline::measurement
