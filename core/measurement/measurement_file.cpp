#include "core/measurement/measurement_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/base/file.h"
#include "core/base/text.h"
#include "core/base/units.h"
#include "core/kinematics/machine_file.h"
#include "core/measurement/delimited_text.h"
#include "core/measurement/measurement_columns.h"
#include "core/measurement/measurement_head.h"

namespace nineline::measurement {

namespace {

bool isApproach(std::string_view name) { return name.starts_with("approach_") && name.ends_with("_1"); }

class Reader {
 public:
  Reader(const std::string& source, const MeasurementReadOptions& options) : options_(options) {
    out_.measurement.source = source;
  }

  MeasurementReading read(std::string_view bytes) {
    const Result<DecodedText> decoded = decodeText(bytes, out_.measurement.source);
    if (!decoded) {
      faults().error(decoded.error().code, decoded.error().text, decoded.error().line);
      return std::move(out_);
    }
    if (decoded->encoding != "UTF-8") {
      faults().warning("text.encoding",
                       fmt::format("The file is {}, not UTF-8; it was converted.", decoded->encoding));
    }
    const std::vector<TextLine> lines = linesOf(decoded->text);
    const HeadLines head = readHeadLines(lines, faults());
    if (!requireFormat(head)) return std::move(out_);
    std::size_t next = head.used;
    if (next >= lines.size()) {
      faults().error("measurement.columns", "The line of column names is missing.", lines.size());
      return std::move(out_);
    }
    separator_ = separatorOf(lines[next].text);
    const std::vector<Cell> names = cellsOf(lines[next].text, separator_);
    chooseMachine(head, names);
    fillHead(head, machine(), out_.measurement, faults());
    names_line_ = lines[next].number;
    columns_ = assignColumns(names, names_line_, machine(), out_.measurement, faults());
    for (++next; next < lines.size() && !faults().full(); ++next) readRow(lines[next]);
    finish(names.empty() ? 0 : lines[head.used].number);
    return std::move(out_);
  }

 private:
  Diagnostics& faults() { return out_.diagnostics; }
  const Machine* machine() const { return out_.machine ? &*out_.machine : nullptr; }

  bool requireFormat(const HeadLines& head) {
    if (head.entries.contains("nineline-measurement")) return true;
    faults().error(
        "measurement.format",
        "The file does not begin with '#nineline-measurement: 1'; other layouts are read by import.", 1);
    return false;
  }

  void chooseMachine(const HeadLines& head, const std::vector<Cell>& names) {
    if (options_.machine != nullptr) {
      out_.machine = *options_.machine;
      return;
    }
    const auto entry = head.entries.find("machine");
    const std::string id = entry == head.entries.end() ? "" : entry->second.value;
    if (const Machine* known = kinematics::findBuiltInMachine(id)) {
      out_.machine = *known;
      return;
    }
    const std::size_t line = id.empty() ? 1 : entry->second.line;
    const std::string what =
        id.empty() ? "'#machine:' is missing" : fmt::format("'#machine' is '{}'", printable(id));
    if (!options_.allow_stand_in) {
      faults().error("measurement.machine",
                     what + ", expected a built-in machine, or a machine or model file beside this file.",
                     line);
      return;
    }
    Result<Machine> made = standInMachine(names, id.empty() ? "unknown" : id);
    if (made) {
      out_.machine = std::move(*made);
      faults().warning("measurement.machine", what + "; the axes are those of the position columns.", line);
    } else {
      faults().error("measurement.machine", what + ", and the position columns name no axis.", line);
    }
  }

  void readRow(const TextLine& line) {
    if (isEmptyLine(line.text) || trimmed(line.text).front() == '#') return;
    std::vector<Cell> cells = cellsOf(line.text, separator_);
    while (cells.size() > columns_.size() && cells.back().text.empty()) cells.pop_back();
    if (cells.size() != columns_.size()) {
      const char* hint =
          separator_ == ',' && cells.size() > columns_.size()
              ? " Is the decimal sign a comma? The file needs a point, or ';' between the columns."
              : "";
      faults().error("measurement.row",
                     fmt::format("The row has {} cells, expected {} as in the line of column names.{}",
                                 cells.size(), columns_.size(), hint),
                     line.number);
      return;
    }
    Measurement& measurement = out_.measurement;
    Sample sample;
    sample.line = line.number;
    row_readings_.assign(measurement.channels.size(), std::nullopt);
    for (std::size_t i = 0; i < cells.size(); ++i) readCell(cells[i], columns_[i], line.number, sample);
    measurement.samples.push_back(sample);
    measurement.readings.insert(measurement.readings.end(), row_readings_.begin(), row_readings_.end());
    for (Covariate& covariate : measurement.covariates) covariate.values.resize(measurement.samples.size());
  }

  void readCell(const Cell& cell, const Column& column, std::size_t line, Sample& sample) {
    if (cell.text.empty()) {
      if (column.role == Role::Position) {
        sample.has_positions = false;
        sample.missing.set(column.index);
      }
      return;
    }
    if (column.role == Role::Ignored) {
      if (column.name.empty()) {
        faults().error("measurement.row",
                       fmt::format("'{}' stands in a column without a name.", printable(cell.text)), line,
                       cell.column);
      }
      return;
    }
    const std::optional<double> value = parseNumber(cell.text);
    if (!value) return reportNoNumber(cell, column, line);
    switch (column.role) {
      case Role::Position:
        sample.q[column.index] = column.is_rotary ? radFromDeg(*value) : *value;
        return;
      case Role::Reading:
        row_readings_[column.index] =
            out_.measurement.channels[column.index].isAngular() ? radFromArcsec(*value) : mmFromUm(*value);
        return;
      case Role::Sigma:
      case Role::AngularSigma:
        return readSigma(*value, cell, column, line, sample);
      default:
        return readCovariate(*value, cell, column, line);
    }
  }

