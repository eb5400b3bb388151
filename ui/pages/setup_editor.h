#pragma once

#include <QWidget>

#include "ui/models/workspace.h"

class QVBoxLayout;

namespace nineline::widgets {
class ParameterForm;
}

namespace nineline::pages {

/// What the control and the shop floor know: dialect, start position, work offset, tool lengths, and the
/// temperatures that the model needs.
class SetupEditor : public QWidget {
  Q_OBJECT

 public:
  explicit SetupEditor(const models::Workspace& workspace, QWidget* parent = nullptr);

 signals:
  void setupEdited(const nineline::Json& setup);

 private:
  void rebuild();
  void fill();
  void take(const QString& key, const Json& value);
  [[nodiscard]] std::string shape() const;
  const models::Workspace& workspace_;
  QVBoxLayout* layout_;
  widgets::ParameterForm* form_ = nullptr;
  std::string shape_;
};

}  // namespace nineline::pages
