#include "ui/models/found_effects_model.h"

#include <cmath>

#include "ui/models/component_names.h"

namespace nineline::models {

namespace {

enum Column { Name, Axis, Confidence, Share, Size, kColumns };

QString unitText(const std::string& unit) {
  QString text = QString::fromStdString(unit);
  if (text == QLatin1String("1")) return {};
  if (text.startsWith(QLatin1String("um"))) text.replace(0, 2, QStringLiteral("µm"));
  return QLatin1Char(' ') + text.replace(QLatin1String("/C"), QStringLiteral("/°C"));
}

/// As many decimals as the uncertainty has meaning in: two digits of it.
int decimalsFor(const errors::Parameter& parameter) {
  const double scale =
      parameter.sigma && *parameter.sigma > 0.0 ? *parameter.sigma : std::abs(parameter.value) / 50.0;
  if (scale <= 0.0 || !std::isfinite(scale)) return 1;
  return std::clamp(1 - static_cast<int>(std::floor(std::log10(scale))), 0, 4);
}

}  // namespace

QString parametersText(const std::vector<errors::Parameter>& parameters) {
  QStringList parts;
  for (const errors::Parameter& parameter : parameters) {
    const int decimals = decimalsFor(parameter);
    QString part = QString::fromStdString(parameter.name) + QLatin1Char(' ') +
                   QString::number(parameter.value, 'f', decimals);
    if (parameter.sigma) part += QStringLiteral(" ± ") + QString::number(*parameter.sigma, 'f', decimals);
    parts << part + unitText(parameter.unit);
  }
  return parts.join(QStringLiteral(", "));
}

FoundEffectsModel::FoundEffectsModel(QObject* parent) : QAbstractTableModel(parent) {}

void FoundEffectsModel::setEffects(std::vector<discovery::FoundEffect> effects) {
  beginResetModel();
  effects_ = std::move(effects);
  endResetModel();
}

const discovery::FoundEffect* FoundEffectsModel::effect(int row) const {
  return row >= 0 && row < rowCount() ? &effects_[static_cast<std::size_t>(row)] : nullptr;
}

int FoundEffectsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(effects_.size());
}

int FoundEffectsModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : kColumns;
}

QVariant FoundEffectsModel::data(const QModelIndex& index, int role) const {
  const discovery::FoundEffect* found = effect(index.row());
  if (found == nullptr || (role != Qt::DisplayRole && role != Qt::ToolTipRole)) return {};
  switch (index.column()) {
    case Name: {
      const QString name = effectName(found->effect);
      return found->is_measurement ? tr("%1 (of the measurement, not of the machine)").arg(name) : name;
    }
    case Axis:
      return QString::fromStdString(found->joint + " · " + found->component);
    case Size:
      return parametersText(found->parameters);
    case Confidence:
      return QStringLiteral("%1 %").arg(found->confidence * 100.0, 0, 'f', 0);
    case Share:
      return QStringLiteral("%1 %").arg(found->share_pct, 0, 'f', 0);
    default:
      return {};
  }
}

QVariant FoundEffectsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case Name:
      return tr("Missing effect");
    case Axis:
      return tr("Axis and error");
    case Size:
      return tr("Size");
    case Confidence:
      return tr("Confidence");
    case Share:
      return tr("Share of the gap");
    default:
      return {};
  }
}

}  // namespace nineline::models
