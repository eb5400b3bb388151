#include "core/base/axis_id.h"

#include <cctype>

namespace nineline {

std::string AxisId::text() const {
  std::string name(1, letter);
  if (digit != 0) name += static_cast<char>('0' + digit);
  return name;
}

bool isAxisLetter(char letter) {
  return letter != '\0' && std::string_view("XYZUVWABC").find(letter) != std::string_view::npos;
}

std::optional<AxisId> parseAxisId(std::string_view text) {
  if (text.empty() || text.size() > 2) return std::nullopt;
  const char letter = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  if (!isAxisLetter(letter)) return std::nullopt;
  if (text.size() == 1) return AxisId{letter, 0};
  if (text[1] < '1' || text[1] > '9') return std::nullopt;
  return AxisId{letter, static_cast<std::uint8_t>(text[1] - '0')};
}

}  // namespace nineline
