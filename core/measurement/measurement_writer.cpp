#include <fmt/format.h>

#include <algorithm>

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/measurement/measurement_file.h"

namespace nineline::measurement {

namespace {

std::string number(double value) { return fmt::format("{:.12g}", value == 0.0 ? 0.0 : value); }

std::string number(const std::optional<double>& value) { return value ? number(*value) : ""; }

std::string point(const Eigen::Vector3d& p) {
  return fmt::format("{} {} {}", number(p.x()), number(p.y()), number(p.z()));
}

void writeSetUp(const Instrument& instrument, std::string& out) {
  const auto line = [&out](std::string_view key, const std::string& value) {
    out += fmt::format("#{}: {}\n", key, value);
  };
  const auto bedAxis = [](int index) { return std::string(1, static_cast<char>('X' + index)); };
  if (instrument.axis) line("axis", instrument.axis->text());
  switch (instrument.kind) {
    case InstrumentKind::LaserLinear:
      return line("point_mm", point(instrument.point));
    case InstrumentKind::LaserStraightness:
    case InstrumentKind::Dial:
      line("point_mm", point(instrument.point));
      return line("sensitive", bedAxis(instrument.sensitive));
    case InstrumentKind::LaserAngular:
      return line("about", bedAxis(instrument.about));
    case InstrumentKind::Ballbar:
      line("centre_mm", point(instrument.centre));
      line("radius_mm", number(instrument.radius));
      if (!instrument.plane.empty()) line("plane", instrument.plane);
      return;
    case InstrumentKind::Lead:
      line("pitch_mm", number(instrument.pitch));
      line("starts", fmt::format("{}", instrument.starts));
      return line("hand", instrument.left_hand ? "left" : "right");
    case InstrumentKind::Deviation:
    case InstrumentKind::Joint:
      return;
  }
}

/// One column of the samples: its name and the text of each cell.
struct WrittenColumn {
  std::string name;
  std::vector<std::string> cells;
};

template <typename Value>
void addColumn(std::vector<WrittenColumn>& columns, std::string name, std::size_t count, const Value& value) {
  WrittenColumn column{std::move(name), {}};
  column.cells.reserve(count);
  for (std::size_t i = 0; i < count; ++i) column.cells.push_back(number(value(i)));
  columns.push_back(std::move(column));
}

void addSigma(const Measurement& measurement, const char* name, std::optional<double> Sample::*sigma,
              double (*shown)(double), std::vector<WrittenColumn>& columns) {
  bool any = false;
  for (const Sample& sample : measurement.samples) any = any || (sample.*sigma).has_value();
  if (!any) return;
  addColumn(columns, name, measurement.samples.size(), [&](std::size_t i) -> std::optional<double> {
    const std::optional<double>& value = measurement.samples[i].*sigma;
    return value ? std::optional(shown(*value)) : std::nullopt;
  });
}

/// Place of a column in the file that the measurement came from; behind all others where it has none.
std::ptrdiff_t placeOf(const Measurement& measurement, const std::string& name) {
  return std::find(measurement.columns.begin(), measurement.columns.end(), name) -
         measurement.columns.begin();
}

std::vector<WrittenColumn> columnsOf(const Measurement& measurement, const Machine& machine,
                                     const std::vector<ExtraColumn>& more) {
  std::vector<WrittenColumn> columns;
  const std::size_t count = measurement.samples.size();
  const auto addCovariate = [&](const Covariate& one) {
    addColumn(columns, one.column, count, [&](std::size_t i) { return one.values[i]; });
  };
  const auto isFirst = [](const Covariate& one) { return one.column == "run" || one.column == "t_s"; };
  for (const Covariate& one : measurement.covariates) {
    if (isFirst(one)) addCovariate(one);
  }
  for (int j = 0; j < machine.jointCount(); ++j) {
    const auto k = static_cast<std::size_t>(j);
    if (k >= measurement.commanded.size() || !measurement.commanded[k]) continue;
    const bool rotary = machine.isRotary(j);
    addColumn(columns, machine.joint(j).axis.text() + (rotary ? "_deg" : "_mm"), count,
              [&](std::size_t i) -> std::optional<double> {
                const Sample& sample = measurement.samples[i];
                if (sample.missing[k]) return std::nullopt;
                return rotary ? degFromRad(sample.q[k]) : sample.q[k];
              });
  }
  for (const Covariate& one : measurement.covariates) {
    if (!isFirst(one)) addCovariate(one);
  }
  for (std::size_t k = 0; k < measurement.channels.size(); ++k) {
    const Channel& channel = measurement.channels[k];
    addColumn(columns, channel.column(), count, [&](std::size_t i) -> std::optional<double> {
      const std::optional<double>& value = measurement.reading(i, k);
      return value ? std::optional(shownReading(channel, *value)) : std::nullopt;
    });
  }
  addSigma(measurement, "sigma_um", &Sample::sigma, umFromMm, columns);
  addSigma(measurement, "sigma_arcsec", &Sample::angular_sigma, arcsecFromRad, columns);
  std::stable_sort(columns.begin(), columns.end(), [&](const WrittenColumn& one, const WrittenColumn& other) {
    return placeOf(measurement, one.name) < placeOf(measurement, other.name);
  });
  for (const ExtraColumn& one : more) {
    addColumn(columns, one.name, count, [&](std::size_t i) { return one.values[i]; });
  }
  return columns;
}

}  // namespace

double shownReading(const Channel& channel, double value) {
  return channel.isAngular() ? arcsecFromRad(value) : umFromMm(value);
}

std::string writeSamples(const Measurement& measurement, const Machine& machine,
                         const std::vector<ExtraColumn>& more) {
  const std::vector<WrittenColumn> columns = columnsOf(measurement, machine, more);
  std::string out;
  for (std::size_t c = 0; c < columns.size(); ++c) out += (c > 0 ? "," : "") + columns[c].name;
  out += '\n';
  for (std::size_t i = 0; i < measurement.samples.size(); ++i) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (c > 0) out += ',';
      out += columns[c].cells[i];
    }
    out += '\n';
  }
  return out;
}

std::string writeMeasurement(const Measurement& measurement, const Machine& machine) {
  std::string out = "#nineline-measurement: 1\n";
  const std::string& id = measurement.machine_id.empty() ? machine.id() : measurement.machine_id;
  out += fmt::format("#machine: {}\n#instrument: {}\n", id, nameOf(measurement.instrument.kind));
  writeSetUp(measurement.instrument, out);
  if (measurement.repeatability) {
    out += fmt::format("#repeatability_um: {}\n", number(umFromMm(*measurement.repeatability)));
  }
  if (measurement.angular_repeatability) {
    out +=
        fmt::format("#repeatability_arcsec: {}\n", number(arcsecFromRad(*measurement.angular_repeatability)));
  }
  for (const auto& [key, value] : measurement.other_head) out += fmt::format("#{}: {}\n", key, value);
  return out + writeSamples(measurement, machine);
}

}  // namespace nineline::measurement
