#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/errors/table_effects.h"
#include "core/measurement/delimited_text.h"
#include "core/measurement/import.h"
#include "core/measurement/rtl_text.h"

namespace nineline::measurement {

namespace {

using errors::Component;

constexpr std::size_t kMostPoints = 20000;  // of one table

/// Argument (mm or degrees) and value (mm or rad) of one grid point, with its line.
struct GridPoint {
  double argument = 0.0;
  double value = 0.0;
  std::size_t line = 0;
};

/// Factor of the values: files state errors, or corrections of the opposite sign.
std::optional<double> askSign(const Answers& answers, Import& import) {
  const std::optional<std::string> answer =
      answerTo({"table-sign",
                "Are the values errors (actual minus ideal) or corrections? The file does not say it.",
                {{"error", "errors, actual minus ideal"}, {"correction", "corrections, ideal minus actual"}},
                "",
                std::nullopt},
               answers, import);
  if (!answer) return std::nullopt;
  return *answer == "error" ? 1.0 : -1.0;
}

/// A grid of equal steps that holds every point; points between are interpolated linearly, which is what the
/// table means. Fails where the arguments have no common step.
Result<errors::ErrorTable> tableOf(std::vector<GridPoint> points, bool rotary, const std::string& name) {
  std::sort(points.begin(), points.end(),
            [](const GridPoint& one, const GridPoint& other) { return one.argument < other.argument; });
  double step = points.size() > 1 ? points.back().argument - points.front().argument : 1.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double gap = points[i].argument - points[i - 1].argument;
    if (!(gap > 0.0)) {
      return badInput("table.double", fmt::format("{} has two values at {}.", name, points[i].argument), "",
                      points[i].line);
    }
    step = std::min(step, gap);
  }
  std::vector<double> values;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i == 0) {
      values.push_back(points[0].value);
      continue;
    }
    const double gap = points[i].argument - points[i - 1].argument;
    const double steps = std::round(gap / step);
    if (std::abs(gap - steps * step) > 1e-6 * step ||
        values.size() + static_cast<std::size_t>(steps) > kMostPoints) {
      return badInput(
          "table.step",
          fmt::format("The grid of {} has no common step (a step of {} after steps of {}).", name, gap, step),
          "", points[i].line);
    }
    for (double k = 1.0; k <= steps; k += 1.0) {
      values.push_back(std::lerp(points[i - 1].value, points[i].value, k / steps));
    }
  }
  const auto position = [rotary](double shown) { return rotary ? radFromDeg(shown) : shown; };
  return errors::ErrorTable::make(
      {position(points.front().argument), position(step), errors::Interpolation::Linear, std::nullopt},
      std::move(values));
}

void addTable(const Component& component, const std::vector<GridPoint>& points, const Machine& machine,
              Import& import) {
  const int joint = machine.find(component.axis);
  Result<errors::ErrorTable> table = tableOf(points, machine.isRotary(joint), component.text());
  if (!table) {
    import.diagnostics.error(table.error().code, table.error().text, table.error().line);
    return;
  }
  auto effect = std::make_shared<errors::TableEffect>(joint, component, std::move(*table), false);
  effect->setProvenance({"imported", ""});
  import.effects.push_back(std::move(effect));
}

/// The component of a name if it belongs to the machine; a fault otherwise.
std::optional<Component> componentOf(std::string_view name, bool location, const Machine& machine,
                                     std::size_t line, Import& import) {
  const std::optional<Component> component = errors::parseComponent(name);
  if (!component || component->location != location) {
    import.diagnostics.error(
        "table.name",
        fmt::format("'{}' is no {}, expected a name such as {}.", printable(name),
                    location ? "location error" : "error of an axis", location ? "C0B" : "EXY"),
        line);
    return std::nullopt;
  }
  if (machine.find(component->axis) >= 0) return component;
  import.diagnostics.error("table.axis",
                           fmt::format("{} belongs to axis {}, which the machine '{}' lacks.",
                                       component->text(), component->axis.text(), machine.id()),
                           line);
  return std::nullopt;
}

