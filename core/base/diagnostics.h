#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"

namespace nineline {

enum class Severity { Warning, Error };

/// One finding of a reader: what stood there, what was expected, and where. `count` is above 1 when the same
/// finding occurred again (the place is that of the first).
struct Diagnostic {
  Severity severity = Severity::Error;
  std::string code;
  std::string text;
  std::size_t line = 0;    ///< from 1; 0 = no place
  std::size_t column = 0;  ///< from 1; 0 = whole line
  std::size_t count = 1;
};

/// Collects findings; a reader goes on after each fault and stops when `full()`.
class Diagnostics {
 public:
  static constexpr std::size_t kMostErrors = 200;

  void error(std::string code, std::string text, std::size_t line = 0, std::size_t column = 0);
  void warning(std::string code, std::string text, std::size_t line = 0, std::size_t column = 0);
  /// A warning that is kept once per code and text, and counted.
  void countedWarning(const std::string& code, const std::string& text, std::size_t line = 0);
  void append(const Diagnostics& other);

  [[nodiscard]] const std::vector<Diagnostic>& all() const { return all_; }
  [[nodiscard]] bool hasErrors() const { return errors_ != 0; }
  [[nodiscard]] bool full() const { return errors_ >= kMostErrors; }
  /// The first error as an Error of kind BadInput. Requires hasErrors().
  [[nodiscard]] Error firstError(const std::string& source) const;

 private:
  std::vector<Diagnostic> all_;
  std::size_t errors_ = 0;
};

}  // namespace nineline
