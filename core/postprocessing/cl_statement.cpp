#include "core/postprocessing/cl_statement.h"

#include <algorithm>

#include "core/base/text.h"

namespace nineline::postprocessing {

namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f'; }

/// Takes the comment off a line; true where the statement goes on in the next line.
bool cutComment(std::string_view& line) {
  const std::size_t dollar = line.find('$');
  if (dollar == std::string_view::npos) return false;
  const bool continues = dollar + 1 == line.size() || line[dollar + 1] != '$';
  line = line.substr(0, dollar);
  return continues;
}

}  // namespace

bool ClStatementReader::nextLine(std::string_view& line) {
  if (rest_.empty()) return false;
  const std::size_t end = std::min(rest_.find('\n'), rest_.size());
  line = rest_.substr(0, end);
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  ++line_;
  if (line_ == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
  return true;
}

void ClStatementReader::begin(std::string_view& line, ClStatement& statement) {
  const auto is_end = [](char c) { return isBlank(c) || c == '/' || c == ',' || c == '=' || c == '('; };
  const char* const first = std::find_if_not(line.begin(), line.end(), isBlank);
  const char* const last = std::find_if(first, line.end(), is_end);
  statement.word = upper(std::string_view(first, static_cast<std::size_t>(last - first)));
  statement.line = line_;
  statement.column = static_cast<std::size_t>(first - line.begin()) + 1;
  const char* rest = std::find_if_not(last, line.end(), isBlank);
  if (rest != line.end() && *rest == '/') ++rest;
  line.remove_prefix(static_cast<std::size_t>(rest - line.begin()));
}

void ClStatementReader::addFields(std::string_view line, std::size_t column, ClStatement& statement) {
  std::size_t at = 0;
  while (at < line.size()) {
    if (isBlank(line[at])) {
      ++at;
      continue;
    }
    if (line[at] == ',') {
      if (separated_) statement.fields.push_back({line.substr(at, 0), line_, column + at});
      separated_ = true;
      ++at;
      continue;
    }
    const std::size_t begin = at;
    while (at < line.size() && !isBlank(line[at]) && line[at] != ',') ++at;
    statement.fields.push_back({line.substr(begin, at - begin), line_, column + begin});
    separated_ = false;
  }
}

bool ClStatementReader::next(ClStatement& statement) {
  statement.word.clear();
  statement.text.clear();
  statement.fields.clear();
  separated_ = true;
  std::string_view line;
  while (nextLine(line)) {
    const char* const start = line.data();
    const bool continues = cutComment(line);
    if (statement.word.empty()) {
      if (trimmed(line).empty()) continue;
      begin(line, statement);
      if (statement.word.empty()) {  // a line that begins with a separator
        statement.word = printable(line);
        statement.column = 1;
      }
    }
    addFields(line, static_cast<std::size_t>(line.data() - start) + 1, statement);
    statement.text += trimmed(line);
    if (!continues) return true;
  }
  return !statement.word.empty();
}

}  // namespace nineline::postprocessing
