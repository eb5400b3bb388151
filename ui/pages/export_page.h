#pragma once

#include "ui/pages/page.h"

class QLabel;
class QPushButton;
class QTableView;

namespace nineline::models {
class DifferenceModel;
}

namespace nineline::pages {

/// The corrected program beside the original one, and saving it.
class ExportPage : public Page {
  Q_OBJECT

 public:
  explicit ExportPage(Context context, QWidget* parent = nullptr);

 private:
  void refresh();
  void refreshNote();
  void save();
  void goToChange();

  models::DifferenceModel* model_;
  QTableView* table_;
  QPushButton* save_;
  QPushButton* next_;
  QLabel* note_;
};

}  // namespace nineline::pages
