#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <iterator>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/option_values.h"
#include "app/cli/output_files.h"
#include "app/cli/setup_options.h"
#include "core/base/file.h"
#include "core/base/units.h"
#include "core/kinematics/machine_file.h"
#include "core/smoothing/smoothing.h"

namespace nineline::cli {

namespace {

using kinematics::Machine;
using smoothing::SmoothingOptions;

struct SmoothOptions {
  std::string machine;
  std::string program;
  std::string out;
  std::string path;
  std::optional<double> tolerance_um;
  std::optional<double> angle_tolerance_deg;
  std::optional<double> chord_um;
  std::optional<double> corner_deg;
  std::string criterion = "points";
  std::string format = "g01";
  std::optional<int> decimals;
  std::optional<int> rotary_decimals;
  SetupOptions setup;
};

smoothing::Format formatNamed(const std::string& name) {
  if (name == "fanuc-nurbs") return smoothing::Format::FanucNurbs;
  if (name == "siemens-bspline") return smoothing::Format::SiemensBspline;
  if (name == "siemens-poly") return smoothing::Format::SiemensPoly;
  return smoothing::Format::G01;
}

SmoothingOptions verbOptions(const SmoothOptions& options) {
  SmoothingOptions verb;
  verb.tolerance = mmFromUm(*options.tolerance_um);
  if (options.angle_tolerance_deg) verb.turn_tolerance = radFromDeg(*options.angle_tolerance_deg);
  if (options.chord_um) verb.chord = mmFromUm(*options.chord_um);
  if (options.corner_deg) verb.corner = radFromDeg(*options.corner_deg);
  if (options.criterion == "polyline") verb.criterion = smoothing::Criterion::Polyline;
  verb.format = formatNamed(options.format);
  verb.linear_decimals = options.decimals;
  verb.rotary_decimals = options.rotary_decimals;
  return verb;
}

std::string pathHead(const Machine& machine) {
  std::string head = "segment_1,smooth_1";
  for (const kinematics::Joint& joint : machine.joints())
    head +=
        fmt::format(",{}_{}", joint.axis.text(), joint.type == kinematics::JointType::Rotary ? "deg" : "mm");
  return head + ",x_mm,y_mm,z_mm\n";
}

void appendRow(const Machine& machine, const smoothing::CurveSample& sample, std::string& rows) {
  auto to = std::back_inserter(rows);
  fmt::format_to(to, "{},{}", sample.segment, sample.smoothed ? 1 : 0);
  for (int i = 0; i < machine.jointCount(); ++i) {
    const double value = sample.values[static_cast<std::size_t>(i)];
    fmt::format_to(to, ",{:.9f}", machine.isRotary(i) ? degFromRad(value) : value);
  }
  fmt::format_to(to, ",{:.9f},{:.9f},{:.9f}\n", sample.tip.x(), sample.tip.y(), sample.tip.z());
}

/// The path first: the program counts.
Result<void> writeOutputs(const SmoothOptions& options, const std::string& text, const std::string& rows) {
  if (!options.path.empty()) {
    if (Result<void> written = writeFile(options.path, rows); !written) return written;
  }
  return writeFile(options.out, text);
}

std::string summaryOf(const std::string& out, const smoothing::SmoothingReport& report) {
  return fmt::format(
      "{}: {} points in, {} out, {} smooth segments of {} control points.\n"
      "Position: {:.3f} um at the points, {:.3f} um proven; orientation: {:.5f} deg at the points.\n",
      out, report.points_in, report.points_out, report.segments, report.control_points,
      umFromMm(report.max_position_error), umFromMm(report.bound), degFromRad(report.max_turn_error));
}

Result<void> runSmooth(const SmoothOptions& options, Console& console) {
  const std::array inputs{options.machine, options.program};
  std::vector<std::string> outputs{options.out};
  if (!options.path.empty()) outputs.push_back(options.path);
  if (Result<void> distinct = requireDistinct(inputs, outputs); !distinct) return distinct;
  const Result<Machine> machine = kinematics::loadMachine(options.machine);
  if (!machine) return machine.error();
  const Result<simulation::ProgramSetup> setup = setupFrom(options.setup, *machine);
  if (!setup) return setup.error();
  Result<std::string> program = readFile(options.program);
  if (!program) return program.error();
  std::string rows = pathHead(*machine);
  smoothing::CurveSink sink;
  if (!options.path.empty())
    sink = [&](const smoothing::CurveSample& sample) { appendRow(*machine, sample, rows); };
  const Result<smoothing::SmoothedText> smoothed = smoothing::smoothText(
      *machine, options.program, std::move(*program), simulation::interpreterOptionsOf(*machine, *setup),
      verbOptions(options), console, sink);
  if (!smoothed) return smoothed.error();
  const smoothing::SmoothingReport& report = smoothed->report;
  if (report.diagnostics.hasErrors()) return console.refusal(report.diagnostics, options.program);
  if (Result<void> written = writeOutputs(options, smoothed->text, rows); !written) return written;
  console.diagnostics(report.diagnostics.all(), options.program);
  console.result(smoothing::reportToJson(report), summaryOf(options.out, report));
  return {};
}

void addVerbOptions(CLI::App& app, SmoothOptions& options) {
  addPositive(app, "--tolerance-um", options.tolerance_um, "Largest deviation of the path, writing included");
  app.get_option("--tolerance-um")->required();
  addPositive(app, "--angle-tolerance-deg", options.angle_tolerance_deg,
              "Largest deviation of the rotary axes together (0.05)");
  addPositive(app, "--chord-um", options.chord_um,
              "Chord error of the CAM system; else estimated from the points");
  addPositive(app, "--corner-deg", options.corner_deg, "A sharper turn of the path stays a corner (20)");
  app.add_option("--criterion", options.criterion,
                 "What the tolerance refers to: the programmed points, or the lines between them")
      ->check(CLI::IsMember({"points", "polyline"}))
      ->type_name("points|polyline");
  app.add_option("--format", options.format, "How the smooth path is written")
      ->check(CLI::IsMember({"g01", "fanuc-nurbs", "siemens-bspline", "siemens-poly"}))
      ->type_name("g01|fanuc-nurbs|siemens-bspline|siemens-poly");
  addInteger(app, "--decimals", {0, 9}, options.decimals,
             "Digits after the point of linear words; else as in the program, at least 4");
  addInteger(app, "--rotary-decimals", {0, 9}, options.rotary_decimals,
             "The same for rotary words, at least 5");
}

}  // namespace

Command addSmoothCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("smooth", "Replace short straight blocks by a smooth path");
  auto options = std::make_shared<SmoothOptions>();
  command->add_option("program", options->program, "The NC program")->required()->type_name("IN.nc");
  command->add_option("--machine", options->machine, "A built-in machine or a machine file")
      ->required()
      ->type_name("M");
  command->add_option("--out", options->out, "The smoothed program")->required()->type_name("OUT.nc");
  command->add_option("--path", options->path, "Also write the curves at the programmed points")
      ->type_name("PATH.csv");
  addVerbOptions(*command, *options);
  addSetupOptions(*command, options->setup);
  return {command, [options](Console& console) { return runSmooth(*options, console); }};
}

}  // namespace nineline::cli
