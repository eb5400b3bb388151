#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/base/result.h"
#include "core/nc/dialect.h"
#include "core/nc/motion.h"

namespace nineline::nc {

class TextSource;

/// How a program writes its numbers.
struct NumberStyle {
  int linear_decimals = 3;      ///< most digits after the point in words of linear axes
  int rotary_decimals = 3;      ///< the same for rotary axes
  bool keep_point = true;       ///< whole numbers end in a point: `X10.`
  bool trailing_zeros = false;  ///< every number has all its decimals: `X10.000`
  bool inch = false;            ///< the program sets inches somewhere (G20, G70)
};

/// Learns the style from the plain axis words of the first `most_bytes` of a program. Without any decimal
/// point in the program, numbers keep none.
[[nodiscard]] Result<NumberStyle> learnNumberStyle(TextSource& source, Dialect dialect,
                                                   const AxisLayout& axes,
                                                   std::uint64_t most_bytes = std::uint64_t{1} << 20);

inline constexpr std::size_t kLongestNumber = 32;
inline constexpr int kMostDecimals = 9;

/// `value` as a decimal with at most `decimals` digits after the point (0…9), never "-0" and never an
/// exponent. Returns the characters written, 0 where the value is not finite or beyond 10^9.
[[nodiscard]] std::size_t formatNumber(double value, int decimals, const NumberStyle& style,
                                       std::span<char, kLongestNumber> out);

/// The number that a reader finds in what formatNumber wrote, bit for bit.
[[nodiscard]] double writtenValue(double value, int decimals);

}  // namespace nineline::nc
