#include "core/measurement/column_mapping.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/measurement/delimited_text.h"
#include "core/measurement/table_units.h"

namespace nineline::measurement {

namespace {

bool needsUnit(const MappedColumn& column) {
  return column.meaning == Meaning::Position || column.meaning == Meaning::Reading ||
         column.meaning == Meaning::Actual || column.meaning == Meaning::Sigma;
}

std::vector<Choice> choicesOf(const std::vector<std::string>& units) {
  std::vector<Choice> choices;
  for (const std::string& unit : units) choices.push_back({unit, unit});
  return choices;
}

/// The joint that a position or actual column belongs to; −1 where it is not known.
int jointOf(const MappedColumn& column, const Instrument& instrument, const Machine& machine) {
  const std::optional<AxisId>& axis = column.meaning == Meaning::Actual ? instrument.axis : column.axis;
  return axis ? machine.find(*axis) : -1;
}

bool isAngular(const MappedColumn& column, const Instrument& instrument, const Machine& machine) {
  if (column.meaning == Meaning::Reading) return Channel{column.quantity}.isAngular();
  const int joint = jointOf(column, instrument, machine);
  return column.meaning != Meaning::Sigma && joint >= 0 && machine.isRotary(joint);
}

/// Reads the rows of a table whose mapping is complete.
class TableReader {
 public:
  TableReader(const ColumnMapping& mapping, const Machine& machine, const std::string& source)
      : mapping_(mapping), machine_(machine) {
    out_.machine = machine;
    Measurement& measurement = out_.measurement;
    measurement.source = source;
    measurement.machine_id = machine.id();
    measurement.instrument = mapping.instrument;
    measurement.repeatability = mapping.repeatability;
    measurement.commanded.assign(static_cast<std::size_t>(machine.jointCount()), false);
    for (const MappedColumn& column : mapping.columns) enter(column);
  }

  MeasurementReading read(const std::vector<TextLine>& lines) {
    for (const TextLine& line : lines) {
      if (line.number <= mapping_.header_line || isEmptyLine(line.text) || out_.diagnostics.full()) continue;
      readRow(line);
    }
    if (out_.measurement.samples.empty() && !out_.diagnostics.hasErrors()) {
      out_.diagnostics.error("table.row", "The table has no rows.", mapping_.header_line);
    }
    return std::move(out_);
  }

 private:
  void enter(const MappedColumn& column) {
    Measurement& measurement = out_.measurement;
    if (column.meaning == Meaning::Position) {
      measurement.commanded[static_cast<std::size_t>(machine_.find(*column.axis))] = true;
    } else if (column.meaning == Meaning::Reading || column.meaning == Meaning::Actual) {
      const bool angular = isAngular(column, mapping_.instrument, machine_);
      const Quantity actual = angular ? Quantity::Angle : Quantity::Length;
      measurement.channels.push_back({column.meaning == Meaning::Actual ? actual : column.quantity});
    } else if (column.meaning == Meaning::Covariate) {
      measurement.covariates.push_back({column.name, {}});
    }
  }

  void readRow(const TextLine& line) {
    std::vector<Cell> cells = cellsOf(line.text, mapping_.separator);
    while (cells.size() > mapping_.columns.size() && cells.back().text.empty()) cells.pop_back();
    if (cells.size() != mapping_.columns.size()) {
      out_.diagnostics.error(
          "table.row",
          fmt::format("The row has {} cells, expected {}: missing or additional cells, or another "
                      "separator.",
                      cells.size(), mapping_.columns.size()),
          line.number);
      return;
    }
    Sample sample;
    sample.line = line.number;
    std::vector<std::optional<double>> readings;
    std::vector<std::pair<std::size_t, int>> actuals;  // channel and joint, to be made deviations
    std::size_t covariate = 0;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const MappedColumn& column = mapping_.columns[c];
      if (column.meaning == Meaning::Ignored) continue;
      const std::optional<double> value = numberOf(cells[c], column, line.number);
      if (column.meaning == Meaning::Covariate) {
        out_.measurement.covariates[covariate++].values.push_back(value);
      } else {
        if (column.meaning == Meaning::Actual) {
          actuals.emplace_back(readings.size(), jointOf(column, mapping_.instrument, machine_));
        }
        take(column, value, sample, readings);
      }
    }
    for (const auto& [channel, joint] : actuals) {
      if (!readings[channel]) continue;
      if (sample.missing[static_cast<std::size_t>(joint)]) readings[channel].reset();
      if (readings[channel]) *readings[channel] -= sample.q[static_cast<std::size_t>(joint)];
    }
    out_.measurement.samples.push_back(sample);
    for (const std::optional<double>& reading : readings) out_.measurement.readings.push_back(reading);
  }