/// Reads the blocks of an Etalon exchange file.
class EtalonReader {
 public:
  EtalonReader(const Machine& machine, double sign, Import& import)
      : machine_(machine), sign_(sign), import_(import) {}

  void read(std::string_view text) {
    for (const TextLine& line : linesOf(text)) {
      std::string_view content = line.text.substr(0, line.text.find("//"));
      content = trimmed(content);
      if (!content.empty()) readLine(content, line.number);
    }
    if (in_table_)
      import_.diagnostics.error("etalon.end", "A table is not closed by '}'; the file is cut off.", line_);
  }

 private:
  void readLine(std::string_view text, std::size_t line) {
    line_ = line;
    if (text.front() == '[' && text.back() == ']') {
      block_ = std::string(trimmed(text.substr(1, text.size() - 2)));
    } else if (in_table_) {
      readPoints(text, line);
    } else if (const std::size_t equals = text.find('='); equals != std::string_view::npos) {
      readKey(upper(trimmed(text.substr(0, equals))), trimmed(text.substr(equals + 1)), line);
    } else {
      import_.diagnostics.error(
          "etalon.line", fmt::format("'{}' is neither [NAME], VALUE nor Gridpoints.", printable(text)), line);
    }
  }

  void readKey(const std::string& key, std::string_view value, std::size_t line) {
    if (key == "VALUE") return addLocation(value, line);
    if (key != "GRIDPOINTS" || !value.starts_with('{')) {
      import_.head.emplace_back(block_ + "." + key, std::string(value));
      return;
    }
    in_table_ = true;
    points_.clear();
    pending_.reset();
    readPoints(value.substr(1), line);
  }

  void addLocation(std::string_view value, std::size_t line) {
    const std::optional<double> number = parseNumber(value);
    if (!number) {
      import_.diagnostics.error("etalon.number",
                                fmt::format("VALUE is '{}', expected a number.", printable(value)), line);
      return;
    }
    if (const auto component = componentOf(block_, true, machine_, line, import_)) {
      auto effect = std::make_shared<errors::LocationEffect>(machine_.find(component->axis), *component,
                                                             sign_ * *number, std::nullopt);
      effect->setProvenance({"imported", ""});
      import_.effects.push_back(std::move(effect));
    }
  }

  void readPoints(std::string_view text, std::size_t line) {
    const std::size_t end = text.find('}');
    for (const std::string_view word : wordsOf(text.substr(0, end))) {
      const std::optional<double> number = parseNumber(word);
      if (!number) {
        import_.diagnostics.error(
            "etalon.number",
            fmt::format("'{}' stands among the grid points, expected a number.", printable(word)), line);
      } else if (pending_) {
        points_.push_back({*pending_, sign_ * *number, line});
        pending_.reset();
      } else {
        pending_ = number;
      }
    }
    if (end != std::string_view::npos) closeTable(line);
  }

  void closeTable(std::size_t line) {
    in_table_ = false;
    if (pending_ || points_.empty()) {
      import_.diagnostics.error("etalon.points",
                                fmt::format("The table {} needs pairs of argument and value.", block_), line);
      return;
    }
    if (const auto component = componentOf(block_, false, machine_, line, import_)) {
      addTable(*component, points_, machine_, import_);
    }
  }

  const Machine& machine_;
  double sign_;
  Import& import_;
  std::string block_;
  bool in_table_ = false;
  std::optional<double> pending_;
  std::vector<GridPoint> points_;
  std::size_t line_ = 0;
};

/// One column of an ISG file: the position of an axis, or one error.
struct IsgColumn {
  std::optional<AxisId> axis;
  std::optional<Component> component;
};

