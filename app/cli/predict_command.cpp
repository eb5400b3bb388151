#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/output_files.h"
#include "core/base/file.h"
#include "core/base/units.h"
#include "core/errors/error_model_file.h"
#include "core/measurement/measurement_file.h"
#include "core/measurement/prediction.h"
#include "core/measurement/run_checks.h"

namespace nineline::cli {

namespace {

using measurement::Channel;
using measurement::Measurement;
using measurement::Prediction;

struct PredictOptions {
  std::string model;
  std::string measurement;
  std::string out;
};

/// Without the digits that rounding errors leave.
double rounded(double shown) { return std::round(shown * 1e9) * 1e-9; }

/// Prediction and residual of one channel, one value for each sample; empty where nothing can be said.
std::array<measurement::ExtraColumn, 2> columnsOf(const Measurement& measurement,
                                                  const Prediction& prediction, std::size_t channel) {
  const Channel& what = measurement.channels[channel];
  std::array<measurement::ExtraColumn, 2> columns{
      {{"pred_" + what.column(), {}}, {"residual_" + what.column(), {}}}};
  for (measurement::ExtraColumn& column : columns) column.values.resize(measurement.samples.size());
  for (std::size_t i = 0; i < prediction.rows.size(); ++i) {
    const measurement::ReadingRow& row = prediction.rows[i];
    if (row.channel != channel || prediction.is_complete[i] == 0) continue;
    columns[0].values[row.sample] = rounded(measurement::shownReading(what, prediction.shown(i)));
    if (row.value)
      columns[1].values[row.sample] =
          rounded(measurement::shownReading(what, *row.value - prediction.shown(i)));
  }
  return columns;
}

/// Figures of one channel's residuals, in the unit of its column.
struct ChannelFigures {
  std::size_t readings = 0;
  double rms = 0.0;
  double largest = 0.0;
  double rms_before = 0.0;  // of the readings themselves, their mean taken off where the file has a zero
};

ChannelFigures figuresOf(const Measurement& measurement, const Prediction& prediction, std::size_t channel) {
  ChannelFigures figures;
  const Channel& what = measurement.channels[channel];
  double sum = 0.0;
  double squares = 0.0;
  double residual_squares = 0.0;
  for (std::size_t i = 0; i < prediction.rows.size(); ++i) {
    const measurement::ReadingRow& row = prediction.rows[i];
    if (row.channel != channel || !row.value || prediction.is_complete[i] == 0) continue;
    const double reading = measurement::shownReading(what, *row.value);
    const double residual = reading - measurement::shownReading(what, prediction.shown(i));
    ++figures.readings;
    sum += reading;
    squares += reading * reading;
    residual_squares += residual * residual;
    figures.largest = std::max(figures.largest, std::abs(residual));
  }
  if (figures.readings == 0) return figures;
  const auto count = static_cast<double>(figures.readings);
  const double mean = measurement.instrument.hasZero() ? sum / count : 0.0;
  figures.rms = std::sqrt(residual_squares / count);
  figures.rms_before = std::sqrt(std::max(0.0, squares / count - mean * mean));
  return figures;
}

Json recordOf(const Measurement& measurement, const Prediction& prediction,
              const std::vector<measurement::RunFault>& faults) {
  Json channels = Json::array();
  for (std::size_t k = 0; k < measurement.channels.size(); ++k) {
    const ChannelFigures figures = figuresOf(measurement, prediction, k);
    const Channel& what = measurement.channels[k];
    const std::string unit = what.isAngular() ? "arcsec" : "um";
    Json channel = Json::object();
    channel.set("column", what.column()).set("readings", figures.readings);
    if (measurement.instrument.hasZero()) {
      const std::optional<double>& zero = prediction.zeros[k];
      channel.set("zero_" + unit, zero ? Json(measurement::shownReading(what, *zero)) : Json());
    }
    if (figures.readings > 0) {
      channel.set("rms_reading_" + unit, figures.rms_before);
      channel.set("rms_residual_" + unit, figures.rms);
      channel.set("max_residual_" + unit, figures.largest);
    }
    channels.push(std::move(channel));
  }
  Json warnings = Json::array();
  for (const Diagnostic& one : prediction.warnings.all()) warnings.push(one.text);
  Json quality = Json::array();
  for (const measurement::RunFault& fault : faults) {
    Json entry = Json::object();
    entry.set("text", fault.text).set("remedy", fault.remedy).set("file", measurement.source);
    entry.set("rows", Json(Json::Array{Json(fault.first_row), Json(fault.last_row)}));
    quality.push(std::move(entry));
  }
  Json record = Json::object();
  record.set("instrument", measurement::nameOf(measurement.instrument.kind))
      .set("samples", measurement.samples.size())
      .set("channels", std::move(channels))
      .set("data_quality", std::move(quality))
      .set("warnings", std::move(warnings));
  return record;
}

std::string summaryOf(const Measurement& measurement, const Prediction& prediction, const std::string& out) {
  std::string text = fmt::format("{}: {} samples.\n", out, measurement.samples.size());
  for (std::size_t k = 0; k < measurement.channels.size(); ++k) {
    const ChannelFigures figures = figuresOf(measurement, prediction, k);
    const Channel& what = measurement.channels[k];
    text += figures.readings == 0
                ? fmt::format("{}: no readings\n", what.column())
                : fmt::format("{}: {} readings, rms {:.4g}, residual rms {:.4g}, largest {:.4g} {}\n",
                              what.column(), figures.readings, figures.rms_before, figures.rms,
                              figures.largest, what.isAngular() ? "arcsec" : "um");
  }
  return text;
}

/// Mistakes noticed in runs, as warnings with the line of their first sample.
std::vector<Diagnostic> findingsOf(const Measurement& measurement,
                                   const std::vector<measurement::RunFault>& faults) {
  Diagnostics findings;
  for (const measurement::RunFault& fault : faults) {
    findings.warning(fault.code, fault.text + " " + fault.remedy,
                     measurement.samples[fault.first_row - 1].line);
  }
  return findings.all();
}

Result<void> runPredict(const PredictOptions& options, Console& console) {
  const std::array inputs{options.model, options.measurement};
  const std::array outputs{options.out};
  if (Result<void> distinct = requireDistinct(inputs, outputs); !distinct) return distinct;
  const Result<errors::ErrorModel> model = errors::loadErrorModel(options.model);
  if (!model) return model.error();
  measurement::MeasurementReadOptions reading_options;
  reading_options.machine = &model->machine();
  const measurement::MeasurementReading reading =
      measurement::loadMeasurement(options.measurement, reading_options);
  if (reading.diagnostics.hasErrors()) return console.refusal(reading.diagnostics, options.measurement);
  const Measurement& measured = reading.measurement;
  const Result<Prediction> prediction = measurement::predict(*model, measured);
  if (!prediction) return prediction.error();
  std::vector<measurement::ExtraColumn> more;
  for (std::size_t k = 0; k < measured.channels.size(); ++k) {
    for (measurement::ExtraColumn& column : columnsOf(measured, *prediction, k))
      more.push_back(std::move(column));
  }
  const std::string text = measurement::writeSamples(measured, model->machine(), more);
  if (Result<void> written = writeFile(options.out, text); !written) return written;
  console.diagnostics(reading.diagnostics.all(), options.measurement);
  console.diagnostics(prediction->warnings.all(), options.measurement);
  const std::vector<measurement::RunFault> faults =
      measurement::checkRuns(measured, model->machine(), &*prediction);
  console.diagnostics(findingsOf(measured, faults), options.measurement);
  console.result(recordOf(measured, *prediction, faults), summaryOf(measured, *prediction, options.out));
  return {};
}

}  // namespace

Command addPredictCommand(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("predict", "Say what the instrument of a measurement should have read");
  auto options = std::make_shared<PredictOptions>();
  command->add_option("measurement", options->measurement, "The measurement")->required()->type_name("FILE");
  command->add_option("--model", options->model, "The error model")->required()->type_name("MODEL.json");
  command->add_option("--out", options->out, "The samples with prediction and residual")
      ->required()
      ->type_name("PRED.csv");
  return {command, [options](Console& console) { return runPredict(*options, console); }};
}

}  // namespace nineline::cli
