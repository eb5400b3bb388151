#include "ui/models/quantities.h"

#include <QCoreApplication>
#include <cmath>

#include "core/base/units.h"
#include "ui/models/summary_model.h"

namespace nineline::models {

namespace {

constexpr double kMetre = 1000.0;
constexpr double kMinute = 60.0;
constexpr double kHour = 3600.0;

}  // namespace

QString lengthText(double length) {
  if (length >= 10.0 * kMetre) return QStringLiteral("%1 m").arg(length / kMetre, 0, 'f', 1);
  return QStringLiteral("%1 mm").arg(length, 0, 'f', 1);
}

QString timeText(double seconds) {
  if (seconds < kMinute) {
    return QCoreApplication::translate("quantities", "%1 s").arg(seconds, 0, 'f', seconds < 10.0 ? 1 : 0);
  }
  if (seconds < kHour) {
    const double minutes = std::floor(seconds / kMinute);
    return QCoreApplication::translate("quantities", "%1 min %2 s")
        .arg(minutes, 0, 'f', 0)
        .arg(seconds - minutes * kMinute, 0, 'f', 0);
  }
  const double hours = std::floor(seconds / kHour);
  return QCoreApplication::translate("quantities", "%1 h %2 min")
      .arg(hours, 0, 'f', 0)
      .arg((seconds - hours * kHour) / kMinute, 0, 'f', 0);
}

QString commandText(const kinematics::Machine& machine, const kinematics::JointPositions& q) {
  QString text;
  for (int joint = 0; joint < machine.jointCount(); ++joint) {
    const double value = q[static_cast<std::size_t>(joint)];
    if (joint > 0) text += QStringLiteral("   ");
    text += QStringLiteral("%1 %2").arg(
        QString::fromStdString(machine.joint(joint).axis.text()),
        QString::number(machine.isRotary(joint) ? degFromRad(value) : value, 'f', 4));
    text += machine.isRotary(joint) ? QStringLiteral("°") : QString();
  }
  return text;
}

QString deviationText(double value, bool angular) {
  const QString unit = angular ? QStringLiteral("″") : QStringLiteral(" µm");
  return (value < 0.0 ? QStringLiteral("−") : QStringLiteral("+")) + shownFigure(std::abs(value), angular) +
         unit;
}

}  // namespace nineline::models
