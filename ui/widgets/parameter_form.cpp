#include "ui/widgets/parameter_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "ui/widgets/number_edit.h"

namespace nineline::widgets {

namespace {

constexpr int kUnitWidth = 64;
constexpr int kEditorWidth = 84;
constexpr int kChoiceLength = 8;  // characters; longer choices are cut, never the form

void showChoice(QComboBox* box, const Json& value) {
  const QSignalBlocker blocker(box);
  const std::string* text = value.string();
  const int index = text == nullptr ? 0 : box->findData(QString::fromStdString(*text));
  box->setCurrentIndex(index < 0 ? 0 : index);
}

void showText(QLineEdit* edit, const Json& value) {
  const QSignalBlocker blocker(edit);
  const std::string* text = value.string();
  const QString shown = text == nullptr ? QString() : QString::fromStdString(*text);
  if (edit->text() != shown) edit->setText(shown);
}

}  // namespace

ParameterForm::ParameterForm(std::vector<Field> fields, QWidget* parent)
    : QScrollArea(parent), fields_(std::move(fields)) {
  auto* body = new QWidget(this);
  auto* form = new QFormLayout(body);
  form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
  form->setHorizontalSpacing(12);
  form->setVerticalSpacing(6);
  for (const Field& field : fields_) addField(form, field);
  setWidget(body);
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

void ParameterForm::addField(QFormLayout* form, const Field& field) {
  if (field.kind == Field::Kind::Group) {
    auto* title = new QLabel(field.label, this);
    title->setObjectName(QStringLiteral("groupTitle"));
    form->addRow(title);
    return;
  }
  QWidget* editor = makeEditor(field);
  editor->setObjectName(QString::fromStdString(field.key));
  editors_[field.key] = editor;
  if (field.kind == Field::Kind::Flag) {
    form->addRow(editor);
    return;
  }
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(editor, 1);
  auto* unit = new QLabel(field.unit, row);
  unit->setFixedWidth(kUnitWidth);
  layout->addWidget(unit);
  auto* label = new QLabel(field.label, this);
  label->setBuddy(editor);
  label->setToolTip(field.hint);
  form->addRow(label, row);
}

QWidget* ParameterForm::makeEditor(const Field& field) {
  const QString key = QString::fromStdString(field.key);
  switch (field.kind) {
    case Field::Kind::Flag: {
      auto* box = new QCheckBox(field.label, this);
      box->setToolTip(field.hint);
      connect(box, &QCheckBox::toggled, this, [this, key](bool on) { emit edited(key, Json(on)); });
      return box;
    }
    case Field::Kind::Choices: {
      auto* box = new QComboBox(this);
      box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
      box->setMinimumContentsLength(kChoiceLength);
      for (const Choice& choice : field.choices) {
        box->addItem(choice.label, QString::fromStdString(choice.value));
      }
      connect(box, qOverload<int>(&QComboBox::currentIndexChanged), this, [this, key, box](int index) {
        emit edited(key, Json(box->itemData(index).toString().toStdString()));
      });
      return box;
    }
    case Field::Kind::Text: {
      auto* edit = new QLineEdit(this);
      connect(edit, &QLineEdit::editingFinished, this,
              [this, key, edit]() { emit edited(key, Json(edit->text().toStdString())); });
      return edit;
    }
    default: {
      auto* edit = new NumberEdit(this);
      edit->setMinimumWidth(kEditorWidth);
      edit->setOptional(!field.absent.isEmpty());
      edit->setPlaceholderText(field.absent);
      connect(edit, &NumberEdit::edited, this, [this, key](const Json& cell) { emit edited(key, cell); });
      return edit;
    }
  }
}

void ParameterForm::setValues(const Json& object) {
  for (const Field& field : fields_) {
    const auto found = editors_.find(field.key);
    if (found == editors_.end()) continue;
    const Json* member = object.find(field.key);
    const Json& value = member != nullptr ? *member : field.otherwise;
    if (auto* number = qobject_cast<NumberEdit*>(found->second)) {
      number->setCell(value);
    } else if (auto* box = qobject_cast<QCheckBox*>(found->second)) {
      const QSignalBlocker blocker(box);
      box->setChecked(value.boolean() != nullptr && *value.boolean());
    } else if (auto* choices = qobject_cast<QComboBox*>(found->second)) {
      showChoice(choices, value);
    } else if (auto* edit = qobject_cast<QLineEdit*>(found->second)) {
      showText(edit, value);
    }
  }
}

void ParameterForm::setFaults(const std::map<std::string, QString>& faults) {
  for (const auto& [key, editor] : editors_) {
    auto* number = qobject_cast<NumberEdit*>(editor);
    if (number == nullptr) continue;
    const auto found = faults.find(key);
    number->setFault(found != faults.end() ? found->second : QString());
  }
}

}  // namespace nineline::widgets
