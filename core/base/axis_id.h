#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace nineline {

/// Most joints that a machine may have.
inline constexpr int kMaxAxes = 9;

/// The name of a joint as a control shows it: a letter of X Y Z U V W A B C, and a digit 1…9 where it
/// repeats.
struct AxisId {
  char letter = '?';
  std::uint8_t digit = 0;  ///< 0: no digit

  friend bool operator==(const AxisId&, const AxisId&) = default;
  [[nodiscard]] std::string text() const;
};

/// "X", "C2", "c2" → an AxisId; nothing for any other text.
[[nodiscard]] std::optional<AxisId> parseAxisId(std::string_view text);

/// True for the nine letters that may name a joint (upper case).
[[nodiscard]] bool isAxisLetter(char letter);

}  // namespace nineline
