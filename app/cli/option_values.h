#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace CLI {
class App;
}

namespace nineline::cli {

/// Limits of a value, both ends allowed.
struct IntegerLimits {
  int low = 0;
  int high = 0;
};

/// An option with a whole number; anything else, or a number beyond the limits, is wrong usage.
void addInteger(CLI::App& app, const char* name, IntegerLimits limits, int& target, const char* what);
void addInteger(CLI::App& app, const char* name, IntegerLimits limits, std::optional<int>& target,
                const char* what);
/// An option with a finite number above 0.
void addPositive(CLI::App& app, const char* name, std::optional<double>& target, const char* what);

/// Reads "KEY=VALUE,KEY=VALUE". Fails with wrong usage, naming the option, on what is no such list or no
/// finite number.
[[nodiscard]] Result<void> forEachAssignment(
    std::string_view option, std::string_view text,
    const std::function<Result<void>(std::string_view key, double value)>& use);

}  // namespace nineline::cli
