#include "core/base/result.h"

#include <fmt/format.h>

namespace nineline {

std::string Error::message() const {
  std::string place = source;
  if (line != 0) place += (place.empty() ? "line " : ":") + std::to_string(line);
  if (line != 0 && column != 0) place += ":" + std::to_string(column);
  return place.empty() ? text : fmt::format("{}: {}", place, text);
}

Error usageError(std::string code, std::string text) {
  return {ErrorKind::Usage, std::move(code), std::move(text), {}, 0, 0};
}

Error badInput(std::string code, std::string text, std::string source, std::size_t line, std::size_t column) {
  return {ErrorKind::BadInput, std::move(code), std::move(text), std::move(source), line, column};
}

Error noAnswer(std::string code, std::string text, std::string source, std::size_t line) {
  return {ErrorKind::NoAnswer, std::move(code), std::move(text), std::move(source), line, 0};
}

}  // namespace nineline
