#pragma once

#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "core/base/json.h"

namespace nineline::models {

/// A number as people type it: decimal point or comma, blanks around, a leading sign (also the typographic
/// minus). Nothing for any other text.
[[nodiscard]] std::optional<double> numberFromTyped(const QString& text);
/// The number, or the text as it was typed where it is none; null for an empty cell.
[[nodiscard]] Json cellFromTyped(const QString& text);
/// How a cell is shown.
[[nodiscard]] QString typedFromCell(const Json& cell);
/// The same with at most seven digits: what fits into a cell that is not being edited.
[[nodiscard]] QString shownFromCell(const Json& cell);

/// Cells of a spreadsheet's clipboard or of a CSV file, row by row. Columns are parted by tab; without a tab
/// by semicolon; without either by comma, where a comma followed by blank or standing between points parts,
/// and a column of plain decimal commas stays one column.
[[nodiscard]] std::vector<QStringList> cellsOf(const QString& text);

}  // namespace nineline::models
