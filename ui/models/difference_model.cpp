#include "ui/models/difference_model.h"

#include <cctype>
#include <cmath>
#include <map>

#include "core/base/text.h"
#include "core/base/units.h"

namespace nineline::models {

namespace {

enum Column { OriginalNumber, Original, Corrected, Difference, ColumnCount };

bool isNumberCharacter(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == '+';
}

/// A line without comments, numbers and axis words: what compensation does not change.
std::string skeletonOf(std::string_view line) {
  std::string skeleton;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    const bool axis = std::string_view("XYZABCUVWIJKR").find(c) != std::string_view::npos;
    const bool number_follows = i + 1 < line.size() && (isNumberCharacter(line[i + 1]) || line[i + 1] == '=');
    if (axis && number_follows) {
      while (i + 1 < line.size() && (isNumberCharacter(line[i + 1]) || line[i + 1] == '=')) ++i;
      continue;
    }
    if (c != ' ') skeleton += c;
  }
  return skeleton;
}

/// Axis words with a plain number.
std::map<std::string, double> wordsOf(std::string_view line) {
  std::map<std::string, double> words;
  bool comment = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '(') comment = true;
    if (line[i] == ')') comment = false;
    if (line[i] == ';') break;
    if (comment || std::string_view("XYZABCUVWIJKR").find(line[i]) == std::string_view::npos) continue;
    std::size_t end = i + 1;
    while (end < line.size() && line[end] == ' ') ++end;
    const std::size_t begin = end;
    while (end < line.size() && isNumberCharacter(line[end])) ++end;
    if (const auto value = parseNumber(line.substr(begin, end - begin))) {
      words[std::string(1, line[i])] = *value;
    }
    i = end - 1;
  }
  return words;
}

std::vector<std::string_view> linesOf(const std::string* text) {
  if (text == nullptr || text->empty()) return {};
  std::vector<std::string_view> lines = split(*text, '\n');
  if (!lines.empty() && lines.back().empty()) lines.pop_back();
  for (std::string_view& line : lines) {
    if (line.ends_with('\r')) line.remove_suffix(1);
  }
  return lines;
}

}  // namespace

QString wordDifferences(std::string_view original, std::string_view corrected) {
  const auto before = wordsOf(original);
  const auto after = wordsOf(corrected);
  QString text;
  for (const auto& [letter, value] : after) {
    const auto known = before.find(letter);
    if (known != before.end() && known->second == value) continue;
    if (!text.isEmpty()) text += QStringLiteral("   ");
    text += QString::fromStdString(letter) + QLatin1Char(' ');
    if (known == before.end()) {
      text += DifferenceModel::tr("added");
      continue;
    }
    const double change = value - known->second;
    const bool angle = letter == "A" || letter == "B" || letter == "C";
    const double shown = angle ? arcsecFromRad(radFromDeg(change)) : umFromMm(change);
    text += (shown < 0.0 ? QStringLiteral("−") : QStringLiteral("+")) +
            QString::number(std::abs(shown), 'f', 1) + (angle ? QStringLiteral("″") : QStringLiteral(" µm"));
  }
  return text;
}

DifferenceModel::DifferenceModel(QObject* parent) : QAbstractTableModel(parent) {}

void DifferenceModel::setTexts(std::shared_ptr<const std::string> original,
                               std::shared_ptr<const std::string> corrected) {
  beginResetModel();
  original_ = std::move(original);
  corrected_ = std::move(corrected);
  original_lines_ = linesOf(original_.get());
  corrected_lines_ = linesOf(corrected_.get());
  rows_.clear();
  std::size_t i = 0;
  for (std::size_t k = 0; k < corrected_lines_.size(); ++k) {
    const std::string_view now = corrected_lines_[k];
    if (i < original_lines_.size()) {
      // An inserted line precedes its block's own line: it is inserted when the original line still comes.
      const std::size_t spare = corrected_lines_.size() - k;
      const std::size_t needed = original_lines_.size() - i;
      const bool same = original_lines_[i] == now;
      const bool alike = same || skeletonOf(original_lines_[i]) == skeletonOf(now);
      if (alike || spare <= needed) {
        rows_.push_back({static_cast<std::int64_t>(i), static_cast<std::int64_t>(k), !same});
        ++i;
        continue;
      }
    }
    rows_.push_back({-1, static_cast<std::int64_t>(k), true});
  }
  for (; i < original_lines_.size(); ++i) rows_.push_back({static_cast<std::int64_t>(i), -1, true});
  endResetModel();
}

int DifferenceModel::nextChange(int row) const {
  for (int next = row + 1; next < rowCount(); ++next) {
    if (rows_[static_cast<std::size_t>(next)].changed) return next;
  }
  return -1;
}

int DifferenceModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int DifferenceModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QString DifferenceModel::line(const std::vector<std::string_view>& lines, std::int64_t index) const {
  if (index < 0) return {};
  const std::string_view text = lines[static_cast<std::size_t>(index)];
  return QString::fromUtf8(text.data(), static_cast<int>(text.size()));
}

QString DifferenceModel::differenceText(const Row& row) const {
  if (!row.changed) return {};
  if (row.original < 0) return tr("inserted");
  if (row.corrected < 0) return tr("left out");
  return wordDifferences(original_lines_[static_cast<std::size_t>(row.original)],
                         corrected_lines_[static_cast<std::size_t>(row.corrected)]);
}

QVariant DifferenceModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  if (role == ChangedRole) return row.changed;
  if (role == Qt::TextAlignmentRole && index.column() == OriginalNumber) {
    return int(Qt::AlignRight | Qt::AlignVCenter);
  }
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case OriginalNumber:
      return row.original < 0 ? QString() : QString::number(row.original + 1);
    case Original:
      return line(original_lines_, row.original);
    case Corrected:
      return line(corrected_lines_, row.corrected);
    case Difference:
      return differenceText(row);
    default:
      return {};
  }
}

QVariant DifferenceModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case OriginalNumber:
      return tr("Line");
    case Original:
      return tr("Original program");
    case Corrected:
      return tr("Corrected program");
    case Difference:
      return tr("Difference");
    default:
      return {};
  }
}

}  // namespace nineline::models
