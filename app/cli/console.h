#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostics.h"
#include "core/base/json.h"
#include "core/base/progress.h"

namespace nineline::cli {

/// What the program says: results on stdout, everything else on stderr. Also the Progress of the running
/// verb.
class Console final : public Progress {
 public:
  struct Options {
    bool json = false;
    bool quiet = false;
    int threads = 0;  ///< 0: as many as the verb wants
  };
  explicit Console(const Options& options);
  ~Console() override;
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  [[nodiscard]] bool json() const { return options_.json; }

  /// The result of the command: `record` with --json, else `summary` (unless --quiet).
  void result(const Json& record, std::string_view summary);
  /// Text that is itself the result asked for, with or without --quiet.
  void print(std::string_view text);
  /// One line for each finding: "warning: file:line:column: text".
  void diagnostics(const std::vector<Diagnostic>& findings, const std::string& source);
  /// Says all findings but the first error, which comes back to be the command's own. Requires an error among
  /// them.
  [[nodiscard]] Error refusal(const Diagnostics& findings, const std::string& source);
  /// "error: file:line:column: text"; gives the exit status.
  int error(const Error& error);
  void plainError(std::string_view text);
  /// 0, or the status of an error when stdout did not take the result.
  [[nodiscard]] int finish();

  void report(double fraction, const std::string& what) override;
  [[nodiscard]] bool isCancelled() const override;

 private:
  void clearProgress();
  Options options_;
  bool shows_progress_ = false;
  std::string shown_;
};

}  // namespace nineline::cli
