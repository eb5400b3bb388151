#include <CLI/CLI.hpp>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/worked_example.h"

namespace nineline::cli {

Command addDemoCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("demo", "Work the example through, start to finish, into a folder");
  auto folder = std::make_shared<std::string>();
  command->add_option("--out", *folder, "The folder; made where it is missing")->required()->type_name("DIR");
  const auto run = [folder](Console& console) -> Result<void> {
    const Result<WorkedExample> example = writeWorkedExample(*folder, console);
    if (!example) return example.error();
    console.result(example->record, example->summary + "Everything lies in " + *folder + ".\n");
    return {};
  };
  return {command, run};
}

}  // namespace nineline::cli
