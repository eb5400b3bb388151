#include "ui/models/error_table_model.h"

#include <cmath>

#include "ui/models/component_names.h"
#include "ui/models/effect_entries.h"
#include "ui/models/spreadsheet.h"

namespace nineline::models {

namespace {

constexpr double kSpacingTolerance = 1e-6;  // of the spacing
constexpr double kLargest_um = 1000.0;      // larger ones are units mixed up more often than errors
constexpr double kLargest_arcsec = 2100.0;

}  // namespace

ErrorTableModel::ErrorTableModel(QObject* parent) : QAbstractTableModel(parent) {}

void ErrorTableModel::setEntry(const kinematics::Machine& machine, const errors::Component& component,
                               Json entry) {
  const TableKeys keys = tableKeys(component, machine);
  const Json* found = entry.find(keys.values);
  Json::Array values = found != nullptr && found->items() != nullptr ? *found->items() : Json::Array{};
  const bool same_shape = component_ == component && values.size() == values_.size();
  if (!same_shape) beginResetModel();
  component_ = component;
  start_key_ = keys.start;
  spacing_key_ = keys.spacing;
  values_key_ = keys.values;
  position_unit_ = positionUnitOf(machine, machine.find(component.axis));
  value_unit_ = unitOf(component);
  entry_ = std::move(entry);
  values_ = std::move(values);
  if (!same_shape) {
    endResetModel();
  } else if (!values_.empty()) {
    emit dataChanged(index(0, 0), index(rowCount() - 1, 1));
  }
}

void ErrorTableModel::clear() {
  beginResetModel();
  component_.reset();
  entry_ = Json();
  values_.clear();
  endResetModel();
}

std::optional<double> ErrorTableModel::number(const std::string& key) const {
  const Json* found = entry_.find(key);
  if (found == nullptr || found->number() == nullptr) return std::nullopt;
  return *found->number();
}

std::optional<double> ErrorTableModel::start() const { return number(start_key_); }
std::optional<double> ErrorTableModel::spacing() const { return number(spacing_key_); }

std::vector<std::pair<double, double>> ErrorTableModel::points() const {
  std::vector<std::pair<double, double>> points;
  const auto first = start();
  const auto step = spacing();
  if (!first || !step) return points;
  for (std::size_t i = 0; i < values_.size(); ++i) {
    if (values_[i].number() != nullptr) {
      points.emplace_back(*first + *step * static_cast<double>(i), *values_[i].number());
    }
  }
  return points;
}

void ErrorTableModel::emitValues(Json::Array values, Json entry) {
  entry.set(values_key_, Json(std::move(values)));
  emit entryEdited(entry);
}

QString ErrorTableModel::paste(const std::vector<QStringList>& cells, int row) {
  if (!component_ || cells.empty()) return tr("There is nothing to paste.");
  std::vector<QStringList> rows = cells;
  if (!numberFromTyped(rows.front().back()) && rows.size() > 1) rows.erase(rows.begin());  // column names
  const bool with_positions = rows.front().size() >= 2;
  Json entry = entry_;
  if (with_positions) {
    std::vector<double> positions;
    for (const QStringList& one : rows) {
      const auto position = numberFromTyped(one.value(0));
      if (!position) return tr("'%1' is no position.").arg(one.value(0));
      positions.push_back(*position);
    }
    if (positions.size() < 2) return tr("Paste at least two positions, or values alone.");
    const double step = (positions.back() - positions.front()) / static_cast<double>(positions.size() - 1);
    if (step <= 0.0) return tr("The positions must grow from row to row.");
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const double expected = positions.front() + step * static_cast<double>(i);
      if (std::abs(positions[i] - expected) > kSpacingTolerance * step * static_cast<double>(rows.size())) {
        return tr("The positions are not equally spaced: row %1 is %2, expected %3.")
            .arg(i + 1)
            .arg(positions[i])
            .arg(expected);
      }
    }
    entry.set(start_key_, positions.front());
    entry.set(spacing_key_, step);
    row = 0;
  }
  const auto first = static_cast<std::size_t>(std::max(row, 0));
  if (first + rows.size() > kMostValues) return tr("A table takes at most %1 values.").arg(kMostValues);
  Json::Array values = with_positions ? Json::Array{} : values_;
  if (values.size() < first + rows.size()) values.resize(first + rows.size(), Json(0.0));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    values[first + i] = cellFromTyped(rows[i].value(with_positions ? 1 : 0));
  }
  emitValues(std::move(values), std::move(entry));
  return {};
}

void ErrorTableModel::clearRows(int first, int last) {
  Json::Array values = values_;
  for (int row = std::max(first, 0); row <= last && row < rowCount(); ++row) {
    values[static_cast<std::size_t>(row)] = Json(0.0);
  }
  emitValues(std::move(values), entry_);
}

int ErrorTableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(values_.size());
}

int ErrorTableModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : 2; }

QString ErrorTableModel::fault(const Json& cell) const {
  if (cell.isNull()) return tr("A value is missing here.");
  if (cell.number() == nullptr) {
    return tr("'%1' is no number. Type digits, with a point or a comma.").arg(typedFromCell(cell));
  }
  const double largest = component_->isAngular() ? kLargest_arcsec : kLargest_um;
  if (std::abs(*cell.number()) > largest) {
    return tr("%1 %2 is very large for a machine error. Is the unit right?")
        .arg(typedFromCell(cell), value_unit_);
  }
  return {};
}

QVariant ErrorTableModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const auto row = static_cast<std::size_t>(index.row());
  if (role == Qt::TextAlignmentRole) return int(Qt::AlignRight | Qt::AlignVCenter);
  if (index.column() == 0) {
    if (role != Qt::DisplayRole) return {};
    const auto first = start();
    const auto step = spacing();
    if (!first || !step) return QStringLiteral("?");
    return QString::number(*first + *step * static_cast<double>(row), 'g', 10);
  }
  const QString wrong = fault(values_[row]);
  switch (role) {
    case Qt::DisplayRole:
      return shownFromCell(values_[row]);
    case Qt::EditRole:
      return typedFromCell(values_[row]);
    case Qt::ToolTipRole:
      return wrong;
    case Qt::UserRole:
      return !wrong.isEmpty();
    default:
      return {};
  }
}

bool ErrorTableModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || !index.isValid() || index.column() != 1) return false;
  Json::Array values = values_;
  values[static_cast<std::size_t>(index.row())] = cellFromTyped(value.toString());
  emitValues(std::move(values), entry_);
  return true;
}

Qt::ItemFlags ErrorTableModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return Qt::NoItemFlags;
  const Qt::ItemFlags basic = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren;
  return index.column() == 1 ? basic | Qt::ItemIsEditable : basic;
}

QVariant ErrorTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role != Qt::DisplayRole) return {};
  if (orientation == Qt::Vertical) return section + 1;
  if (!component_) return {};
  return section == 0 ? tr("Position, %1").arg(position_unit_)
                      : tr("%1, %2").arg(QString::fromStdString(component_->text()), value_unit_);
}

}  // namespace nineline::models
