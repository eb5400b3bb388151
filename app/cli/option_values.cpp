#include "app/cli/option_values.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "core/base/text.h"

namespace nineline::cli {

namespace {

template <typename Target>
void addWhole(CLI::App& app, const char* name, IntegerLimits limits, Target& target, const char* what) {
  const auto read = [name, limits, &target](const std::string& text) {
    const std::optional<long long> value = parseInteger(text);
    if (!value || *value < limits.low || *value > limits.high) {
      throw CLI::ValidationError(name, fmt::format("'{}' stands there, expected a whole number from {} to {}",
                                                   printable(text), limits.low, limits.high));
    }
    target = static_cast<int>(*value);
  };
  app.add_option_function<std::string>(name, read, what)->type_name("N");
}

}  // namespace

void addInteger(CLI::App& app, const char* name, IntegerLimits limits, int& target, const char* what) {
  addWhole(app, name, limits, target, what);
}

void addInteger(CLI::App& app, const char* name, IntegerLimits limits, std::optional<int>& target,
                const char* what) {
  addWhole(app, name, limits, target, what);
}

void addPositive(CLI::App& app, const char* name, std::optional<double>& target, const char* what) {
  const auto read = [name, &target](const std::string& text) {
    const std::optional<double> value = parseNumber(text);
    if (!value || *value <= 0.0) {
      throw CLI::ValidationError(
          name, fmt::format("'{}' stands there, expected a number above 0", printable(text)));
    }
    target = *value;
  };
  app.add_option_function<std::string>(name, read, what)->type_name("NUMBER");
}

Result<void> forEachAssignment(std::string_view option, std::string_view text,
                               const std::function<Result<void>(std::string_view, double)>& use) {
  for (const std::string_view part : split(text, ',')) {
    const std::size_t equals = part.find('=');
    const std::string_view key = trimmed(part.substr(0, equals));
    const std::optional<double> value =
        equals == std::string_view::npos ? std::nullopt : parseNumber(trimmed(part.substr(equals + 1)));
    if (key.empty() || !value) {
      return usageError("usage.assignment",
                        fmt::format("{}: '{}' stands there, expected NAME=NUMBER.", option, printable(part)));
    }
    if (Result<void> used = use(key, *value); !used) return used;
  }
  return {};
}

}  // namespace nineline::cli
