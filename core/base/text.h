#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace nineline {

/// A finite decimal number ("-1.5", ".5", "3.", "1e-3", leading '+') that fills the whole text; nothing else.
[[nodiscard]] std::optional<double> parseNumber(std::string_view text);

/// A whole number that fills the whole text.
[[nodiscard]] std::optional<long long> parseInteger(std::string_view text);

[[nodiscard]] std::string_view trimmed(std::string_view text);
[[nodiscard]] std::vector<std::string_view> split(std::string_view text, char separator);
[[nodiscard]] std::string upper(std::string_view text);

/// Shortest decimal that reads back to the same double.
[[nodiscard]] std::string shortest(double value);

/// `value` with a fixed number of decimals and never "-0"; empty when the value is not finite.
[[nodiscard]] std::string fixed(double value, int decimals);

/// Text for a message: control characters escaped, at most `most` characters.
[[nodiscard]] std::string printable(std::string_view text, std::size_t most = 40);

/// True when the bytes are well-formed UTF-8.
[[nodiscard]] bool isUtf8(std::string_view text);

}  // namespace nineline
