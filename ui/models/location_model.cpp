#include "ui/models/location_model.h"

#include "ui/models/component_names.h"
#include "ui/models/effect_entries.h"
#include "ui/models/spreadsheet.h"

namespace nineline::models {

LocationModel::LocationModel(QObject* parent) : QAbstractTableModel(parent) {}

void LocationModel::setEffects(const kinematics::Machine& machine, int joint, const Json& effects) {
  beginResetModel();
  machine_ = machine;
  components_ = locationComponents(machine.joint(joint).axis);
  values_.clear();
  for (const errors::Component& component : components_) {
    values_.push_back(locationValue(effects, component));
  }
  endResetModel();
}

int LocationModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(components_.size());
}

int LocationModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : 3; }

QVariant LocationModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const auto row = static_cast<std::size_t>(index.row());
  if (index.column() == 0) {
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
    return QStringLiteral("%1  %2").arg(QString::fromStdString(components_[row].text()),
                                        descriptionOf(components_[row], *machine_));
  }
  if (index.column() == 2) return role == Qt::DisplayRole ? unitOf(components_[row]) : QVariant();
  const bool bad = !values_[row].isNull() && values_[row].number() == nullptr;
  switch (role) {
    case Qt::DisplayRole:
      return shownFromCell(values_[row]);
    case Qt::EditRole:
      return typedFromCell(values_[row]);
    case Qt::TextAlignmentRole:
      return int(Qt::AlignRight | Qt::AlignVCenter);
    case Qt::ToolTipRole:
      return bad ? tr("This is no number.") : QString();
    case Qt::UserRole:
      return bad;
    default:
      return {};
  }
}

bool LocationModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || !index.isValid() || index.column() != 1) return false;
  emit valueEdited(components_[static_cast<std::size_t>(index.row())], cellFromTyped(value.toString()));
  return true;
}

Qt::ItemFlags LocationModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return Qt::NoItemFlags;
  const Qt::ItemFlags basic = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren;
  return index.column() == 1 ? basic | Qt::ItemIsEditable : basic;
}

QVariant LocationModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role != Qt::DisplayRole || orientation != Qt::Horizontal) return {};
  if (section == 0) return tr("Location error");
  return section == 1 ? tr("Value") : tr("Unit");
}

}  // namespace nineline::models
