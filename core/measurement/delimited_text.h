#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace nineline::measurement {

/// Text of a file in UTF-8 without a byte order mark, and what it was before: "UTF-8", "UTF-16", "GBK".
struct DecodedText {
  std::string text;
  std::string encoding;
};

/// Decodes the bytes of a text file: UTF-16 by its byte order mark, else UTF-8, else GBK (GB 18030). Fails
/// with BadInput on bytes that are none of them, and on a zero byte.
[[nodiscard]] Result<DecodedText> decodeText(std::string_view bytes, const std::string& source);

/// One line without its end, and its number from 1.
struct TextLine {
  std::string_view text;
  std::size_t number = 0;
};
/// LF, CRLF and CR end a line.
[[nodiscard]] std::vector<TextLine> linesOf(std::string_view text);

/// One cell of a delimited line: blanks and quotation marks taken off, and its column in the line from 1.
struct Cell {
  std::string text;
  std::size_t column = 0;
};
/// Splits a line at the separator; a quoted cell may contain it, "" is one quotation mark.
[[nodiscard]] std::vector<Cell> cellsOf(std::string_view line, char separator);

/// The separator of a line of column names: the one of tab, ';' and ',' that occurs in it, in this order of
/// preference; ',' when none does.
[[nodiscard]] char separatorOf(std::string_view line);

/// True when nothing but blanks and separators stands there.
[[nodiscard]] bool isEmptyLine(std::string_view line);

}  // namespace nineline::measurement
