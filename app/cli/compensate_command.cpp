#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/figures_text.h"
#include "app/cli/option_values.h"
#include "app/cli/output_files.h"
#include "app/cli/program_correction.h"
#include "app/cli/setup_options.h"
#include "core/base/units.h"
#include "core/errors/error_model_file.h"

namespace nineline::cli {

namespace {

using compensation::CompensationOptions;
using compensation::Mode;

struct CompensateOptions {
  std::string model;
  std::string program;
  std::string out;
  std::string path;
  SetupOptions setup;
  std::string mode = "auto";
  std::string turning = "auto";
  std::optional<double> tolerance_um;
  std::optional<double> angle_tolerance_arcsec;
  std::optional<double> limit_um;
  std::optional<double> limit_arcsec;
  bool keep_block_count = false;
  bool no_rapids = false;
  bool first_order = false;
  std::optional<int> decimals;
  std::optional<int> rotary_decimals;
};

CompensationOptions verbOptions(const CompensateOptions& options) {
  CompensationOptions verb;
  if (options.tolerance_um) verb.tolerance = mmFromUm(*options.tolerance_um);
  if (options.angle_tolerance_arcsec) verb.angle_tolerance = radFromArcsec(*options.angle_tolerance_arcsec);
  if (options.limit_um) verb.largest_correction = mmFromUm(*options.limit_um);
  if (options.limit_arcsec) verb.largest_angle_correction = radFromArcsec(*options.limit_arcsec);
  verb.keep_block_count = options.keep_block_count;
  verb.correct_rapids = !options.no_rapids;
  verb.mode = options.mode == "tip" ? Mode::TipOnly : options.mode == "thread" ? Mode::Thread : Mode::Auto;
  if (options.turning == "alone") verb.turning = compensation::TurningFeed::Alone;
  verb.linear_decimals = options.decimals;
  verb.rotary_decimals = options.rotary_decimals;
  return verb;
}

Result<void> requireOwnFiles(const CompensateOptions& options) {
  const std::array inputs{options.model, options.program};
  std::vector<std::string> outputs{options.out};
  if (!options.path.empty()) outputs.push_back(options.path);
  return requireDistinct(inputs, outputs);
}

std::string summaryOf(const compensation::CompensationReport& report, const kinematics::Machine& machine,
                      const std::string& out) {
  return fmt::format("{}: {} of {} blocks corrected, {} lines added.\n{}", out, report.corrected,
                     report.blocks, report.inserted, figuresText(report.before, report.after, machine));
}

Result<void> runCompensate(const CompensateOptions& options, Console& console) {
  if (Result<void> own = requireOwnFiles(options); !own) return own;
  Result<errors::ErrorModel> model = errors::loadErrorModel(options.model);
  if (!model) return model.error();
  if (options.first_order) *model = model->withRotationModel(kinematics::RotationModel::FirstOrder);
  const Result<simulation::ProgramSetup> setup = setupFrom(options.setup, model->machine());
  if (!setup) return setup.error();
  Result<CorrectionFiles> files = CorrectionFiles::create(options.out, options.path);
  if (!files) return files.error();
  const Result<compensation::CompensationReport> report =
      correctProgram(*model, options.program, *setup, verbOptions(options), *files, console);
  if (!report) return report.error();
  if (report->diagnostics.hasErrors()) return console.refusal(report->diagnostics, options.program);
  if (console.isCancelled()) return cancelled();
  if (Result<void> committed = files->commit(); !committed) return committed;
  console.diagnostics(report->diagnostics.all(), options.program);
  console.result(compensation::reportToJson(*report, model->machine()),
                 summaryOf(*report, model->machine(), options.out));
  return {};
}

void addVerbOptions(CLI::App& app, CompensateOptions& options) {
  addPositive(app, "--tolerance-um", options.tolerance_um,
              "Largest deviation along a block before it is subdivided (1)");
  addPositive(app, "--angle-tolerance-arcsec", options.angle_tolerance_arcsec,
              "The same for the tool axis (3.6)");
  addPositive(app, "--limit-um", options.limit_um, "A larger correction of a linear axis is refused (1000)");
  addPositive(app, "--limit-arcsec", options.limit_arcsec, "The same for a rotary axis (3600)");
  app.add_flag("--keep-block-count", options.keep_block_count, "Never insert lines");
  app.add_flag("--no-rapids", options.no_rapids, "Leave the ends of rapid motions as programmed");
  // Only to reproduce the literature (theory.md, 1.3), so that the help leaves it out.
  app.add_flag("--first-order", options.first_order)->group("");
  app.add_option("--mode", options.mode,
                 "What is corrected: tip and tool axis as far as the axes reach, the tip only, or a thread "
                 "with X and Z alone")
      ->check(CLI::IsMember({"auto", "tip", "thread"}))
      ->type_name("auto|tip|thread");
  app.add_option(
         "--turning", options.turning,
         "Blocks that turn a rotary axis alone: linear words beside it where --dialect names a control "
         "that keeps its speed, or never")
      ->check(CLI::IsMember({"auto", "alone"}))
      ->type_name("auto|alone");
  addInteger(app, "--decimals", {0, 9}, options.decimals,
             "Digits after the point of linear words; else as in the program");
  addInteger(app, "--rotary-decimals", {0, 9}, options.rotary_decimals, "The same for rotary words");
}

}  // namespace

Command addCompensateCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("compensate", "Correct a program for the machine's errors");
  auto options = std::make_shared<CompensateOptions>();
  command->add_option("program", options->program, "The NC program")->required()->type_name("IN.nc");
  command->add_option("--model", options->model, "The error model")->required()->type_name("MODEL.json");
  command->add_option("--out", options->out, "The corrected program")->required()->type_name("OUT.nc");
  command->add_option("--path", options->path, "Also write the path of the corrected program, as simulate")
      ->type_name("PATH.csv");
  addSetupOptions(*command, options->setup);
  addVerbOptions(*command, *options);
  return {command, [options](Console& console) { return runCompensate(*options, console); }};
}

}  // namespace nineline::cli
