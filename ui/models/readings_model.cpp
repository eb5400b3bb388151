#include "ui/models/readings_model.h"

#include <algorithm>

#include "ui/models/messages.h"

namespace nineline::models {

namespace {

enum Column { Name, Instrument, Axis, Runs, Readings, State, kColumns };

}  // namespace

QString instrumentName(measurement::InstrumentKind kind) {
  using measurement::InstrumentKind;
  switch (kind) {
    case InstrumentKind::Deviation:
      return ReadingsModel::tr("tool deviation");
    case InstrumentKind::Joint:
      return ReadingsModel::tr("encoder on one axis");
    case InstrumentKind::LaserLinear:
      return ReadingsModel::tr("laser, positioning");
    case InstrumentKind::LaserStraightness:
      return ReadingsModel::tr("laser, straightness");
    case InstrumentKind::LaserAngular:
      return ReadingsModel::tr("laser, angle");
    case InstrumentKind::Ballbar:
      return ReadingsModel::tr("ballbar");
    case InstrumentKind::Lead:
      return ReadingsModel::tr("lead tester");
    case InstrumentKind::Dial:
      return ReadingsModel::tr("dial gauge");
  }
  return {};
}

ReadingsModel::ReadingsModel(const Workspace& workspace, QObject* parent)
    : QAbstractTableModel(parent), workspace_(workspace) {
  connect(&workspace, &Workspace::readingsChanged, this, [this]() {
    beginResetModel();
    endResetModel();
  });
}

int ReadingsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(workspace_.readings().size());
}

int ReadingsModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant ReadingsModel::text(const LoadedReadings& readings, int column) const {
  const measurement::Measurement& measurement = readings.measurement;
  switch (column) {
    case Name:
      return QString::fromStdString(readings.name);
    case Instrument:
      return readings.isUsable() ? instrumentName(measurement.instrument.kind) : QString();
    case Axis:
      return measurement.instrument.axis ? QString::fromStdString(measurement.instrument.axis->text())
                                         : QString::fromStdString(measurement.instrument.plane);
    case Runs:
      return readings.isUsable() ? QString::number(measurement::runsOf(measurement).size()) : QString();
    case Readings:
      return QString::number(std::count_if(measurement.readings.begin(), measurement.readings.end(),
                                           [](const auto& reading) { return reading.has_value(); }));
    case State:
      if (!readings.isUsable()) return tr("cannot be used");
      return readings.diagnostics.all().empty() ? tr("ready")
                                                : tr("notes: %1").arg(readings.diagnostics.all().size());
    default:
      return {};
  }
}

QVariant ReadingsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const LoadedReadings& readings = workspace_.readings()[static_cast<std::size_t>(index.row())];
  if (role == Qt::DisplayRole) return text(readings, index.column());
  if (role == Qt::ToolTipRole) {
    QStringList lines;
    for (const Diagnostic& diagnostic : readings.diagnostics.all()) lines << messageOf(diagnostic);
    return lines.mid(0, 10).join(QLatin1Char('\n'));
  }
  return {};
}

QVariant ReadingsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case Name:
      return tr("File");
    case Instrument:
      return tr("Instrument");
    case Axis:
      return tr("Axis");
    case Runs:
      return tr("Runs");
    case Readings:
      return tr("Readings");
    case State:
      return tr("State");
    default:
      return {};
  }
}

}  // namespace nineline::models
