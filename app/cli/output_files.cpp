#include "app/cli/output_files.h"

#include <fmt/format.h>

#include <filesystem>

namespace nineline::cli {

namespace {

namespace fs = std::filesystem;

bool isSame(const std::string& one, const std::string& other) {
  std::error_code fault;
  if (fs::equivalent(one, other, fault)) return true;
  return fs::weakly_canonical(one, fault) == fs::weakly_canonical(other, fault);
}

}  // namespace

Result<void> requireDistinct(std::span<const std::string> inputs, std::span<const std::string> outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (const std::string& input : inputs) {
      if (!isSame(input, outputs[i])) continue;
      return usageError("usage.overwrite",
                        fmt::format("'{}' is both read and written; name another output file.", input));
    }
    for (const std::string& other : outputs.subspan(0, i)) {
      if (!isSame(other, outputs[i])) continue;
      return usageError("usage.overwrite",
                        fmt::format("'{}' is the output file of two options; name another one.", other));
    }
  }
  return {};
}

}  // namespace nineline::cli
