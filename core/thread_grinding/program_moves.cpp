#include "core/thread_grinding/program_moves.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>

#include "core/base/text.h"
#include "core/thread_grinding/program_text.h"

namespace nineline::thread_grinding {
namespace {

/// Splits "G94 G01 X23.9 F300.000" at its blanks into letter and value; comments give nothing.
std::optional<std::array<std::optional<double>, 3>> readBlock(std::string_view line,
                                                              std::optional<bool>& rapid) {
  std::array<std::optional<double>, 3> axes;
  if (line.empty() || line.front() == '(' || line.front() == '%') return axes;
  for (const std::string_view word : split(line, ' ')) {
    if (word.empty()) continue;
    const std::optional<double> value = parseNumber(word.substr(1));
    if (!value && word.front() == '(') return axes;
    if (!value) return std::nullopt;
    if (word == "G00") rapid = true;
    if (word == "G01") rapid = false;
    if (word.front() == 'X') axes[0] = *value;
    if (word.front() == 'Z') axes[1] = *value;
    if (word.front() == 'C') axes[2] = *value;
  }
  return axes;
}

}  // namespace

Result<void> forEachMove(std::string_view program, const AxisConvention& axes,
                         const std::function<void(const VirtualMove&)>& use) {
  std::array<std::optional<double>, 3> at;
  std::optional<bool> rapid;
  std::size_t number = 0;
  for (const std::string_view line : split(program, '\n')) {
    ++number;
    const auto words = readBlock(line, rapid);
    if (!words) {
      return badInput("thread.program", fmt::format("'{}' is not understood.", printable(line)),
                      "thread program", number);
    }
    const bool known = at[0] && at[1] && at[2];
    const AxisWords from = known ? AxisWords{*at[0], *at[1], *at[2]} : AxisWords{};
    bool moved = false;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!(*words)[i]) continue;
      at[i] = (*words)[i];
      moved = true;
    }
    if (!known || !moved) continue;
    use({pointOf(from, axes), pointOf({*at[0], *at[1], *at[2]}, axes), rapid.value_or(true), number});
  }
  return {};
}

}  // namespace nineline::thread_grinding
