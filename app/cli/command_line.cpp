#include "app/cli/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>

#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/interrupt.h"
#include "app/cli/option_values.h"
#include "core/base/text.h"

namespace nineline::cli {

namespace {

void addCommonOptions(CLI::App& app, Console::Options& options) {
  app.add_flag("--json", options.json, "Print the result record as one JSON object, nothing else");
  app.add_flag("--quiet", options.quiet, "Print no progress and no summary");
  addInteger(app, "--threads", {1, 1024}, options.threads, "Use at most N threads");
  app.set_version_flag("--version", "nineline-cli " NINELINE_VERSION);
}

/// The command that was being parsed; the program itself before any.
const CLI::App& chosenCommand(const CLI::App& app) {
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->parsed()) return *command;
  }
  return app;
}

/// What was asked for is shown (--help), what was wrong is said with the usage of the command in question. A
/// word that nobody knows is named before what is missing without it.
int reportParse(const CLI::App& app, const CLI::ParseError& fault, Console& console) {
  if (fault.get_exit_code() == 0) return app.exit(fault);
  const CLI::App& which = chosenCommand(app);
  const std::vector<std::string> unknown = app.remaining(true);
  const bool is_missing = fault.get_exit_code() == static_cast<int>(CLI::ExitCodes::RequiredError);
  if (is_missing && !unknown.empty()) {
    const char* what = &which == &app ? "command" : "argument";
    console.error(usageError(
        "usage", fmt::format("'{}' is no {} that is known here.", printable(unknown.front()), what)));
  } else {
    console.error(usageError("usage", fault.what()));
  }
  console.plainError(which.help(&which == &app ? "" : "nineline-cli"));
  return static_cast<int>(ErrorKind::Usage);
}

}  // namespace

int runCommandLine(int argc, const char* const* argv) {
  CLI::App app("Corrects NC programs for the measured errors of the machine that runs them.", "nineline-cli");
  Console::Options options;
  addCommonOptions(app, options);
  app.require_subcommand(1);
  const std::array commands{addMachinesCommand(app),   addThreadCommand(app),   addSimulateCommand(app),
                            addCompensateCommand(app), addIdentifyCommand(app), addEvaluateCommand(app),
                            addPredictCommand(app),    addDiscoverCommand(app), addDemoCommand(app),
                            addSmoothCommand(app),     addPostCommand(app)};
  for (CLI::App* command : app.get_subcommands({})) {
    command->fallthrough();
    command->footer("Common options: --json  --quiet  --threads N");
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& fault) {
    Console console(options);
    return reportParse(app, fault, console);
  }
  Console console(options);
  catchInterrupts();
  for (const Command& command : commands) {
    if (!command.app->parsed()) continue;
    const Result<void> done = command.run(console);
    if (!done) return console.error(done.error());
    return console.finish();
  }
  return static_cast<int>(ErrorKind::Usage);
}

}  // namespace nineline::cli
