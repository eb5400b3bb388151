#pragma once

#include <QWidget>
#include <optional>

#include "core/kinematics/machine.h"
#include "ui/jobs/compensation_job.h"

class QComboBox;

namespace nineline::views {
class ChartView;
}

namespace nineline::pages {

/// The error of one axis before and after, over path length, time or the axis position.
class ErrorCurves : public QWidget {
  Q_OBJECT

 public:
  explicit ErrorCurves(QWidget* parent = nullptr);
  void setOutcome(const kinematics::Machine& machine, const jobs::OutcomePtr& outcome);
  void savePicture(const QString& path) const;

 signals:
  void pictureWanted();

 private:
  void draw();
  QComboBox* axis_;
  QComboBox* over_;
  views::ChartView* chart_;
  std::optional<kinematics::Machine> machine_;
  jobs::OutcomePtr outcome_;
};

}  // namespace nineline::pages
