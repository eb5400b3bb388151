#pragma once

#include <QScrollArea>
#include <optional>

#include "core/kinematics/machine.h"

class QFormLayout;

namespace nineline::pages {

/// A slider and a number for each axis of a machine.
class AxisPanel : public QScrollArea {
  Q_OBJECT

 public:
  explicit AxisPanel(QWidget* parent = nullptr);
  void setMachine(const kinematics::Machine& machine);

 signals:
  void moved(const nineline::kinematics::JointPositions& q);

 private:
  void addAxis(QFormLayout* form, int joint);
  std::optional<kinematics::Machine> machine_;
  kinematics::JointPositions q_{};
};

}  // namespace nineline::pages
