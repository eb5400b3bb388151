#include "ui/models/summary_model.h"

#include <cmath>

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/compensation/compensation.h"

namespace nineline::models {

namespace {

enum Column { Name, MeanBefore, MeanAfter, RmsBefore, RmsAfter, MaxBefore, MaxAfter, Reduction, ColumnCount };

constexpr double kThousandth = 5e-4;

}  // namespace

QString shownFigure(double value, bool angular) {
  const double shown = angular ? arcsecFromRad(value) : umFromMm(value);
  const double size = std::abs(shown);
  if (size < kThousandth) return QStringLiteral("0.000");
  const int decimals = size < 10.0 ? 3 : (size < 100.0 ? 2 : 1);
  return QString::number(shown, 'f', decimals);
}

SummaryModel::SummaryModel(QObject* parent) : QAbstractTableModel(parent) {}

void SummaryModel::setSummaries(const kinematics::Machine& machine,
                                const simulation::DeviationSummary& before,
                                const simulation::DeviationSummary& after) {
  beginResetModel();
  rows_.clear();
  for (int joint = 0; joint < machine.jointCount(); ++joint) {
    const auto j = static_cast<std::size_t>(joint);
    if (j >= before.joints.size() || j >= after.joints.size()) break;
    const QString axis = QString::fromStdString(machine.joint(joint).axis.text());
    const bool rotary = machine.isRotary(joint);
    rows_.push_back({tr("Axis %1, %2").arg(axis, rotary ? QStringLiteral("″") : QStringLiteral("µm")), rotary,
                     before.joints[j], after.joints[j]});
  }
  rows_.push_back({tr("Tool tip x, µm"), false, before.x, after.x});
  rows_.push_back({tr("Tool tip y, µm"), false, before.y, after.y});
  rows_.push_back({tr("Tool tip z, µm"), false, before.z, after.z});
  rows_.push_back({tr("Tool tip distance, µm"), false, before.norm, after.norm});
  rows_.push_back({tr("Tool axis, ″"), true, before.axis_tilt, after.axis_tilt});
  endResetModel();
}

void SummaryModel::clear() {
  beginResetModel();
  rows_.clear();
  endResetModel();
}

int SummaryModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int SummaryModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : ColumnCount; }

QString SummaryModel::value(const Row& row, int column) const {
  switch (column) {
    case Name:
      return row.name;
    case MeanBefore:
      return shownFigure(row.before.mean, row.angular);
    case MeanAfter:
      return shownFigure(row.after.mean, row.angular);
    case RmsBefore:
      return shownFigure(row.before.rms, row.angular);
    case RmsAfter:
      return shownFigure(row.after.rms, row.angular);
    case MaxBefore:
      return shownFigure(row.before.max, row.angular);
    case MaxAfter:
      return shownFigure(row.after.max, row.angular);
    case Reduction:
      if (row.before.rms < kNanometre * kThousandth) return QStringLiteral("–");
      return QStringLiteral("%1 %").arg(
          QString::fromStdString(fixed(compensation::reductionPercent(row.before.rms, row.after.rms), 1)));
    default:
      return {};
  }
}

QVariant SummaryModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  if (role == Qt::DisplayRole) return value(rows_[static_cast<std::size_t>(index.row())], index.column());
  if (role == Qt::TextAlignmentRole && index.column() != Name) return int(Qt::AlignRight | Qt::AlignVCenter);
  return {};
}

QVariant SummaryModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case Name:
      return tr("Error of");
    case MeanBefore:
      return tr("Mean\nbefore");
    case MeanAfter:
      return tr("Mean\nafter");
    case RmsBefore:
      return tr("RMS\nbefore");
    case RmsAfter:
      return tr("RMS\nafter");
    case MaxBefore:
      return tr("Largest\nbefore");
    case MaxAfter:
      return tr("Largest\nafter");
    case Reduction:
      return tr("RMS\nremoved");
    default:
      return {};
  }
}

QString SummaryModel::toCsv() const {
  QString csv;
  const auto quoted = [](QString text) {
    return QLatin1Char('"') + text.replace(QLatin1Char('\n'), QLatin1Char(' ')) + QLatin1Char('"');
  };
  for (int column = 0; column < ColumnCount; ++column) {
    if (column > 0) csv += QLatin1Char(',');
    csv += quoted(headerData(column, Qt::Horizontal, Qt::DisplayRole).toString());
  }
  csv += QLatin1Char('\n');
  for (const Row& row : rows_) {
    for (int column = 0; column < ColumnCount; ++column) {
      if (column > 0) csv += QLatin1Char(',');
      csv += column == Name ? quoted(row.name) : value(row, column);
    }
    csv += QLatin1Char('\n');
  }
  return csv;
}

}  // namespace nineline::models