  void readSigma(double value, const Cell& cell, const Column& column, std::size_t line, Sample& sample) {
    if (!(value > 0.0)) {
      faults().error("measurement.sigma",
                     fmt::format("{} is '{}', expected a number above 0.", column.name, printable(cell.text)),
                     line, cell.column);
    } else if (column.role == Role::Sigma) {
      sample.sigma = mmFromUm(value);
    } else {
      sample.angular_sigma = radFromArcsec(value);
    }
  }

  void readCovariate(double value, const Cell& cell, const Column& column, std::size_t line) {
    const auto refuse = [&](std::string_view expected) {
      faults().error("measurement.row",
                     fmt::format("{} is '{}', expected {}.", column.name, printable(cell.text), expected),
                     line, cell.column);
    };
    if (isApproach(column.name) && value != 1.0 && value != -1.0 && value != 0.0) return refuse("-1 or +1");
    if (column.name == "run" && value != std::floor(value)) return refuse("a whole number");
    std::vector<std::optional<double>>& values = out_.measurement.covariates[column.index].values;
    values.resize(out_.measurement.samples.size());
    values.emplace_back(value);
  }

  void reportNoNumber(const Cell& cell, const Column& column, std::size_t line) {
    const bool known = column.role != Role::Covariate || column.name == "run" || column.name == "t_s";
    if (!known) {  // a text column of somebody else is no fault; it is judged when all rows are read
      ++texts_[column.name].count;
      if (texts_[column.name].count == 1) texts_[column.name] = {1, line, cell.column, cell.text};
      return;
    }
    const bool comma = std::count(cell.text.begin(), cell.text.end(), ',') == 1 &&
                       parseNumber(std::string(cell.text).replace(cell.text.find(','), 1, ".")).has_value();
    faults().error("measurement.number",
                   fmt::format("{} is '{}', expected a number{}.", column.name, printable(cell.text),
                               comma ? " with a decimal point" : ""),
                   line, cell.column);
  }

  /// A covariate without any number is a text column and is left out; one with both is a fault.
  void judgeTextColumns() {
    for (const auto& [name, text] : texts_) {
      const Covariate& covariate = *out_.measurement.covariate(name);
      const bool has_numbers = std::any_of(covariate.values.begin(), covariate.values.end(),
                                           [](const std::optional<double>& one) { return one.has_value(); });
      if (has_numbers) {
        faults().error("measurement.number",
                       fmt::format("{} is '{}', expected a number as in the rows around it.", printable(name),
                                   printable(text.first)),
                       text.line, text.column);
      } else {
        faults().warning("measurement.columns",
                         fmt::format("The column '{}' holds text ('{}') and is left out.", printable(name),
                                     printable(text.first)),
                         names_line_);
        std::erase_if(out_.measurement.covariates, [&](const Covariate& one) { return one.column == name; });
      }
    }
  }

  void finish(std::size_t names_line) {
    judgeTextColumns();
    Measurement& measurement = out_.measurement;
    if (measurement.samples.empty() && !faults().hasErrors()) {
      faults().error("measurement.row", "No sample follows the line of column names.", names_line);
    }
    for (const Sample& sample : measurement.samples) {
      if (!sample.has_positions) {
        faults().countedWarning("measurement.position",
                                "A position is missing; nothing can be predicted for this sample.",
                                sample.line);
      } else if (machine() != nullptr && machine()->firstOutsideTravel(sample.q) >= 0) {
        const AxisId axis = machine()->joint(machine()->firstOutsideTravel(sample.q)).axis;
        faults().countedWarning("measurement.travel",
                                fmt::format("The position of axis {} lies outside its travel.", axis.text()),
                                sample.line);
      }
    }
  }

  struct TextCells {
    std::size_t count = 0;
    std::size_t line = 0;
    std::size_t column = 0;
    std::string first;
  };
  MeasurementReadOptions options_;
  MeasurementReading out_;
  char separator_ = ',';
  std::size_t names_line_ = 0;
  std::vector<Column> columns_;
  std::vector<std::optional<double>> row_readings_;
  std::map<std::string, TextCells> texts_;
};

}  // namespace

MeasurementReading readMeasurement(std::string_view bytes, const std::string& source,
                                   const MeasurementReadOptions& options) {
  return Reader(source, options).read(bytes);
}

MeasurementReading loadMeasurement(const std::filesystem::path& path, const MeasurementReadOptions& options) {
  const Result<std::string> bytes = readFile(path);
  if (bytes) return readMeasurement(*bytes, path.string(), options);
  MeasurementReading reading;
  reading.measurement.source = path.string();
  reading.diagnostics.error(bytes.error().code, bytes.error().text);
  return reading;
}

Result<Measurement> measurementOf(MeasurementReading reading) {
  if (reading.diagnostics.hasErrors()) return reading.diagnostics.firstError(reading.measurement.source);
  return std::move(reading.measurement);
}

}  // namespace nineline::measurement
