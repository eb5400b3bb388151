#pragma once

#include <span>
#include <string>

#include "core/base/result.h"

namespace nineline::cli {

/// Fails with wrong usage when an output would replace an input or another output. Existing files are
/// compared by what they are, not by how they are written.
[[nodiscard]] Result<void> requireDistinct(std::span<const std::string> inputs,
                                           std::span<const std::string> outputs);

}  // namespace nineline::cli
