#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/figures_text.h"
#include "app/cli/output_files.h"
#include "app/cli/path_file.h"
#include "app/cli/setup_options.h"
#include "core/errors/error_model_file.h"

namespace nineline::cli {

namespace {

struct SimulateOptions {
  std::string model;
  std::string program;
  std::string out;
  SetupOptions setup;
};

Result<void> runSimulate(const SimulateOptions& options, Console& console) {
  const std::array inputs{options.model, options.program};
  const std::array outputs{options.out};
  if (Result<void> distinct = requireDistinct(inputs, outputs); !distinct) return distinct;
  const Result<errors::ErrorModel> model = errors::loadErrorModel(options.model);
  if (!model) return model.error();
  const Result<simulation::ProgramSetup> setup = setupFrom(options.setup, model->machine());
  if (!setup) return setup.error();
  const Result<std::unique_ptr<nc::TextSource>> program = nc::openTextFile(options.program);
  if (!program) return program.error();
  Result<AtomicFile> file = AtomicFile::create(options.out);
  if (!file) return file.error();
  const Result<simulation::SimulationReport> report =
      simulateToFile(*model, **program, *setup, *file, console);
  if (!report) return report.error();
  if (report->diagnostics.hasErrors()) return console.refusal(report->diagnostics, options.program);
  if (Result<void> committed = file->commit(); !committed) return committed;
  console.diagnostics(report->diagnostics.all(), options.program);
  console.result(simulationToJson(*report, model->machine()),
                 fmt::format("{}: {} samples of {} blocks.\n{}", options.out, report->samples, report->blocks,
                             figuresText(report->deviation, model->machine())));
  return {};
}

}  // namespace

Command addSimulateCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("simulate", "Write the ideal and the actual tool path of a program");
  auto options = std::make_shared<SimulateOptions>();
  command->add_option("program", options->program, "The NC program")->required()->type_name("IN.nc");
  command->add_option("--model", options->model, "The error model")->required()->type_name("MODEL.json");
  command->add_option("--out", options->out, "The path to write")->required()->type_name("PATH.csv");
  addSetupOptions(*command, options->setup);
  return {command, [options](Console& console) { return runSimulate(*options, console); }};
}

}  // namespace nineline::cli
