#pragma once

#include <string>

namespace nineline {

/// Passed into every verb that may run long. Called from the thread that runs the verb.
class Progress {
 public:
  virtual ~Progress() = default;
  /// `fraction` of the whole work done, 0…1. Cheap enough to be called every few thousand items.
  virtual void report(double fraction, const std::string& what) = 0;
  /// True once the user has asked to stop; the verb then returns the error `cancelled()`.
  [[nodiscard]] virtual bool isCancelled() const = 0;
};

/// Reports nothing and never cancels.
class NoProgress final : public Progress {
 public:
  void report(double, const std::string&) override {}
  [[nodiscard]] bool isCancelled() const override { return false; }
};

struct Error;
/// The error of a verb that the user stopped: kind NoAnswer, code "cancelled".
[[nodiscard]] Error cancelled();

}  // namespace nineline
