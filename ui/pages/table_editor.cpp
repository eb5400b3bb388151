#include "ui/pages/table_editor.h"

#include <QComboBox>
#include <QFile>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QSplitter>
#include <QVBoxLayout>

#include "core/base/file.h"
#include "ui/models/component_names.h"
#include "ui/models/effect_entries.h"
#include "ui/models/error_curve.h"
#include "ui/models/error_table_model.h"
#include "ui/models/messages.h"
#include "ui/models/spreadsheet.h"
#include "ui/views/chart_view.h"
#include "ui/widgets/cell_table.h"
#include "ui/widgets/number_edit.h"

namespace nineline::pages {

TableEditor::TableEditor(QWidget* parent) : QWidget(parent), model_(new models::ErrorTableModel(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 0, 0, 0);
  title_ = new QLabel(this);
  title_->setObjectName(QStringLiteral("editorTitle"));
  layout->addWidget(title_);
  layout->addWidget(makeGridFields());
  auto* splitter = new QSplitter(this);
  splitter->addWidget(makeTable());
  chart_ = new views::ChartView(splitter);
  splitter->addWidget(chart_);
  splitter->setStretchFactor(1, 1);
  splitter->setSizes({310, 540});
  layout->addWidget(splitter, 1);
  note_ = new QLabel(this);
  note_->setObjectName(QStringLiteral("fault"));
  note_->setWordWrap(true);
  note_->hide();
  layout->addWidget(note_);
  connect(model_, &models::ErrorTableModel::entryEdited, this, [this](const Json& entry) {
    takeEntry(entry, tr("Change %1").arg(QString::fromStdString(component_->text())));
  });
}

QWidget* TableEditor::makeGridFields() {
  auto* panel = new QWidget(this);
  auto* grid = new QGridLayout(panel);
  grid->setContentsMargins(0, 0, 0, 0);
  start_ = new widgets::NumberEdit(panel);
  start_->setObjectName(QStringLiteral("tableStart"));
  spacing_ = new widgets::NumberEdit(panel);
  spacing_->setObjectName(QStringLiteral("tableSpacing"));
  count_ = new QSpinBox(panel);
  count_->setObjectName(QStringLiteral("tableCount"));
  count_->setRange(1, static_cast<int>(models::ErrorTableModel::kMostValues));
  count_->setKeyboardTracking(false);
  interpolation_ = new QComboBox(panel);
  interpolation_->addItem(tr("Smooth (cubic)"), QStringLiteral("cubic"));
  interpolation_->addItem(tr("Straight (linear)"), QStringLiteral("linear"));
  frame_ = new QComboBox(panel);
  frame_->addItem(tr("Turns with the axis"), QStringLiteral("moved"));
  frame_->addItem(tr("Stands still"), QStringLiteral("fixed"));
  start_unit_ = new QLabel(panel);
  spacing_unit_ = new QLabel(panel);
  int column = 0;
  const auto add = [grid, panel, &column](const QString& name, QWidget* editor, QLabel* unit) {
    auto* label = new QLabel(name, panel);
    label->setBuddy(editor);
    grid->addWidget(label, 0, column);
    grid->addWidget(editor, 1, column);
    if (unit != nullptr) grid->addWidget(unit, 1, column + 1);
    column += 2;
  };
  add(tr("Start"), start_, start_unit_);
  add(tr("Spacing"), spacing_, spacing_unit_);
  add(tr("Count"), count_, nullptr);
  add(tr("Between the points"), interpolation_, nullptr);
  add(tr("Measured in a frame that"), frame_, nullptr);
  grid->setColumnStretch(column, 1);
  connect(start_, &widgets::NumberEdit::edited, this,
          [this](const Json& cell) { takeMember("start", cell); });
  connect(spacing_, &widgets::NumberEdit::edited, this,
          [this](const Json& cell) { takeMember("spacing", cell); });
  connect(count_, qOverload<int>(&QSpinBox::valueChanged), this, &TableEditor::takeCount);
  connect(interpolation_, qOverload<int>(&QComboBox::currentIndexChanged), this,
          &TableEditor::takeInterpolation);
  connect(frame_, qOverload<int>(&QComboBox::currentIndexChanged), this, &TableEditor::takeInterpolation);
  return panel;
}

QWidget* TableEditor::makeTable() {
  auto* panel = new QWidget(this);
  auto* layout = new QVBoxLayout(panel);
  layout->setContentsMargins(0, 0, 0, 0);
  table_ = new widgets::CellTable(panel);
  table_->setObjectName(QStringLiteral("errorTable"));
  table_->setModel(model_);
  layout->addWidget(table_, 1);
  auto* load = new QPushButton(tr("Load CSV…"), panel);
  remove_ = new QPushButton(tr("Remove table"), panel);
  auto* row = new QHBoxLayout;
  row->addWidget(load);
  row->addWidget(remove_);
  layout->addLayout(row);
  connect(table_, &widgets::CellTable::pasted, this, &TableEditor::paste);
  connect(table_, &widgets::CellTable::cleared, model_, &models::ErrorTableModel::clearRows);
  connect(load, &QPushButton::clicked, this, &TableEditor::fileWanted);
  connect(remove_, &QPushButton::clicked, this, [this]() {
    emit effectsEdited(tr("Remove table"), models::withoutEntry(effects_, *component_), {});
  });
  return panel;
}

void TableEditor::show(const kinematics::Machine& machine, const errors::Component& component,
                       const Json& effects) {
  const bool other = !(component_ == component);
  machine_ = machine;
  component_ = component;
  effects_ = effects;
  model_->setEntry(machine, component, models::tableEntry(effects, component, machine));
  if (other) {
    note_->hide();
    table_->setCurrentIndex(model_->index(0, 1));
    table_->setColumnWidth(0, 130);
  }
  showGrid();
  drawCurve();
}

void TableEditor::showGrid() {
  const QSignalBlocker block_count(count_);
  const QSignalBlocker block_interpolation(interpolation_);
  const QSignalBlocker block_frame(frame_);
  const bool filled = models::findEntry(effects_, *component_).has_value();
  const models::TableKeys keys = models::tableKeys(*component_, *machine_);
  const int joint = machine_->find(component_->axis);
  const QString unit = models::positionUnitOf(*machine_, joint);
  title_->setText(QStringLiteral("%1 – %2 (%3)%4")
                      .arg(QString::fromStdString(component_->text()),
                           models::descriptionOf(*component_, *machine_), models::unitOf(*component_),
                           filled ? QString() : QStringLiteral(" · ") + tr("nothing entered yet")));
  const auto member = [this](const std::string& key) {
    const Json* found = model_->entry().find(key);
    return found != nullptr ? *found : Json();
  };
  start_->setCell(member(keys.start));
  spacing_->setCell(member(keys.spacing));
  const auto spacing = model_->spacing();
  spacing_->setFault(spacing && *spacing <= 0.0 ? tr("The spacing must be above 0.") : QString());
  start_unit_->setText(unit);
  spacing_unit_->setText(unit);
  count_->setValue(static_cast<int>(model_->count()));
  const auto choose = [&member](QComboBox* box, const char* key) {
    const Json value = member(key);
    const int index = value.string() == nullptr ? 0 : box->findData(QString::fromStdString(*value.string()));
    box->setCurrentIndex(index < 0 ? 0 : index);
  };
  choose(interpolation_, "interpolation");
  choose(frame_, "frame");
  frame_->setEnabled(machine_->isRotary(joint));
  remove_->setEnabled(filled);
}

void TableEditor::drawCurve() {
  const auto points = model_->points();
  views::Curve nodes{views::Role::Nodes, {}, {}};
  for (const auto& [x, y] : points) {
    nodes.x.push_back(x);
    nodes.y.push_back(y);
  }
  views::Curve curve{views::Role::Curve, {}, {}};
  const models::SampledCurve sampled = models::sampleTable(*machine_, *component_, model_->entry());
  curve.x = sampled.x;
  curve.y = sampled.y;
  const int joint = machine_->find(component_->axis);
  chart_->show(
      QStringLiteral("%1 / %2").arg(QString::fromStdString(component_->axis.text()),
                                    machine_->isRotary(joint) ? QStringLiteral("deg") : QStringLiteral("mm")),
      QStringLiteral("%1 / %2").arg(QString::fromStdString(component_->text()), component_->isAngular()
                                                                                    ? QStringLiteral("arcsec")
                                                                                    : QStringLiteral("µm")),
      {std::move(curve), std::move(nodes)});
}

void TableEditor::takeEntry(const Json& entry, const QString& text, const QString& key) {
  note_->hide();
  emit effectsEdited(text, models::withEntry(effects_, *component_, entry), key);
}

void TableEditor::takeMember(const char* which, const Json& value) {
  const models::TableKeys keys = models::tableKeys(*component_, *machine_);
  Json entry = model_->entry();
  entry.set(std::string_view(which) == "start" ? keys.start : keys.spacing, value);
  takeEntry(entry, tr("Change grid"));
}

void TableEditor::takeCount(int count) {
  const models::TableKeys keys = models::tableKeys(*component_, *machine_);
  takeEntry(models::withCount(model_->entry(), keys, static_cast<std::size_t>(count)), tr("Change count"));
}

void TableEditor::takeInterpolation() {
  Json entry = model_->entry();
  entry.set("interpolation", interpolation_->currentData().toString().toStdString());
  if (frame_->isEnabled()) entry.set("frame", frame_->currentData().toString().toStdString());
  takeEntry(entry, tr("Change interpolation"));
}

void TableEditor::paste(const QString& text, int row) {
  const QString fault = model_->paste(models::cellsOf(text), row);
  note_->setText(fault);
  note_->setVisible(!fault.isEmpty());
}

void TableEditor::loadFile(const QString& path) {
  if (path.isEmpty()) return;
  const Result<std::string> text = readFile(path.toStdString());
  if (!text) {
    note_->setText(models::messageOf(text.error()));
    note_->show();
    return;
  }
  paste(QString::fromStdString(*text), 0);
}

}  // namespace nineline::pages
