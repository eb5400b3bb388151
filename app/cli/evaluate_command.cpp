#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/cli/commands.h"
#include "core/kinematics/machine_file.h"
#include "core/measurement/evaluation_record.h"
#include "core/measurement/measurement_file.h"

namespace nineline::cli {

namespace {

using measurement::EvaluationInput;
using measurement::MeasurementReading;

struct EvaluateOptions {
  std::vector<std::string> files;
  std::string machine;
};

/// Reads every file; the faults of one that cannot be used are said, and it ends there.
Result<std::vector<MeasurementReading>> readAll(const EvaluateOptions& options,
                                                const kinematics::Machine* machine, Console& console) {
  measurement::MeasurementReadOptions reading_options;
  reading_options.machine = machine;
  reading_options.allow_stand_in = true;
  std::vector<MeasurementReading> readings;
  for (const std::string& file : options.files) {
    MeasurementReading reading = measurement::loadMeasurement(file, reading_options);
    if (reading.diagnostics.hasErrors()) return console.refusal(reading.diagnostics, file);
    NL_EXPECTS(reading.machine.has_value());
    console.diagnostics(reading.diagnostics.all(), file);
    readings.push_back(std::move(reading));
  }
  return readings;
}

Result<void> runEvaluate(const EvaluateOptions& options, Console& console) {
  std::optional<kinematics::Machine> machine;
  if (!options.machine.empty()) {
    Result<kinematics::Machine> loaded = kinematics::loadMachine(options.machine);
    if (!loaded) return loaded.error();
    machine = *std::move(loaded);
  }
  const Result<std::vector<MeasurementReading>> readings =
      readAll(options, machine ? &*machine : nullptr, console);
  if (!readings) return readings.error();
  std::vector<EvaluationInput> inputs;
  for (const MeasurementReading& reading : *readings)
    inputs.push_back({&reading.measurement, &*reading.machine});
  const Result<std::vector<measurement::Evaluation>> evaluations = measurement::evaluateMeasurements(inputs);
  if (!evaluations) return evaluations.error();
  std::string text;
  for (const measurement::Evaluation& evaluation : *evaluations) {
    console.diagnostics(evaluation.warnings.all(), evaluation.sources.front());
    text += measurement::evaluationText(evaluation);
  }
  console.result(measurement::evaluationsToJson(*evaluations), text);
  return {};
}

}  // namespace

Command addEvaluateCommand(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("evaluate", "Give the figures of ISO 230-2, ISO 230-4 and VDI 3441 of measurements");
  auto options = std::make_shared<EvaluateOptions>();
  command->add_option("files", options->files, "The measurements")->required()->type_name("FILE...");
  command->add_option("--machine", options->machine, "The machine, in place of the one that the files name")
      ->type_name("M");
  return {command, [options](Console& console) { return runEvaluate(*options, console); }};
}

}  // namespace nineline::cli
