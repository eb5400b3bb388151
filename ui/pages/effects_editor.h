#pragma once

#include <QWidget>
#include <optional>

#include "core/base/json.h"
#include "core/kinematics/machine.h"

class QListWidget;
class QMenu;
class QVBoxLayout;

namespace nineline::widgets {
class ParameterForm;
}

namespace nineline::pages {

/// Effects beyond tables: scale, backlash, cyclic errors, thermal growth of a screw.
class EffectsEditor : public QWidget {
  Q_OBJECT

 public:
  explicit EffectsEditor(QWidget* parent = nullptr);
  void show(const kinematics::Machine& machine, const Json& effects);

 signals:
  void effectsEdited(const QString& text, const nineline::Json& effects, const QString& key);

 private:
  void fillAddMenu(QMenu* menu);
  void add(const std::string& id, int joint);
  void remove();
  void showForm();
  void makeForm(const Json& entry);
  [[nodiscard]] std::optional<std::size_t> current() const;

  std::optional<kinematics::Machine> machine_;
  Json effects_;
  QListWidget* list_;
  QVBoxLayout* form_place_;
  widgets::ParameterForm* form_ = nullptr;
  std::string form_for_;  ///< effect and joint that the form was made for
};

}  // namespace nineline::pages
