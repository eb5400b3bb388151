#pragma once

#include <string_view>

namespace nineline::nc {

/// Words and cycles of Siemens that neither move an axis nor change a frame.
[[nodiscard]] bool isPassedName(std::string_view name);
/// ROT, TRANS and their kin: alone in a block they reset, else they change the frame.
[[nodiscard]] bool isFrameName(std::string_view name);
/// CHF, RND, ANG, RP: with a value other than zero they shape the path.
[[nodiscard]] bool isCornerName(std::string_view name);

}  // namespace nineline::nc
