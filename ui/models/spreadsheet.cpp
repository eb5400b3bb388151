#include "ui/models/spreadsheet.h"

#include <QRegularExpression>

#include "core/base/text.h"

namespace nineline::models {

namespace {

constexpr int kShownDigits = 7;

/// What parts the columns of these lines; a null character where each line is one cell.
QChar separatorOf(const QStringList& lines) {
  for (const QChar candidate : {QLatin1Char('\t'), QLatin1Char(';')}) {
    for (const QString& line : lines) {
      if (line.contains(candidate)) return candidate;
    }
  }
  static const QRegularExpression kDecimalComma(QStringLiteral("^\\s*[-+\\x{2212}]?\\d*,\\d+\\s*$"));
  bool comma = false;
  bool all_decimal = true;
  for (const QString& line : lines) {
    if (!line.contains(QLatin1Char(','))) continue;
    comma = true;
    all_decimal = all_decimal && kDecimalComma.match(line).hasMatch();
  }
  return comma && !all_decimal ? QChar(QLatin1Char(',')) : QChar();
}

}  // namespace

std::optional<double> numberFromTyped(const QString& text) {
  QString plain = text.trimmed();
  plain.replace(QChar(0x2212), QLatin1Char('-'));
  if (plain.count(QLatin1Char(',')) == 1 && !plain.contains(QLatin1Char('.'))) {
    plain.replace(QLatin1Char(','), QLatin1Char('.'));
  }
  return parseNumber(plain.toStdString());
}

Json cellFromTyped(const QString& text) {
  if (text.trimmed().isEmpty()) return {};
  if (const std::optional<double> value = numberFromTyped(text)) return *value;
  return text.trimmed().toStdString();
}

QString typedFromCell(const Json& cell) {
  if (const double* number = cell.number()) return QString::fromStdString(shortest(*number));
  if (const std::string* text = cell.string()) return QString::fromStdString(*text);
  return {};
}

QString shownFromCell(const Json& cell) {
  const QString typed = typedFromCell(cell);
  if (cell.number() == nullptr || typed.size() <= kShownDigits + 2) return typed;
  return QString::number(*cell.number(), 'g', kShownDigits);
}

std::vector<QStringList> cellsOf(const QString& text) {
  QString normal = text;
  normal.remove(QChar(0xFEFF));
  normal.replace(QLatin1String("\r\n"), QLatin1String("\n"));
  normal.replace(QLatin1Char('\r'), QLatin1Char('\n'));
  QStringList lines = normal.split(QLatin1Char('\n'));
  while (!lines.isEmpty() && lines.back().trimmed().isEmpty()) lines.removeLast();
  const QChar separator = separatorOf(lines);
  std::vector<QStringList> rows;
  for (const QString& line : lines) {
    QStringList cells = separator.isNull() ? QStringList{line} : line.split(separator);
    for (QString& cell : cells) {
      cell = cell.trimmed();
      if (cell.size() >= 2 && cell.startsWith(QLatin1Char('"')) && cell.endsWith(QLatin1Char('"'))) {
        cell = cell.mid(1, cell.size() - 2);
      }
    }
    rows.push_back(cells);
  }
  return rows;
}

}  // namespace nineline::models
