#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/option_values.h"
#include "app/cli/output_files.h"
#include "app/cli/post_model.h"
#include "app/cli/setup_options.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/base/units.h"
#include "core/errors/error_model_file.h"
#include "core/kinematics/machine_file.h"
#include "core/postprocessing/cl_reader.h"
#include "core/postprocessing/post_processor.h"

namespace nineline::cli {

namespace {

using postprocessing::Control;
using postprocessing::FeedWriting;
using postprocessing::PostReport;

struct PostCommandOptions {
  std::string machine;
  std::string model;
  std::string cl_file;
  std::string out;
  std::string axes;
  std::string control = "fanuc";
  std::string feed = "per-minute";
  bool tip_control = false;
  std::vector<std::string> held;
  std::vector<std::string> states;
  std::optional<double> chord_um;
  std::optional<double> axis_tolerance_deg;
  std::optional<double> axis_deviation_deg;
  std::optional<int> decimals;
  std::optional<int> rotary_decimals;
};

Result<void> takeHeld(const PostCommandOptions& options, const kinematics::Machine& machine,
                      std::map<std::string, double>& held) {
  const auto take = [&](std::string_view key, double value) -> Result<void> {
    const std::optional<AxisId> axis = parseAxisId(key);
    const int joint = axis ? machine.find(*axis) : -1;
    if (joint < 0)
      return usageError(
          "usage", fmt::format("--hold names '{}', which is no axis of '{}'.", printable(key), machine.id()));
    held[axis->text()] = machine.isRotary(joint) ? radFromDeg(value) : value;
    return {};
  };
  for (const std::string& text : options.held) {
    if (Result<void> taken = forEachAssignment("--hold", text, take); !taken) return taken;
  }
  return {};
}

Result<postprocessing::PostOptions> verbOptions(const PostCommandOptions& options,
                                                const kinematics::Machine& machine) {
  static const std::map<std::string, Control> kControls = {{"fanuc", Control::Fanuc},
                                                           {"siemens", Control::Siemens},
                                                           {"linuxcnc", Control::LinuxCnc},
                                                           {"heidenhain", Control::Heidenhain}};
  postprocessing::PostOptions verb;
  verb.nc.control = kControls.at(options.control);
  verb.nc.feed = options.feed == "inverse-time" ? FeedWriting::InverseTime : FeedWriting::PerMinute;
  verb.nc.tip_control = options.tip_control;
  verb.nc.linear_decimals = options.decimals.value_or(verb.nc.linear_decimals);
  verb.nc.rotary_decimals = options.rotary_decimals.value_or(verb.nc.rotary_decimals);
  if (options.chord_um) verb.moves.chord_tolerance = mmFromUm(*options.chord_um);
  if (options.axis_tolerance_deg) verb.plan.axis_tolerance = radFromDeg(*options.axis_tolerance_deg);
  if (options.axis_deviation_deg) verb.moves.axis_deviation = radFromDeg(*options.axis_deviation_deg);
  if (Result<void> held = takeHeld(options, machine, verb.held); !held) return held.error();
  return verb;
}

/// The machine, and with --model the correction for its errors.
Result<kinematics::Machine> takeMachine(const PostCommandOptions& options,
                                        postprocessing::AxisCorrection& correction) {
  if (options.model.empty()) return kinematics::loadMachine(options.machine);
  const Result<errors::ErrorModel> model = errors::loadErrorModel(options.model);
  if (!model) return model.error();
  SetupOptions setup;
  setup.states = options.states;
  const Result<simulation::ProgramSetup> conditions = setupFrom(setup, model->machine());
  if (!conditions) return conditions.error();
  Result<postprocessing::AxisCorrection> made = axisCorrection(*model, conditions->state);
  if (!made) return made.error();
  correction = std::move(*made);
  return model->machine();
}

Result<postprocessing::ClProgram> readProgram(const std::string& path, double arc_tolerance,
                                              Console& console) {
  const Result<std::string> text = readFile(path);
  if (!text) return text.error();
  postprocessing::ClOptions options;
  options.arc_tolerance = arc_tolerance;
  Diagnostics faults;
  Result<postprocessing::ClProgram> program = postprocessing::readClData(*text, path, options, &faults);
  if (!program && faults.hasErrors()) return console.refusal(faults, path);
  return program;
}

/// Both files, or none of them.
Result<void> writeFiles(const PostCommandOptions& options, const std::string& program,
                        const std::string& axes) {
  Result<AtomicFile> nc = AtomicFile::create(options.out);
  if (!nc) return nc.error();
  if (Result<void> written = nc->write(program); !written) return written;
  if (options.axes.empty()) return nc->commit();
  Result<AtomicFile> table = AtomicFile::create(options.axes);
  if (!table) return table.error();
  if (Result<void> written = table->write(axes); !written) return written;
  if (Result<void> flushed = nc->flush(); !flushed) return flushed;
  if (Result<void> committed = table->commit(); !committed) return committed;
  return nc->commit();
}

std::string summaryOf(const PostReport& report, const std::string& out) {
  return fmt::format(
      "{}: {} points, {} blocks ({} inserted), cutting time about {:.0f} s.\n"
      "Residual {:.1e} mm and {:.1e}°, {:.2f} iterations a point; chord error {:.2f} um.\n"
      "{} changes of branch, {} points near a singular pose.\n",
      out, report.points, report.blocks, report.inserted_points, report.cutting_time, report.max_residual,
      degFromRad(report.max_axis_residual), report.solver_iterations_mean, umFromMm(report.max_chord_error),
      report.branch_switches, report.singular_points);
}

Result<void> runPost(const PostCommandOptions& options, Console& console) {
  const std::vector<std::string> inputs{options.cl_file,
                                        options.model.empty() ? options.machine : options.model};
  std::vector<std::string> outputs{options.out};
  if (!options.axes.empty()) outputs.push_back(options.axes);
  if (Result<void> distinct = requireDistinct(inputs, outputs); !distinct) return distinct;
  postprocessing::AxisCorrection correction;
  const Result<kinematics::Machine> machine = takeMachine(options, correction);
  if (!machine) return machine.error();
  Result<postprocessing::PostOptions> verb = verbOptions(options, *machine);
  if (!verb) return verb.error();
  verb->correction = std::move(correction);
  const Result<postprocessing::ClProgram> program =
      readProgram(options.cl_file, 0.5 * verb->moves.chord_tolerance, console);
  if (!program) return program.error();
  const Result<postprocessing::PostResult> result =
      postprocessing::postProcess(*machine, *program, *verb, console);
  if (!result) {
    Error error = result.error();
    if (error.line != 0) error.source = options.cl_file;
    return error;
  }
  if (console.isCancelled()) return cancelled();
  const std::string axes =
      options.axes.empty() ? "" : postprocessing::axesCsv(*machine, *program, result->moves);
  if (Result<void> written = writeFiles(options, result->text, axes); !written) return written;
  console.diagnostics(result->report.warnings.all(), options.cl_file);
  console.result(postprocessing::postReportJson(result->report), summaryOf(result->report, options.out));
  return {};
}

void addVerbOptions(CLI::App& app, PostCommandOptions& options) {
  app.add_option("--control", options.control, "The control that the program is for (fanuc)")
      ->check(CLI::IsMember({"fanuc", "siemens", "linuxcnc", "heidenhain"}))
      ->type_name("fanuc|siemens|linuxcnc|heidenhain");
  app.add_option("--feed", options.feed, "How feeds are written: G94 or G93 (per-minute)")
      ->check(CLI::IsMember({"per-minute", "inverse-time"}))
      ->type_name("per-minute|inverse-time");
  app.add_flag("--tcp", options.tip_control, "Tool-centre-point control: G43.4, TRAORI, M128");
  app.add_option("--hold", options.held, "Axes that stand still, for machines with more axes than needed")
      ->type_name("C2=0");
  addPositive(app, "--chord-um", options.chord_um,
              "How far the tip may leave the line between two points (5)");
  addPositive(app, "--axis-deviation-deg", options.axis_deviation_deg, "The same for the tool axis (0.1)");
  addPositive(app, "--axis-tolerance-deg", options.axis_tolerance_deg,
              "How far the tool axis may be let off to calm turns near singular poses (not at all)");
  addInteger(app, "--decimals", {0, 9}, options.decimals, "Digits after the point of linear words (4)");
  addInteger(app, "--rotary-decimals", {0, 9}, options.rotary_decimals, "The same for rotary words (5)");
}

}  // namespace

Command addPostCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("post", "Turn cutter location data into an NC program");
  auto options = std::make_shared<PostCommandOptions>();
  command->add_option("cl_file", options->cl_file, "APT/CLDATA text, or a table of tip and axis")
      ->required()
      ->type_name("IN.cls");
  command->add_option("--machine", options->machine, "The machine: an id or a file")->type_name("M");
  CLI::Option* model =
      command->add_option("--model", options->model, "Correct the axes for this error model at once")
          ->type_name("MODEL.json");
  command->add_option("--state", options->states, "Conditions of the model")
      ->type_name("KEY=VALUE")
      ->needs(model);
  command->add_option("--out", options->out, "The NC program to write")->required()->type_name("OUT.nc");
  command->add_option("--axes", options->axes, "Also write the axis positions of each block, unrounded")
      ->type_name("AXES.csv");
  addVerbOptions(*command, *options);
  return {command, [options](Console& console) -> Result<void> {
            if (options->machine.empty() && options->model.empty())
              return usageError("usage", "--machine is required.");
            return runPost(*options, console);
          }};
}

}  // namespace nineline::cli
