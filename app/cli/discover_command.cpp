#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/output_files.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/discovery/discovery.h"
#include "core/errors/error_model_file.h"
#include "core/measurement/measurement_file.h"

namespace nineline::cli {

namespace {

struct DiscoverOptions {
  std::string model;
  std::vector<std::string> files;
  std::string out;
  std::string holdout;
  std::uint64_t seed = 1;
};

Result<std::vector<double>> runsFrom(const std::string& text) {
  std::vector<double> runs;
  if (trimmed(text).empty()) return runs;
  for (const std::string_view part : split(text, ',')) {
    const std::optional<double> run = parseNumber(trimmed(part));
    if (!run) {
      return usageError("usage", fmt::format("--holdout: '{}' is no run; expected numbers as in the column "
                                             "'run', separated by commas.",
                                             printable(part)));
    }
    runs.push_back(*run);
  }
  return runs;
}

Result<std::vector<measurement::Measurement>> readFiles(const std::vector<std::string>& files,
                                                        const kinematics::Machine& machine,
                                                        Console& console) {
  std::vector<measurement::Measurement> measurements;
  for (const std::string& file : files) {
    measurement::MeasurementReading reading = measurement::loadMeasurement(file, {.machine = &machine});
    if (reading.diagnostics.hasErrors()) return console.refusal(reading.diagnostics, file);
    console.diagnostics(reading.diagnostics.all(), file);
    measurements.push_back(std::move(reading.measurement));
  }
  return measurements;
}

/// A run that nobody took cannot be held out.
Result<void> requireRuns(const std::vector<double>& runs,
                         const std::vector<measurement::Measurement>& measurements) {
  for (const double run : runs) {
    bool found = false;
    for (const measurement::Measurement& file : measurements) {
      for (const measurement::RunSpan& span : measurement::runsOf(file)) {
        found = found || span.run == run;
      }
    }
    if (!found) {
      return usageError("discover.holdout", fmt::format("--holdout: no file has a run {}.", shortest(run)));
    }
  }
  return {};
}

Result<void> runDiscover(const DiscoverOptions& options, Console& console) {
  std::vector<std::string> inputs = options.files;
  inputs.push_back(options.model);
  const std::vector<std::string> outputs{options.out};
  if (Result<void> distinct = requireDistinct(inputs, outputs); !distinct) return distinct;
  const Result<std::vector<double>> runs = runsFrom(options.holdout);
  if (!runs) return runs.error();
  const Result<errors::ErrorModel> model = errors::loadErrorModel(options.model);
  if (!model) return model.error();
  const Result<std::vector<measurement::Measurement>> measurements =
      readFiles(options.files, model->machine(), console);
  if (!measurements) return measurements.error();
  if (Result<void> known = requireRuns(*runs, *measurements); !known) return known;
  const Result<discovery::DiscoveryReport> report =
      discovery::discover(*model, *measurements, {*runs, options.seed, {}}, console);
  if (!report) return report.error();
  const std::string text = writeJson(errors::errorModelToJson(*report->model)) + "\n";
  if (Result<void> written = writeFile(options.out, text); !written) return written;
  console.result(discovery::reportToJson(*report, options.out), discovery::reportText(*report));
  return {};
}

}  // namespace

Command addDiscoverCommand(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("discover", "Find what the model lacks to explain measurements, and add it");
  auto options = std::make_shared<DiscoverOptions>();
  command->add_option("files", options->files, "Measurements")->required()->type_name("FILE");
  command->add_option("--model", options->model, "The present model")->required()->type_name("MODEL.json");
  command->add_option("--out", options->out, "The model to write")->required()->type_name("NEW.json");
  command->add_option("--holdout", options->holdout, "Runs that only judge")->type_name("RUN,RUN");
  command->add_option("--seed", options->seed, "Kept for the record; nothing is drawn")->type_name("N");
  return {command, [options](Console& console) { return runDiscover(*options, console); }};
}

}  // namespace nineline::cli
