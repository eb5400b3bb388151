#pragma once

#include <QWidget>

#include "ui/models/workspace.h"

class QComboBox;

namespace nineline::views {
class ChartView;
}

namespace nineline::pages {

/// What one instrument read against what the model predicts: residuals before and after, over a column of its
/// file, with the repeatability as a band and the place of the gap shaded.
class GapChart : public QWidget {
  Q_OBJECT

 public:
  explicit GapChart(QWidget* parent = nullptr);
  /// `workspace` must outlive the chart; its readings are those that `gap` was found in.
  void show(const models::Workspace& workspace);
  void savePicture(const QString& path) const;

 signals:
  void pictureWanted();

 private:
  struct Plot;
  void refillColumns();
  void draw();
  [[nodiscard]] const measurement::Measurement* measurement() const;
  const models::Workspace* workspace_ = nullptr;
  QComboBox* file_;
  QComboBox* channel_;
  QComboBox* over_;
  views::ChartView* chart_;
};

}  // namespace nineline::pages
