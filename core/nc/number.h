#pragma once

#include <array>
#include <charconv>
#include <cstdint>

namespace nineline::nc {

/// A decimal number as NC programs write it: sign, digits, point, digits; never an exponent.
struct Decimal {
  double value = 0.0;
  bool point = false;
  std::uint8_t decimals = 0;
};

namespace detail {
inline constexpr std::array<double, 23> kPowersOfTen{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                     1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                     1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
/// Reads again what has more digits than a double holds exactly.
double readLongDecimal(const char* first, const char* last);
}  // namespace detail

/// Reads the decimal at `first`; the end of it, or nullptr where no digit stands. The value is the double
/// nearest to the decimal: the digits are gathered in an integer and divided once by an exact power of ten.
inline const char* readDecimal(const char* first, const char* last, Decimal& out) {
  const char* p = first;
  const bool negative = p != last && *p == '-';
  if (p != last && (*p == '-' || *p == '+')) ++p;
  std::uint64_t mantissa = 0;
  const char* const digits = p;
  unsigned digit = 0;
  while (p != last && (digit = static_cast<unsigned>(*p) - '0') <= 9U) mantissa = mantissa * 10 + digit, ++p;
  auto count = p - digits;
  out.point = p != last && *p == '.';
  std::ptrdiff_t decimals = 0;
  if (out.point) {
    const char* const fraction = ++p;
    while (p != last && (digit = static_cast<unsigned>(*p) - '0') <= 9U)
      mantissa = mantissa * 10 + digit, ++p;
    decimals = p - fraction;
    count += decimals;
  }
  if (count == 0) return nullptr;
  out.decimals = static_cast<std::uint8_t>(decimals < 255 ? decimals : 255);
  if (count <= 15) [[likely]] {
    const double size = static_cast<double>(static_cast<std::int64_t>(mantissa)) /
                        detail::kPowersOfTen[static_cast<std::size_t>(decimals)];
    out.value = negative ? -size : size;
  } else {
    const double size = detail::readLongDecimal(digits, p);
    out.value = negative ? -size : size;
  }
  return p;
}

}  // namespace nineline::nc
