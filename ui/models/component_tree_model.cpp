#include "ui/models/component_tree_model.h"

#include <algorithm>

#include "core/base/json.h"
#include "ui/models/component_names.h"
#include "ui/models/effect_entries.h"

namespace nineline::models {

namespace {

constexpr int kComponentRows = 6;
constexpr int kLocationRow = 6;
constexpr quintptr kTop = 0;  // internal id of top rows; children carry their axis row + 1

std::size_t joint(const QModelIndex& index) {
  return index.internalId() == kTop ? static_cast<std::size_t>(index.row())
                                    : static_cast<std::size_t>(index.internalId() - 1);
}

}  // namespace

ComponentTreeModel::ComponentTreeModel(QObject* parent) : QAbstractItemModel(parent) {}

void ComponentTreeModel::setMachine(const kinematics::Machine* machine) {
  beginResetModel();
  machine_.reset();
  if (machine != nullptr) machine_ = *machine;
  const std::size_t joints = machine_ ? machine_->joints().size() : 0;
  counts_.assign(joints, {});
  locations_.assign(joints, {});
  others_ = 0;
  endResetModel();
}

void ComponentTreeModel::setEffects(const Json& effects) {
  if (!machine_) return;
  for (std::size_t j = 0; j < counts_.size(); ++j) {
    const AxisId axis = machine_->joints()[j].axis;
    for (const errors::Component& one : motionComponents(axis)) {
      const auto found = findEntry(effects, one);
      const Json* values =
          found ? (*effects.items())[*found].find(tableKeys(one, *machine_).values) : nullptr;
      counts_[j][static_cast<std::size_t>(one.row)] =
          values != nullptr && values->items() != nullptr ? values->items()->size() : 0;
    }
    for (const errors::Component& one : locationComponents(axis)) {
      locations_[j][static_cast<std::size_t>(one.row)] = findEntry(effects, one).has_value();
    }
  }
  others_ = otherEntries(effects).size();
  const int rows = rowCount();
  emit dataChanged(index(0, 0), index(rows - 1, 1));
  for (int row = 0; row + 1 < rows; ++row) {
    const QModelIndex axis = index(row, 0);
    emit dataChanged(index(0, 0, axis), index(kLocationRow, 1, axis));
  }
}

ComponentTreeModel::Kind ComponentTreeModel::kind(const QModelIndex& index) const {
  if (index.internalId() == kTop) {
    return static_cast<std::size_t>(index.row()) < counts_.size() ? Kind::Axis : Kind::OtherEffects;
  }
  return index.row() == kLocationRow ? Kind::Location : Kind::Component;
}

std::optional<errors::Component> ComponentTreeModel::component(const QModelIndex& index) const {
  if (!machine_ || !index.isValid() || kind(index) != Kind::Component) return std::nullopt;
  return errors::Component{machine_->joints()[joint(index)].axis, index.row(), false};
}

QModelIndex ComponentTreeModel::indexOf(const errors::Component& component) const {
  const int found = machine_ ? machine_->find(component.axis) : -1;
  if (found < 0) return {};
  return index(component.location ? kLocationRow : component.row, 0, index(found, 0));
}

QModelIndex ComponentTreeModel::index(int row, int column, const QModelIndex& parent) const {
  if (!hasIndex(row, column, parent)) return {};
  return createIndex(row, column, parent.isValid() ? static_cast<quintptr>(parent.row() + 1) : kTop);
}

QModelIndex ComponentTreeModel::parent(const QModelIndex& child) const {
  if (!child.isValid() || child.internalId() == kTop) return {};
  return createIndex(static_cast<int>(child.internalId()) - 1, 0, kTop);
}

int ComponentTreeModel::rowCount(const QModelIndex& parent) const {
  if (!machine_ || parent.column() > 0) return 0;
  if (!parent.isValid()) return static_cast<int>(counts_.size()) + 1;
  return kind(parent) == Kind::Axis ? kComponentRows + 1 : 0;
}

int ComponentTreeModel::columnCount(const QModelIndex&) const { return 2; }

QString ComponentTreeModel::text(const QModelIndex& index) const {
  switch (kind(index)) {
    case Kind::Axis:
      return tr("Axis %1").arg(QString::fromStdString(machine_->joints()[joint(index)].axis.text()));
    case Kind::Component: {
      const auto one = component(index);
      return QStringLiteral("%1  %2").arg(QString::fromStdString(one->text()),
                                          descriptionOf(*one, *machine_));
    }
    case Kind::Location:
      return tr("Squareness and place");
    case Kind::OtherEffects:
      return tr("Other effects");
  }
  return {};
}

std::size_t ComponentTreeModel::locationCount(int axis) const {
  const auto& filled = locations_[static_cast<std::size_t>(axis)];
  return static_cast<std::size_t>(std::count(filled.begin(), filled.end(), true));
}

QString ComponentTreeModel::content(const QModelIndex& index) const {
  const auto number = [](std::size_t count) { return count == 0 ? QString() : QString::number(count); };
  switch (kind(index)) {
    case Kind::Axis:
      return {};
    case Kind::Component:
      return number(counts_[joint(index)][static_cast<std::size_t>(index.row())]);
    case Kind::Location:
      return number(locationCount(static_cast<int>(joint(index))));
    case Kind::OtherEffects:
      return number(others_);
  }
  return {};
}

QVariant ComponentTreeModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || !machine_) return {};
  switch (role) {
    case Qt::DisplayRole:
      return index.column() == 0 ? text(index) : content(index);
    case Qt::ToolTipRole:
      return text(index);
    case Qt::TextAlignmentRole:
      return index.column() == 1 ? QVariant(int(Qt::AlignRight | Qt::AlignVCenter)) : QVariant();
    case KindRole:
      return static_cast<int>(kind(index));
    case JointRole:
      return static_cast<int>(joint(index));
    case RowRole:
      return index.row();
    case FilledRole:
      return !content(index).isEmpty();
    default:
      return {};
  }
}

QVariant ComponentTreeModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  return section == 0 ? tr("Error") : tr("Values");
}

}  // namespace nineline::models
