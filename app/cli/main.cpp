#include <cstdio>
#include <exception>

#include "app/cli/command_line.h"

int main(int argc, char** argv) {
  try {
    return nineline::cli::runCommandLine(argc, argv);
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "error: a mistake of nineline-cli itself, please report it: %s\n", fault.what());
  }
  return 70;  // EX_SOFTWARE: none of the statuses that the user can cause
}
