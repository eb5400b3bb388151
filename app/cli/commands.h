#pragma once

#include <functional>

#include "app/cli/console.h"
#include "core/base/result.h"

namespace CLI {
class App;
}

namespace nineline::cli {

/// One command: the place of its options, and what it does once they are parsed.
struct Command {
  const CLI::App* app = nullptr;
  std::function<Result<void>(Console&)> run;
};

[[nodiscard]] Command addMachinesCommand(CLI::App& app);
[[nodiscard]] Command addThreadCommand(CLI::App& app);
[[nodiscard]] Command addSimulateCommand(CLI::App& app);
[[nodiscard]] Command addCompensateCommand(CLI::App& app);
[[nodiscard]] Command addIdentifyCommand(CLI::App& app);
[[nodiscard]] Command addEvaluateCommand(CLI::App& app);
[[nodiscard]] Command addPredictCommand(CLI::App& app);
[[nodiscard]] Command addDiscoverCommand(CLI::App& app);
[[nodiscard]] Command addDemoCommand(CLI::App& app);
[[nodiscard]] Command addSmoothCommand(CLI::App& app);
[[nodiscard]] Command addPostCommand(CLI::App& app);

}  // namespace nineline::cli
