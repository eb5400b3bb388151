#pragma once

namespace nineline::cli {

/// Parses the arguments and runs the command that they name. Gives the exit status: 0 done, 2 wrong usage,
/// else the kind of the error.
[[nodiscard]] int runCommandLine(int argc, const char* const* argv);

}  // namespace nineline::cli
