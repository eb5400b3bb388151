#pragma once

namespace nineline::cli {

/// From now on the first Ctrl-C (or SIGTERM) asks the running verb to stop; the second one ends the program
/// at once.
void catchInterrupts();
[[nodiscard]] bool isInterrupted();

}  // namespace nineline::cli
