#include "ui/pages/measurements_page.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTreeView>
#include <QVBoxLayout>

#include "core/base/file.h"
#include "core/errors/error_model_file.h"
#include "core/kinematics/machine_file.h"
#include "ui/models/effect_entries.h"
#include "ui/pages/effects_editor.h"
#include "ui/pages/location_editor.h"
#include "ui/pages/readings_panel.h"
#include "ui/pages/table_editor.h"

namespace nineline::pages {

using models::ComponentTreeModel;

MeasurementsPage::MeasurementsPage(Context context, QWidget* parent)
    : Page(context,
           tr("Type, paste or load the measured errors of each axis. Deviations are actual minus ideal."),
           parent),
      tree_model_(new ComponentTreeModel(this)),
      fault_(new QLabel(this)) {
  auto* layout = new QVBoxLayout(body());
  layout->setContentsMargins(0, 0, 0, 0);
  auto* tabs = new QTabWidget(body());
  tabs->setObjectName(QStringLiteral("measurementTabs"));
  auto* splitter = new QSplitter(tabs);
  splitter->addWidget(makeTree());
  editors_ = new QStackedWidget(splitter);
  editors_->addWidget(table_ = new TableEditor(this));
  editors_->addWidget(location_ = new LocationEditor(this));
  editors_->addWidget(effects_ = new EffectsEditor(this));
  splitter->addWidget(editors_);
  splitter->setStretchFactor(1, 1);
  splitter->setSizes({390, 860});
  tabs->addTab(splitter, tr("Errors"));
  tabs->addTab(makeReadings(), tr("Readings"));
  layout->addWidget(tabs, 1);
  fault_->setObjectName(QStringLiteral("fault"));
  fault_->setWordWrap(true);
  layout->addWidget(fault_);
  connect(table_, &TableEditor::effectsEdited, this, &MeasurementsPage::replaceEffects);
  connect(location_, &LocationEditor::effectsEdited, this, &MeasurementsPage::replaceEffects);
  connect(effects_, &EffectsEditor::effectsEdited, this, &MeasurementsPage::replaceEffects);
  connect(table_, &TableEditor::fileWanted, this, [this]() {
    table_->loadFile(askOpen(tr("Load error values"), tr("Tables (*.csv *.txt *.tsv);;All files (*)")));
  });
  connect(&workspace(), &models::Workspace::machineChanged, this, &MeasurementsPage::refreshMachine);
  connect(&workspace(), &models::Workspace::effectsChanged, this, &MeasurementsPage::refreshEffects);
  refreshMachine();
}

QWidget* MeasurementsPage::makeReadings() {
  auto* panel = new ReadingsPanel(workspace(), this);
  connect(panel, &ReadingsPanel::readingsEdited, this, [this](const QString& text, const auto& readings) {
    models::Document next = document();
    next.readings = readings;
    edit(text, std::move(next));
  });
  connect(panel, &ReadingsPanel::failed, this,
          [this](const Error& error) { showError(tr("Readings"), error); });
  return panel;
}

QWidget* MeasurementsPage::makeTree() {
  auto* panel = new QWidget(this);
  auto* layout = new QVBoxLayout(panel);
  layout->setContentsMargins(0, 0, 0, 0);
  tree_ = new QTreeView(panel);
  tree_->setObjectName(QStringLiteral("componentTree"));
  tree_->setModel(tree_model_);
  tree_->header()->setStretchLastSection(false);
  tree_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  tree_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  tree_->setExpandsOnDoubleClick(false);
  tree_->setIndentation(16);
  connect(tree_->selectionModel(), &QItemSelectionModel::currentChanged, this, &MeasurementsPage::choose);
  layout->addWidget(tree_, 1);
  auto* row = new QHBoxLayout;
  auto* open = new QPushButton(tr("Open model…"), panel);
  auto* save = new QPushButton(tr("Save model…"), panel);
  connect(open, &QPushButton::clicked, this, &MeasurementsPage::openModel);
  connect(save, &QPushButton::clicked, this, &MeasurementsPage::saveModel);
  row->addWidget(open);
  row->addWidget(save);
  layout->addLayout(row);
  return panel;
}

const kinematics::Machine* MeasurementsPage::machine() const {
  return workspace().machine() ? &workspace().machine().value() : nullptr;
}

void MeasurementsPage::refreshMachine() {
  tree_model_->setMachine(machine());
  tree_->expandAll();
  refreshEffects();
  if (machine() != nullptr) {
    const QModelIndex first = tree_model_->index(0, 0);
    for (int row = 0; row < tree_model_->rowCount(first); ++row) {
      const QModelIndex child = tree_model_->index(row, 0, first);
      const auto component = tree_model_->component(child);
      const bool positioning = component && component->row % 3 == 2 && !component->isAngular();
      if (positioning || row == 0) tree_->setCurrentIndex(child);
    }
  }
}

void MeasurementsPage::refreshEffects() {
  if (machine() == nullptr) return;
  tree_model_->setEffects(document().effects);
  choose(tree_->currentIndex());
  const bool faulty = workspace().state(models::Step::Measurements) == models::StepState::Faulty;
  fault_->setVisible(faulty);
  if (faulty) fault_->setText(workspace().explanation(models::Step::Measurements));
}

void MeasurementsPage::choose(const QModelIndex& index) {
  if (!index.isValid() || machine() == nullptr) return;
  const auto kind = static_cast<ComponentTreeModel::Kind>(index.data(ComponentTreeModel::KindRole).toInt());
  const int joint = index.data(ComponentTreeModel::JointRole).toInt();
  switch (kind) {
    case ComponentTreeModel::Kind::Component:
      table_->show(*machine(), *tree_model_->component(index), document().effects);
      editors_->setCurrentWidget(table_);
      break;
    case ComponentTreeModel::Kind::Axis:
    case ComponentTreeModel::Kind::Location:
      location_->show(*machine(), joint, document().effects);
      editors_->setCurrentWidget(location_);
      break;
    case ComponentTreeModel::Kind::OtherEffects:
      effects_->show(*machine(), document().effects);
      editors_->setCurrentWidget(effects_);
      break;
  }
}

void MeasurementsPage::replaceEffects(const QString& text, Json effects, const QString& key) {
  models::Document next = document();
  next.effects = std::move(effects);
  edit(text, std::move(next), key);
}

void MeasurementsPage::openModel() {
  const QString path = askOpen(tr("Open error model"), tr("Error models (*.json);;All files (*)"));
  if (path.isEmpty()) return;
  const Result<errors::ErrorModel> model = errors::loadErrorModel(path.toStdString());
  if (!model) return showError(tr("Error model"), model.error());
  const Json json = errors::errorModelToJson(*model);
  models::Document next = document();
  next.machine_text = writeJson(kinematics::machineToJson(model->machine()));
  next.effects = *json.find("effects");
  edit(tr("Open error model"), std::move(next));
}

void MeasurementsPage::saveModel() {
  const auto& model = workspace().model();
  if (!model) return showError(tr("Error model"), model.error());
  const QString path = askSave(tr("Save error model"), QStringLiteral("model.json"),
                               tr("Error models (*.json);;All files (*)"));
  if (path.isEmpty()) return;
  const Result<void> written =
      writeFile(path.toStdString(), writeJson(errors::errorModelToJson(*model)) + "\n");
  if (!written) showError(tr("Error model"), written.error());
}

}  // namespace nineline::pages
