#include "core/base/diagnostics.h"

#include <algorithm>

namespace nineline {

void Diagnostics::error(std::string code, std::string text, std::size_t line, std::size_t column) {
  all_.push_back({Severity::Error, std::move(code), std::move(text), line, column, 1});
  ++errors_;
}

void Diagnostics::warning(std::string code, std::string text, std::size_t line, std::size_t column) {
  all_.push_back({Severity::Warning, std::move(code), std::move(text), line, column, 1});
}

void Diagnostics::countedWarning(const std::string& code, const std::string& text, std::size_t line) {
  for (Diagnostic& known : all_) {
    if (known.severity == Severity::Warning && known.code == code && known.text == text) {
      ++known.count;
      return;
    }
  }
  warning(code, text, line);
}

void Diagnostics::append(const Diagnostics& other) {
  all_.insert(all_.end(), other.all_.begin(), other.all_.end());
  errors_ += other.errors_;
}

Error Diagnostics::firstError(const std::string& source) const {
  const auto found = std::find_if(all_.begin(), all_.end(),
                                  [](const Diagnostic& one) { return one.severity == Severity::Error; });
  NL_EXPECTS(found != all_.end());
  return badInput(found->code, found->text, source, found->line, found->column);
}

}  // namespace nineline
