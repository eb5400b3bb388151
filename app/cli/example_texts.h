#pragma once

#include <string_view>

namespace nineline::cli {

/// The files of resources/examples, as they travel inside the program.
[[nodiscard]] std::string_view exampleModelText();
[[nodiscard]] std::string_view exampleThreadText();

}  // namespace nineline::cli
