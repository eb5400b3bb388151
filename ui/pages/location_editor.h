#pragma once

#include <QWidget>
#include <optional>

#include "core/base/json.h"
#include "core/kinematics/machine.h"

class QLabel;

namespace nineline::models {
class LocationModel;
}

namespace nineline::pages {

/// Squareness and place of one axis.
class LocationEditor : public QWidget {
  Q_OBJECT

 public:
  explicit LocationEditor(QWidget* parent = nullptr);
  void show(const kinematics::Machine& machine, int joint, const Json& effects);

 signals:
  void effectsEdited(const QString& text, const nineline::Json& effects, const QString& key);

 private:
  Json effects_;
  models::LocationModel* model_;
  QLabel* title_;
};

}  // namespace nineline::pages