  std::optional<double> numberOf(const Cell& cell, const MappedColumn& column, std::size_t line) {
    if (cell.text.empty()) return std::nullopt;
    std::string text = cell.text;
    if (mapping_.decimal_comma) std::replace(text.begin(), text.end(), ',', '.');
    const std::optional<double> value = parseNumber(text);
    if (!value) {
      out_.diagnostics.error("table.number",
                             fmt::format("'{}' is '{}', expected a number with a decimal {}.", column.header,
                                         printable(cell.text), mapping_.decimal_comma ? "comma" : "point"),
                             line, cell.column);
      return std::nullopt;
    }
    const double factor = column.meaning == Meaning::Covariate ? 1.0 : *factorOf(column.unit);
    return (column.negative ? -factor : factor) * *value;
  }

  void take(const MappedColumn& column, const std::optional<double>& value, Sample& sample,
            std::vector<std::optional<double>>& readings) {
    if (column.meaning == Meaning::Position) {
      const auto joint = static_cast<std::size_t>(machine_.find(*column.axis));
      if (value) {
        sample.q[joint] = *value;
      } else {
        sample.has_positions = false;
        sample.missing.set(joint);
      }
    } else if (column.meaning == Meaning::Sigma) {
      const bool angular =
          std::find(angleUnits().begin(), angleUnits().end(), column.unit) != angleUnits().end();
      (angular ? sample.angular_sigma : sample.sigma) = value;
    } else {
      readings.push_back(value);
    }
  }

  const ColumnMapping& mapping_;
  const Machine& machine_;
  MeasurementReading out_;
};

}  // namespace

std::vector<Question> openQuestions(const ColumnMapping& mapping, const Machine& machine) {
  std::vector<Question> questions;
  bool has_reading = false;
  for (std::size_t c = 0; c < mapping.columns.size(); ++c) {
    const MappedColumn& column = mapping.columns[c];
    const std::string place = fmt::format("column {} ('{}')", c + 1, printable(column.header));
    has_reading = has_reading || column.meaning == Meaning::Reading || column.meaning == Meaning::Actual;
    if (column.meaning == Meaning::Unknown) {
      questions.push_back({fmt::format("meaning-{}", c + 1),
                           "What is " + place + "?",
                           {{"position", "commanded position of an axis"},
                            {"reading", "deviation, actual minus commanded"},
                            {"actual", "actual position of the axis under test"},
                            {"sigma", "uncertainty"},
                            {"covariate", "a condition such as a temperature"},
                            {"ignored", "nothing that is needed"}},
                           "",
                           std::nullopt});
      continue;
    }
    if (column.meaning == Meaning::Position && (!column.axis || machine.find(*column.axis) < 0)) {
      Question question{fmt::format("axis-{}", c + 1), "Which axis is " + place + "?", {}, "", std::nullopt};
      for (const kinematics::Joint& joint : machine.joints()) {
        question.choices.push_back({joint.axis.text(), joint.axis.text()});
      }
      questions.push_back(std::move(question));
    } else if (needsUnit(column) && !factorOf(column.unit)) {
      questions.push_back(
          {fmt::format("unit-{}", c + 1), "In which unit is " + place + "?",
           choicesOf(isAngular(column, mapping.instrument, machine) ? angleUnits() : lengthUnits()), "",
           std::nullopt});
    }
  }
  if (!has_reading)
    questions.push_back({"reading", "Which column holds the readings?", {}, "a column", std::nullopt});
  if (mapping.instrument.needsAxis() &&
      (!mapping.instrument.axis || machine.find(*mapping.instrument.axis) < 0)) {
    questions.push_back({"axis", "Which axis was measured?", {}, "an axis of the machine", std::nullopt});
  }
  return questions;
}

MeasurementReading readMapped(std::string_view bytes, const std::string& source, const ColumnMapping& mapping,
                              const Machine& machine) {
  MeasurementReading refused;
  refused.measurement.source = source;
  const std::vector<Question> open = openQuestions(mapping, machine);
  if (!open.empty()) {
    refused.diagnostics.error("table.mapping", "The columns are not all named yet: " + open.front().text);
    return refused;
  }
  const Result<DecodedText> decoded = decodeText(bytes, source);
  if (!decoded) {
    refused.diagnostics.error(decoded.error().code, decoded.error().text, decoded.error().line);
    return refused;
  }
  return TableReader(mapping, machine, source).read(linesOf(decoded->text));
}

std::string layoutFingerprint(const ColumnMapping& mapping) {
  std::string layout = fmt::format("{}|{}|{}", mapping.separator, mapping.decimal_comma, mapping.header_line);
  for (const MappedColumn& column : mapping.columns) layout += "|" + column.header;
  std::uint64_t hash = 0xcbf29ce484222325ULL;  // FNV-1a
  for (const char c : layout) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return fmt::format("{:016x}", hash);
}

}  // namespace nineline::measurement
