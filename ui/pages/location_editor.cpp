#include "ui/pages/location_editor.h"

#include <QHeaderView>
#include <QLabel>
#include <QVBoxLayout>

#include "ui/models/effect_entries.h"
#include "ui/models/location_model.h"
#include "ui/widgets/cell_table.h"

namespace nineline::pages {

namespace {
constexpr int kValueWidth = 150;
}

LocationEditor::LocationEditor(QWidget* parent) : QWidget(parent), model_(new models::LocationModel(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 0, 0, 0);
  title_ = new QLabel(this);
  title_->setObjectName(QStringLiteral("editorTitle"));
  layout->addWidget(title_);
  auto* hint = new QLabel(tr("Constants of where the axis stands and how it is turned. Leave empty what was "
                             "not measured; C0Y turns the direction of Y about Z."),
                          this);
  hint->setWordWrap(true);
  layout->addWidget(hint);
  auto* table = new widgets::CellTable(this);
  table->setObjectName(QStringLiteral("locationTable"));
  table->setModel(model_);
  table->horizontalHeader()->setStretchLastSection(false);
  table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  table->setColumnWidth(1, kValueWidth);
  table->verticalHeader()->hide();
  layout->addWidget(table, 1);
  connect(model_, &models::LocationModel::valueEdited, this,
          [this](const errors::Component& component, const Json& value) {
            emit effectsEdited(tr("Change %1").arg(QString::fromStdString(component.text())),
                               models::withLocation(effects_, component, value), {});
          });
  connect(table, &widgets::CellTable::cleared, this, [this](int first, int last) {
    Json effects = effects_;
    for (int row = first; row <= last; ++row) {
      effects = models::withLocation(std::move(effects), model_->component(row), Json());
    }
    emit effectsEdited(tr("Clear values"), effects, {});
  });
}

void LocationEditor::show(const kinematics::Machine& machine, int joint, const Json& effects) {
  effects_ = effects;
  title_->setText(
      tr("Squareness and place of axis %1").arg(QString::fromStdString(machine.joint(joint).axis.text())));
  model_->setEffects(machine, joint, effects);
}

}  // namespace nineline::pages
