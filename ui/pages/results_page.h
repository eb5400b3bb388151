#pragma once

#include "ui/pages/page.h"

class QComboBox;
class QLabel;

namespace nineline::models {
class SummaryModel;
}
namespace nineline::pages {

class ErrorCurves;
class PathPanel;

/// The path before and after in 3D, the error of each axis as curves, and the figures.
class ResultsPage : public Page {
  Q_OBJECT

 public:
  explicit ResultsPage(Context context, QWidget* parent = nullptr);

 private:
  QWidget* makeFigures();
  QWidget* makePartChooser();
  /// Shows the chosen part of the path in 3D and as curves.
  void showPart();
  void refresh();
  void refreshNote();
  void saveTable();

  PathPanel* path_;
  ErrorCurves* curves_;
  models::SummaryModel* summary_;
  QComboBox* part_;
  QLabel* note_;
};

}  // namespace nineline::pages
