#include "ui/pages/setup_editor.h"

#include <QVBoxLayout>
#include <set>

#include "ui/models/component_names.h"
#include "ui/pages/option_fields.h"
#include "ui/widgets/parameter_form.h"

namespace nineline::pages {

namespace {

using widgets::Field;

constexpr int kToolRows = 4;
constexpr const char* kOffset = "G54";

/// A value two levels down: "work_offsets/G54/X".
Json at(const Json& object, const QStringList& path) {
  const Json* found = &object;
  for (const QString& key : path) {
    found = found->members() != nullptr ? found->find(key.toStdString()) : nullptr;
    if (found == nullptr) return {};
  }
  return *found;
}

Json with(Json object, const QStringList& path, const Json& value) {
  if (object.members() == nullptr) object = Json::object();
  const std::string key = path.front().toStdString();
  if (path.size() == 1) {
    object.set(key, value);
    return object;
  }
  const Json* inner = object.find(key);
  object.set(key, with(inner != nullptr ? *inner : Json::object(), path.mid(1), value));
  return object;
}

Field group(const QString& label) {
  Field field;
  field.kind = Field::Kind::Group;
  field.label = label;
  return field;
}

Field number(const std::string& key, const QString& label, const QString& unit, const QString& absent) {
  Field field;
  field.key = key;
  field.label = label;
  field.unit = unit;
  field.absent = absent;
  return field;
}

/// The unit that a condition's name ends in: "temp_screw_Z_C" → "°C".
QString unitOfCondition(const QString& name) {
  if (name.endsWith(QLatin1String("_C"))) return QStringLiteral("°C");
  if (name.endsWith(QLatin1String("_kg"))) return QStringLiteral("kg");
  return {};
}

std::set<std::string> conditionsOf(const models::Workspace& workspace) {
  std::set<std::string> names;
  if (workspace.model()) {
    for (const auto& effect : workspace.model()->effects()) {
      for (const std::string& name : effect->needs()) names.insert(name);
    }
  }
  return names;
}

}  // namespace

SetupEditor::SetupEditor(const models::Workspace& workspace, QWidget* parent)
    : QWidget(parent), workspace_(workspace), layout_(new QVBoxLayout(this)) {
  layout_->setContentsMargins(0, 0, 0, 0);
  connect(&workspace, &models::Workspace::changed, this, [this]() {
    if (shape() != shape_) rebuild();
    fill();
  });
  rebuild();
  fill();
}

std::string SetupEditor::shape() const {
  std::string text = workspace_.machine() ? workspace_.document().machine_text : std::string();
  for (const std::string& name : conditionsOf(workspace_)) text += "|" + name;
  return text;
}

void SetupEditor::rebuild() {
  shape_ = shape();
  if (form_ != nullptr) form_->deleteLater();
  std::vector<Field> fields;
  const std::set<std::string> conditions = conditionsOf(workspace_);
  if (!conditions.empty()) {
    fields.push_back(group(tr("State of the machine")));
    for (const std::string& name : conditions) {
      const QString shown = QString::fromStdString(name);
      fields.push_back(number("conditions/" + name, shown, unitOfCondition(shown), {}));
    }
  }
  fields.push_back(group(tr("Control")));
  for (Field& field : controlFields()) fields.push_back(std::move(field));
  if (workspace_.machine()) {
    const kinematics::Machine& machine = *workspace_.machine();
    const auto addAxes = [&](const QString& title, const std::string& prefix) {
      fields.push_back(group(title));
      for (int joint = 0; joint < machine.jointCount(); ++joint) {
        const std::string axis = machine.joint(joint).axis.text();
        fields.push_back(number(prefix + axis, QString::fromStdString(axis),
                                models::positionUnitOf(machine, joint), QStringLiteral("0")));
      }
    };
    addAxes(tr("Work offset %1").arg(QLatin1String(kOffset)), std::string("work_offsets/") + kOffset + "/");
    addAxes(tr("Position before the first block"), "start/");
  }
  fields.push_back(group(tr("Tool lengths")));
  for (int tool = 1; tool <= kToolRows; ++tool) {
    fields.push_back(number("tool_lengths/" + std::to_string(tool), QStringLiteral("H%1").arg(tool),
                            QStringLiteral("mm"), tr("none")));
  }
  form_ = new widgets::ParameterForm(std::move(fields), this);
  connect(form_, &widgets::ParameterForm::edited, this, &SetupEditor::take);
  layout_->addWidget(form_);
}

void SetupEditor::fill() {
  Json values = Json::object();
  for (const Field& field : form_->fields()) {
    if (field.kind == Field::Kind::Group) continue;
    const QStringList path = QString::fromStdString(field.key).split(QLatin1Char('/'));
    const Json value = at(workspace_.document().setup, path);
    if (!value.isNull()) values.set(field.key, value);
  }
  form_->setValues(values);
}

void SetupEditor::take(const QString& key, const Json& value) {
  emit setupEdited(with(workspace_.document().setup, key.split(QLatin1Char('/')), value));
}

}  // namespace nineline::pages
