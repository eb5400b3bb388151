#include "core/errors/component.h"

namespace nineline::errors {

namespace {
constexpr std::string_view kRows = "XYZABC";
}

std::string Component::text() const {
  const char direction = kRows[static_cast<std::size_t>(row)];
  return location ? std::string{direction, '0'} + axis.text() : std::string{'E', direction} + axis.text();
}

std::optional<Component> parseComponent(std::string_view text) {
  if (text.size() < 3) return std::nullopt;
  bool location = text[1] == '0';
  if (text[0] == 'E' && text.size() >= 4 && text[2] == '0') {
    location = true;
    text.remove_prefix(1);
  }
  if (!location && text[0] != 'E') return std::nullopt;
  const std::size_t row = kRows.find(text[location ? 0 : 1]);
  const std::optional<AxisId> axis = parseAxisId(text.substr(2));
  if (row == std::string_view::npos || !axis) return std::nullopt;
  return Component{*axis, static_cast<int>(row), location};
}

}  // namespace nineline::errors
