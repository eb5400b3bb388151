#pragma once

#include <QWidget>
#include <optional>

#include "core/kinematics/machine.h"
#include "ui/jobs/compensation_job.h"

class QComboBox;
class QLabel;

namespace nineline::views {
class PathView;
}

namespace nineline::pages {

/// The 3D view of a result: which paths, how much the deviation is magnified, where the camera stands, and
/// what lies at the place that was clicked.
class PathPanel : public QWidget {
  Q_OBJECT

 public:
  explicit PathPanel(QWidget* parent = nullptr);
  void setOutcome(const kinematics::Machine& machine, const jobs::OutcomePtr& outcome);
  void savePicture(const QString& path) const;

 signals:
  void pictureWanted();

 private:
  QWidget* makeControls();
  void applyShown();
  void showPicked(const simulation::PathSample* before, const simulation::PathSample* after);
  views::PathView* view_;
  QComboBox* shown_;
  QComboBox* magnification_;
  QLabel* picked_;
  std::optional<kinematics::Machine> machine_;
};

}  // namespace nineline::pages
