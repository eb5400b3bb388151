#pragma once

#include <filesystem>
#include <string>

#include "core/nc/interpreter.h"

namespace nineline::campaign {

/// What LinuxCNC's `rs274` makes of a program: its canonical calls, and why it stopped.
struct Rs274 {
  std::string calls;
  std::string fault;  ///< empty: read to its end
};

/// Runs `rs274` in a folder; `tools`: text of the tool table.
[[nodiscard]] Rs274 runRs274(const std::filesystem::path& folder, const std::string& program,
                             const std::string& tools);

/// The tool table beside a program, or one of thirty tools without length.
[[nodiscard]] std::string toolTableBeside(const std::filesystem::path& file);

/// Empty where our interpreter moves as rs274 does; else our refusal or the first difference.
[[nodiscard]] std::string motionDifference(const std::string& text, const Rs274& theirs,
                                           nc::InterpreterOptions options);

/// Text that fits into a cell of a table.
[[nodiscard]] std::string withoutBars(std::string text);

}  // namespace nineline::campaign
