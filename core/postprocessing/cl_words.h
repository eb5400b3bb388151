#pragma once

#include <string_view>

namespace nineline::postprocessing {

/// Statements that say nothing about how the machine runs: passed over without a word.
[[nodiscard]] bool isSilentClWord(std::string_view word);
/// Statements that move the tool or change where later ones move it, and that are not understood here.
[[nodiscard]] bool mayMoveTool(std::string_view word);

}  // namespace nineline::postprocessing