std::vector<IsgColumn> isgColumns(const TextLine& line, const Machine& machine, Import& import) {
  std::vector<IsgColumn> columns;
  for (const std::string_view word : wordsOf(line.text)) {
    if (const auto axis = parseAxisId(word)) {
      columns.push_back({axis, std::nullopt});
    } else {
      columns.push_back({std::nullopt, componentOf(word, false, machine, line.number, import)});
    }
  }
  for (const IsgColumn& column : columns) {
    if (!column.component) continue;
    const bool has_axis = std::any_of(columns.begin(), columns.end(), [&](const IsgColumn& one) {
      return one.axis == column.component->axis;
    });
    if (!has_axis) {
      import.diagnostics.error("isg.axis",
                               fmt::format("{} needs a column {} with the positions.",
                                           column.component->text(), column.component->axis.text()),
                               line.number);
    }
  }
  return columns;
}

/// The points of one error over its own axis; the same position may stand in several rows, with the same
/// value.
void collectPoint(std::vector<GridPoint>& points, const GridPoint& point, const Component& component,
                  Import& import) {
  for (const GridPoint& known : points) {
    if (known.argument != point.argument) continue;
    if (known.value != point.value) {
      import.diagnostics.error(
          "isg.value",
          fmt::format("{} has another value at {} in line {}: it depends on more than its axis, "
                      "which a table cannot hold.",
                      component.text(), point.argument, known.line),
          point.line);
    }
    return;
  }
  points.push_back(point);
}

}  // namespace

Import importEtalon(std::string_view bytes, const std::string& source, const Machine& machine,
                    const Answers& answers) {
  Import import;
  import.format = "etalon";
  const Result<DecodedText> decoded = decodeText(bytes, source);
  if (!decoded) {
    import.diagnostics.error(decoded.error().code, decoded.error().text, decoded.error().line);
    return import;
  }
  const std::optional<double> sign = askSign(answers, import);
  EtalonReader(machine, sign.value_or(1.0), import).read(decoded->text);
  if (import.effects.empty() && !import.diagnostics.hasErrors()) {
    import.diagnostics.error("etalon.empty", "The file holds neither VALUE nor Gridpoints.");
  }
  if (!import.isComplete()) import.effects.clear();
  return import;
}

Import importIsg(std::string_view bytes, const std::string& source, const Machine& machine,
                 const Answers& answers) {
  Import import;
  import.format = "isg-csv";
  const Result<DecodedText> decoded = decodeText(bytes, source);
  if (!decoded) {
    import.diagnostics.error(decoded.error().code, decoded.error().text, decoded.error().line);
    return import;
  }
  const double sign = askSign(answers, import).value_or(1.0);
  const std::vector<TextLine> lines = linesOf(decoded->text);
  const std::vector<IsgColumn> columns = isgColumns(lines.front(), machine, import);
  std::vector<std::vector<GridPoint>> points(columns.size());
  for (std::size_t n = 1; n < lines.size() && !import.diagnostics.full(); ++n) {
    const std::vector<std::string_view> words = wordsOf(lines[n].text);
    if (words.empty()) continue;
    if (words.size() != columns.size()) {
      import.diagnostics.error(
          "isg.row", fmt::format("The row has {} numbers, expected {}.", words.size(), columns.size()),
          lines[n].number);
      continue;
    }
    std::vector<double> numbers;
    for (const std::string_view word : words) {
      const std::optional<double> number = parseNumber(word);
      if (!number) {
        import.diagnostics.error("isg.number", fmt::format("'{}' is no number.", printable(word)),
                                 lines[n].number);
      }
      numbers.push_back(number.value_or(0.0));
    }
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (!columns[c].component) continue;
      for (std::size_t a = 0; a < columns.size(); ++a) {
        if (columns[a].axis != columns[c].component->axis) continue;
        collectPoint(points[c], {numbers[a], sign * numbers[c], lines[n].number}, *columns[c].component,
                     import);
      }
    }
  }
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (import.isComplete() && !points[c].empty())
      addTable(*columns[c].component, points[c], machine, import);
  }
  if (!import.isComplete()) import.effects.clear();
  return import;
}

}  // namespace nineline::measurement
