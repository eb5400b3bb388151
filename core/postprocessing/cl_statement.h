#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace nineline::postprocessing {

/// One value behind the slash of a statement, with its place in the file (from 1).
struct ClField {
  std::string_view text;
  std::size_t line = 0;
  std::size_t column = 0;
};

/// One APT statement, its continuation lines included.
struct ClStatement {
  std::string word;             ///< major word in upper case
  std::vector<ClField> fields;  ///< between commas and blanks
  std::string text;             ///< everything behind the major word, blanks at the ends taken off
  std::size_t line = 0;
  std::size_t column = 0;
};

/// Splits APT text into statements: `$` continues on the next line, `$$` begins a comment, empty lines are
/// passed over. The fields view the text given.
class ClStatementReader {
 public:
  explicit ClStatementReader(std::string_view text) : rest_(text) {}
  /// The next statement; false at the end of the text.
  [[nodiscard]] bool next(ClStatement& statement);

 private:
  bool nextLine(std::string_view& line);
  void begin(std::string_view& line, ClStatement& statement);
  void addFields(std::string_view line, std::size_t column, ClStatement& statement);
  std::string_view rest_;
  std::size_t line_ = 0;
  bool separated_ = true;  // a comma stood before the place where the next field would begin
};

}  // namespace nineline::postprocessing
