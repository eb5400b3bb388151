#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/output_files.h"
#include "core/base/file.h"
#include "core/base/units.h"
#include "core/errors/error_model_file.h"
#include "core/identification/identification.h"
#include "core/kinematics/machine_file.h"
#include "core/measurement/measurement_file.h"

namespace nineline::cli {

namespace {

using identification::IdentificationReport;
using measurement::Measurement;

struct IdentifyOptions {
  std::string machine;
  std::vector<std::string> files;
  std::string out;
  bool lateral_play = false;
  bool keep_outliers = false;
};

/// All files; the faults of one are said before its refusal.
Result<std::vector<Measurement>> loadFiles(const IdentifyOptions& options, const kinematics::Machine& machine,
                                           Console& console) {
  measurement::MeasurementReadOptions reading_options;
  reading_options.machine = &machine;
  std::vector<Measurement> files;
  for (const std::string& path : options.files) {
    measurement::MeasurementReading reading = measurement::loadMeasurement(path, reading_options);
    if (reading.diagnostics.hasErrors()) return console.refusal(reading.diagnostics, path);
    console.diagnostics(reading.diagnostics.all(), path);
    files.push_back(std::move(reading.measurement));
  }
  return files;
}

std::string largestOf(const errors::Effect& effect) {
  const bool angular = effect.component().isAngular();
  double low = 0.0;
  double high = 0.0;
  for (const double value : effect.table()->values())
    low = std::min(low, value), high = std::max(high, value);
  const double size = high - low;
  return angular ? fmt::format("range {:.3g} arcsec", arcsecFromRad(size))
                 : fmt::format("range {:.3g} um", umFromMm(size));
}

std::string lineOf(const errors::Effect& effect) {
  if (effect.table() != nullptr) {
    return fmt::format("  {:<5} table of {} values, {}\n", effect.component().text(),
                       effect.table()->values().size(), largestOf(effect));
  }
  std::string text = fmt::format("  {:<5} {}", effect.component().text(), effect.id());
  for (const errors::Parameter& parameter : effect.parameters()) {
    text += fmt::format(" {:.4g}", parameter.value);
    if (parameter.sigma) text += fmt::format(" +- {:.2g}", *parameter.sigma);
    text += " " + parameter.unit;
  }
  return text + "\n";
}

std::string summaryOf(const IdentificationReport& report, const std::string& out) {
  std::string text = fmt::format(
      "{}: {} parameters from {} readings; residual {:.3g} um, repeatability {:.3g} um, condition number "
      "{:.3g}.\n",
      out, report.parameters, report.readings, umFromMm(report.residual_rms),
      umFromMm(report.repeatability.value_or(0.0)), report.condition_number);
  for (const errors::EffectPtr& effect : report.model->effects()) text += lineOf(*effect);
  if (!report.outliers.empty()) text += fmt::format("Left out as outliers: {}\n", report.outliers.size());
  if (!report.unobservable.empty()) text += "Not told by these readings:\n";
  for (const identification::Unobservable& one : report.unobservable) text += "  " + one.text() + "\n";
  if (!report.proposals.empty()) text += "Would help most:\n";
  for (const identification::ProposedMeasurement& one : report.proposals) {
    text += "  " + one.text + " (tells " + fmt::format("{}", fmt::join(one.would_tell, ", ")) + ")\n";
  }
  return text;
}

Result<void> runIdentify(const IdentifyOptions& options, Console& console) {
  const std::array outputs{options.out};
  if (Result<void> distinct = requireDistinct(options.files, outputs); !distinct) return distinct;
  const Result<kinematics::Machine> machine = kinematics::loadMachine(options.machine);
  if (!machine) return machine.error();
  const Result<std::vector<Measurement>> files = loadFiles(options, *machine, console);
  if (!files) return files.error();
  identification::IdentificationOptions how;
  how.lateral_play = options.lateral_play;
  how.robust.enabled = !options.keep_outliers;
  const Result<IdentificationReport> report = identification::identify(*machine, *files, how, console);
  if (!report) return report.error();
  const std::string text = writeJson(errors::errorModelToJson(*report->model)) + "\n";
  if (Result<void> written = writeFile(options.out, text); !written) return written;
  console.diagnostics(report->warnings.all(), options.out);
  console.result(identification::reportToJson(*report, *files), summaryOf(*report, options.out));
  return {};
}

}  // namespace

Command addIdentifyCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("identify", "Find the errors of a machine from measurements");
  auto options = std::make_shared<IdentifyOptions>();
  command->add_option("files", options->files, "The measurements, of any instruments")
      ->required()
      ->type_name("FILE...");
  command->add_option("--machine", options->machine, "A built-in machine or a machine file")
      ->required()
      ->type_name("M");
  command->add_option("--out", options->out, "The error model to write")->required()->type_name("MODEL.json");
  command->add_flag("--lateral-play", options->lateral_play,
                    "Seek play across and about the axes too, not only along them");
  command->add_flag("--keep-outliers", options->keep_outliers, "Let every reading count fully");
  return {command, [options](Console& console) { return runIdentify(*options, console); }};
}

}  // namespace nineline::cli
