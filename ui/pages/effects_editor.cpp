#include "ui/pages/effects_editor.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QVBoxLayout>
#include <array>

#include "ui/models/component_names.h"
#include "ui/models/effect_entries.h"
#include "ui/widgets/parameter_form.h"

namespace nineline::pages {

namespace {

using widgets::Field;

std::string textOf(const Json& entry, const char* key) {
  const Json* found = entry.find(key);
  return found != nullptr && found->string() != nullptr ? *found->string() : std::string();
}

constexpr std::array kEffects = {"scale", "backlash", "cyclic", "thermal_screw"};

Field number(const std::string& effect, const char* key, const QString& unit) {
  Field field;
  field.key = key;
  field.label = models::parameterName(effect, key);
  field.unit = unit;
  return field;
}

std::vector<Field> fieldsOf(const std::string& effect, bool rotary) {
  const QString size = rotary ? QStringLiteral("″") : QStringLiteral("µm");
  const QString position = rotary ? QStringLiteral("°") : QStringLiteral("mm");
  if (effect == "scale") return {number(effect, "k", QStringLiteral("µm/m"))};
  if (effect == "backlash") return {number(effect, "width", size)};
  if (effect == "cyclic") {
    return {number(effect, "amplitude", size), number(effect, "period", position),
            number(effect, "phase", QStringLiteral("°"))};
  }
  if (effect == "thermal_screw") {
    return {number(effect, "k", QStringLiteral("µm/(m·°C)")), number(effect, "q_fixed", position)};
  }
  return {};
}

}  // namespace

EffectsEditor::EffectsEditor(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 0, 0, 0);
  auto* title = new QLabel(tr("Other effects"), this);
  title->setObjectName(QStringLiteral("editorTitle"));
  layout->addWidget(title);
  auto* hint = new QLabel(tr("Effects with a few parameters that act beside the tables."), this);
  hint->setWordWrap(true);
  layout->addWidget(hint);
  auto* row = new QHBoxLayout;
  layout->addLayout(row, 1);
  auto* left = new QVBoxLayout;
  row->addLayout(left, 1);
  list_ = new QListWidget(this);
  list_->setObjectName(QStringLiteral("effectList"));
  left->addWidget(list_, 1);
  auto* add_button = new QPushButton(tr("Add effect"), this);
  auto* menu = new QMenu(add_button);
  add_button->setMenu(menu);
  connect(menu, &QMenu::aboutToShow, this, [this, menu]() { fillAddMenu(menu); });
  auto* remove_button = new QPushButton(tr("Remove effect"), this);
  connect(remove_button, &QPushButton::clicked, this, &EffectsEditor::remove);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(add_button);
  buttons->addWidget(remove_button);
  left->addLayout(buttons);
  form_place_ = new QVBoxLayout;
  row->addLayout(form_place_, 1);
  connect(list_, &QListWidget::currentRowChanged, this, &EffectsEditor::showForm);
}

void EffectsEditor::fillAddMenu(QMenu* menu) {
  menu->clear();
  for (const char* id : kEffects) {
    QMenu* of_effect = menu->addMenu(models::effectName(id));
    for (int joint = 0; joint < machine_->jointCount(); ++joint) {
      const QString axis = QString::fromStdString(machine_->joint(joint).axis.text());
      connect(of_effect->addAction(tr("Axis %1").arg(axis)), &QAction::triggered, this,
              [this, id, joint]() { add(id, joint); });
    }
  }
}

void EffectsEditor::show(const kinematics::Machine& machine, const Json& effects) {
  machine_ = machine;
  effects_ = effects;
  const int row = list_->currentRow();
  const QSignalBlocker blocker(list_);
  list_->clear();
  for (const std::size_t index : models::otherEntries(effects_)) {
    const Json& entry = (*effects_.items())[index];
    list_->addItem(QStringLiteral("%1 · %2").arg(models::effectName(textOf(entry, "effect")),
                                                 QString::fromStdString(textOf(entry, "joint"))));
  }
  list_->setCurrentRow(qBound(0, row, list_->count() - 1));
  showForm();
}

std::optional<std::size_t> EffectsEditor::current() const {
  const auto others = models::otherEntries(effects_);
  const int row = list_->currentRow();
  if (row < 0 || static_cast<std::size_t>(row) >= others.size()) return std::nullopt;
  return others[static_cast<std::size_t>(row)];
}

void EffectsEditor::showForm() {
  const auto index = current();
  const std::string wanted = index ? textOf((*effects_.items())[*index], "effect") + " " +
                                         textOf((*effects_.items())[*index], "joint")
                                   : std::string();
  if (form_ != nullptr && wanted != form_for_) {
    form_->deleteLater();
    form_ = nullptr;
  }
  if (!index) return;
  const Json& entry = (*effects_.items())[*index];
  if (form_ == nullptr) makeForm(entry);
  form_for_ = wanted;
  Json values = Json::object();
  for (const Field& field : form_->fields()) values.set(field.key, models::parameterOf(entry, field.key));
  form_->setValues(values);
}

void EffectsEditor::makeForm(const Json& entry) {
  const auto axis = parseAxisId(textOf(entry, "joint"));
  const int joint = axis ? machine_->find(*axis) : -1;
  form_ = new widgets::ParameterForm(
      fieldsOf(textOf(entry, "effect"), joint >= 0 && machine_->isRotary(joint)), this);
  form_place_->addWidget(form_);
  connect(form_, &widgets::ParameterForm::edited, this, [this](const QString& key, const Json& value) {
    const auto at = current();
    if (!at) return;
    const Json changed = models::withParameter((*effects_.items())[*at], key.toStdString(), value);
    emit effectsEdited(tr("Change effect"), models::withEntryAt(effects_, *at, changed), {});
  });
}

void EffectsEditor::add(const std::string& id, int joint) {
  Json effects = effects_;
  effects.push(models::newEffect(id, *machine_, joint));
  list_->setCurrentRow(-1);
  emit effectsEdited(tr("Add effect"), effects, {});
  list_->setCurrentRow(list_->count() - 1);
}

void EffectsEditor::remove() {
  const auto index = current();
  if (index) emit effectsEdited(tr("Remove effect"), models::withoutEntryAt(effects_, *index), {});
}

}  // namespace nineline::pages
