#pragma once

#include <QWidget>
#include <optional>

#include "core/base/json.h"
#include "core/errors/component.h"
#include "core/kinematics/machine.h"

class QComboBox;
class QCheckBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace nineline::models {
class ErrorTableModel;
}
namespace nineline::views {
class ChartView;
}
namespace nineline::widgets {
class CellTable;
class NumberEdit;
}  // namespace nineline::widgets

namespace nineline::pages {

/// One error table: start, spacing, count, interpolation, the values, and the curve beside them.
class TableEditor : public QWidget {
  Q_OBJECT

 public:
  explicit TableEditor(QWidget* parent = nullptr);
  void show(const kinematics::Machine& machine, const errors::Component& component, const Json& effects);
  /// Takes values from a CSV or text file; an empty path is nothing.
  void loadFile(const QString& path);

 signals:
  void effectsEdited(const QString& text, const nineline::Json& effects, const QString& key);
  void fileWanted();

 private:
  QWidget* makeGridFields();
  QWidget* makeTable();
  void takeEntry(const Json& entry, const QString& text, const QString& key = {});
  void takeMember(const char* which, const Json& value);
  void takeCount(int count);
  void takeInterpolation();
  void paste(const QString& text, int row);
  void showGrid();
  void drawCurve();

  std::optional<kinematics::Machine> machine_;
  std::optional<errors::Component> component_;
  Json effects_;
  models::ErrorTableModel* model_;
  widgets::CellTable* table_;
  views::ChartView* chart_;
  QLabel *title_, *start_unit_, *spacing_unit_, *note_;
  widgets::NumberEdit *start_, *spacing_;
  QSpinBox* count_;
  QComboBox* interpolation_;
  QComboBox* frame_;
  QPushButton* remove_;
};

}  // namespace nineline::pages
