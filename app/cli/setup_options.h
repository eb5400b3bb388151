#pragma once

#include <string>
#include <vector>

#include "core/simulation/simulation.h"

namespace CLI {
class App;
}

namespace nineline::cli {

/// The options that say what the control and the shop floor know and the program does not.
struct SetupOptions {
  std::vector<std::string> states;        ///< "temp_screw_Z_C=21.5"
  std::vector<std::string> work_offsets;  ///< "G54:X=10,Z=300"
  std::vector<std::string> tool_lengths;  ///< "H1=120"
  std::vector<std::string> starts;        ///< "X=1,Z=2"
  std::string dialect;
  bool block_skip = false;
};

void addSetupOptions(CLI::App& app, SetupOptions& options);

/// The options for a machine: its axis names and units. Fails with wrong usage.
[[nodiscard]] Result<simulation::ProgramSetup> setupFrom(const SetupOptions& options,
                                                         const kinematics::Machine& machine);

}  // namespace nineline::cli
