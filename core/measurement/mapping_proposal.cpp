#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "core/base/text.h"
#include "core/measurement/column_mapping.h"
#include "core/measurement/delimited_text.h"
#include "core/measurement/table_units.h"

namespace nineline::measurement {

namespace {

constexpr std::size_t kSampleLines = 50;  // looked at to tell the layout

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

bool contains(std::string_view text, std::string_view word) {
  return text.find(word) != std::string_view::npos;
}

/// Words that headers use, in three languages, and what they mean.
struct KnownWord {
  std::string_view word;
  Meaning meaning;
};
constexpr std::array<KnownWord, 19> kWords = {{{"deviation", Meaning::Reading},
                                               {"error", Meaning::Reading},
                                               {"abweichung", Meaning::Reading},
                                               {"偏差", Meaning::Reading},
                                               {"误差", Meaning::Reading},
                                               {"actual", Meaning::Actual},
                                               {"measured", Meaning::Actual},
                                               {"istwert", Meaning::Actual},
                                               {"实测", Meaning::Actual},
                                               {"target", Meaning::Position},
                                               {"nominal", Meaning::Position},
                                               {"commanded", Meaning::Position},
                                               {"position", Meaning::Position},
                                               {"sollwert", Meaning::Position},
                                               {"目标", Meaning::Position},
                                               {"位置", Meaning::Position},
                                               {"uncertainty", Meaning::Sigma},
                                               {"sigma", Meaning::Sigma},
                                               {"standard deviation", Meaning::Sigma}}};

Meaning meaningOf(const std::string& header) {
  const std::string text = lower(header);
  if (contains(text, "standard deviation")) return Meaning::Sigma;
  for (const KnownWord& known : kWords) {
    if (contains(text, known.word)) return known.meaning;
  }
  return Meaning::Unknown;
}

/// A header that is a name of the contract as it stands.
bool takeContractName(MappedColumn& column, const Machine& machine) {
  const std::string& header = column.header;
  for (const kinematics::Joint& joint : machine.joints()) {
    for (const std::string unit : {"mm", "deg"}) {
      if (header != joint.axis.text() + "_" + unit) continue;
      column.meaning = Meaning::Position;
      column.axis = joint.axis;
      column.unit = unit;
      return true;
    }
  }
  constexpr std::array<std::string_view, 6> kCovariates = {"run",    "t_s",     "feed_mm_min",
                                                           "pass_1", "load_kg", "theta_deg"};
  const bool known = std::find(kCovariates.begin(), kCovariates.end(), header) != kCovariates.end() ||
                     header.starts_with("temp_") || header.starts_with("approach_");
  if (!known) return false;
  column.meaning = Meaning::Covariate;
  column.name = header;
  return true;
}

MappedColumn propose(const std::string& header, const Machine& machine) {
  MappedColumn column;
  column.header = header;
  if (takeContractName(column, machine)) return column;
  column.unit = unitInHeader(header).value_or("");
  const std::string text = lower(header);
  if (text == "run" || text == "lauf" || contains(header, "次数")) {
    column.meaning = Meaning::Covariate;
    column.name = "run";
    column.unit.clear();
    return column;
  }
  if (column.unit.empty()) return column;  // a word alone leaves doubt
  column.meaning = meaningOf(header);
  const std::vector<std::string>& angles = angleUnits();
  const bool angular = std::find(angles.begin(), angles.end(), column.unit) != angles.end();
  if (angular) column.quantity = Quantity::Angle;
  // A single letter beside the unit names the axis: "X (mm)", "Target X [mm]".
  const std::string bare(trimmed(std::string_view(header).substr(0, header.find_first_of("([{"))));
  const std::string_view last = std::string_view(bare).substr(bare.find_last_of(' ') + 1);
  if (const std::optional<AxisId> axis = parseAxisId(last); axis && machine.find(*axis) >= 0) {
    if (column.meaning == Meaning::Unknown && last.size() == bare.size()) column.meaning = Meaning::Position;
    if (column.meaning == Meaning::Position) column.axis = axis;
  }
  return column;
}

/// How many cells of a line are numbers, with either decimal sign.
std::size_t numbersIn(std::string_view line, char separator) {
  std::size_t count = 0;
  for (const Cell& cell : cellsOf(line, separator)) {
    std::string text = cell.text;
    std::replace(text.begin(), text.end(), ',', '.');
    count += parseNumber(text) ? 1U : 0U;
  }
  return count;
}

/// The separator that splits most of the lines into the same number of cells, above one.
char likelySeparator(const std::vector<TextLine>& lines) {
  char best = ',';
  std::size_t best_score = 0;
  for (const char separator : {'\t', ';', ','}) {
    std::vector<std::size_t> counts;
    for (const TextLine& line : lines) {
      if (!isEmptyLine(line.text)) counts.push_back(cellsOf(line.text, separator).size());
    }
    std::size_t score = 0;
    for (const std::size_t cells : counts) {
      if (cells < 2) continue;
      score = std::max(score, static_cast<std::size_t>(std::count(counts.begin(), counts.end(), cells)));
    }
    if (score > best_score) {
      best = separator;
      best_score = score;
    }
  }
  return best_score == 0 ? '\0' : best;
}

bool hasDecimalCommas(const std::vector<TextLine>& lines, char separator) {
  if (separator == ',') return false;
  std::size_t commas = 0;
  std::size_t points = 0;
  for (const TextLine& line : lines) {
    for (const Cell& cell : cellsOf(line.text, separator)) {
      std::string text = cell.text;
      if (parseNumber(text)) {
        points += contains(text, ".") ? 1U : 0U;
        continue;
      }
      std::replace(text.begin(), text.end(), ',', '.');
      commas += parseNumber(text) ? 1U : 0U;
    }
  }
  return commas > points;
}

}  // namespace

Result<ColumnMapping> proposeMapping(std::string_view bytes, const std::string& source,
                                     const Machine& machine) {
  const Result<DecodedText> decoded = decodeText(bytes, source);
  if (!decoded) return decoded.error();
  std::vector<TextLine> lines = linesOf(decoded->text);
  if (lines.size() > kSampleLines) lines.resize(kSampleLines);
  const char separator = likelySeparator(lines);
  if (separator == '\0') {
    return badInput("table.format", "The text is no table: no line has cells between tabs, ';' or ','.",
                    source, 1);
  }
  ColumnMapping mapping;
  mapping.separator = separator;
  mapping.decimal_comma = hasDecimalCommas(lines, separator);
  const auto first = std::find_if(lines.begin(), lines.end(),
                                  [&](const TextLine& line) { return numbersIn(line.text, separator) >= 2; });
  if (first == lines.end()) {
    return badInput("table.format", "The text is no table: no line has two numbers.", source, 1);
  }
  const std::size_t width = cellsOf(first->text, separator).size();
  mapping.header_line = 0;
  std::vector<Cell> names(width);
  for (auto line = first; line != lines.begin();) {
    --line;
    if (isEmptyLine(line->text)) continue;
    const std::vector<Cell> cells = cellsOf(line->text, separator);
    mapping.header_line = first->number - 1;
    if (cells.size() == width) names = cells;
    break;
  }
  for (const Cell& name : names) mapping.columns.push_back(propose(name.text, machine));
  return mapping;
}

}  // namespace nineline::measurement
