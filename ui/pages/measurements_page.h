#pragma once

#include "ui/models/component_tree_model.h"
#include "ui/pages/page.h"

class QStackedWidget;
class QTreeView;
class QLabel;

namespace nineline::pages {

class EffectsEditor;
class LocationEditor;
class TableEditor;

/// What was measured: for each axis the error tables, squareness and place, and other effects.
class MeasurementsPage : public Page {
  Q_OBJECT

 public:
  explicit MeasurementsPage(Context context, QWidget* parent = nullptr);

 private:
  QWidget* makeTree();
  QWidget* makeReadings();
  void refreshMachine();
  void refreshEffects();
  void choose(const QModelIndex& index);
  void openModel();
  void saveModel();
  void replaceEffects(const QString& text, Json effects, const QString& key = {});
  [[nodiscard]] const kinematics::Machine* machine() const;

  models::ComponentTreeModel* tree_model_;
  QTreeView* tree_;
  QStackedWidget* editors_;
  TableEditor* table_;
  LocationEditor* location_;
  EffectsEditor* effects_;
  QLabel* fault_;
};

}  // namespace nineline::pages
