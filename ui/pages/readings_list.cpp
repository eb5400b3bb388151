#include "ui/pages/readings_list.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>

#include "core/base/file.h"

namespace nineline::pages {

namespace {

/// A file opened again replaces the one of its name.
void put(std::vector<models::ReadingsFile>& readings, models::ReadingsFile file) {
  const auto same = std::find_if(readings.begin(), readings.end(),
                                 [&](const models::ReadingsFile& one) { return one.name == file.name; });
  if (same != readings.end()) {
    *same = std::move(file);
  } else {
    readings.push_back(std::move(file));
  }
}

}  // namespace

ReadingsList::ReadingsList(models::Workspace& workspace, QWidget* parent)
    : QWidget(parent), workspace_(workspace), model_(new models::ReadingsModel(workspace, this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  table_ = new QTableView(this);
  table_->setObjectName(QStringLiteral("readingsTable"));
  table_->setModel(model_);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->setAlternatingRowColors(true);
  layout->addWidget(table_, 1);
  auto* row = new QHBoxLayout;
  auto* add = new QPushButton(tr("Add readings…"), this);
  add->setObjectName(QStringLiteral("addReadings"));
  remove_ = new QPushButton(tr("Remove"), this);
  row->addWidget(add);
  row->addWidget(remove_);
  row->addStretch(1);
  layout->addLayout(row);
  connect(add, &QPushButton::clicked, this, &ReadingsList::addFiles);
  connect(remove_, &QPushButton::clicked, this, &ReadingsList::removeCurrent);
  connect(table_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          [this]() { emit currentChanged(current()); });
  connect(model_, &QAbstractItemModel::modelReset, this, [this]() {
    if (model_->rowCount() > 0) table_->selectRow(0);
    remove_->setEnabled(model_->rowCount() > 0);
    emit currentChanged(current());
  });
  remove_->setEnabled(model_->rowCount() > 0);
  if (model_->rowCount() > 0) table_->selectRow(0);
}

int ReadingsList::current() const {
  return table_->currentIndex().isValid() ? table_->currentIndex().row() : -1;
}

void ReadingsList::addFiles() {
  const QStringList paths = QFileDialog::getOpenFileNames(
      this, tr("Add readings"), workspace_.folder, tr("Measurements (*.csv *.txt *.tsv);;All files (*)"));
  if (paths.isEmpty()) return;
  workspace_.folder = QFileInfo(paths.front()).absolutePath();
  std::vector<models::ReadingsFile> readings = workspace_.document().readings;
  for (const QString& path : paths) {
    Result<std::string> text = readFile(path.toStdString());
    if (!text) {
      emit failed(text.error());
      continue;
    }
    put(readings,
        {QFileInfo(path).fileName().toStdString(), std::make_shared<const std::string>(std::move(*text))});
  }
  if (!models::isSame(readings, workspace_.document().readings)) {
    emit readingsEdited(tr("Add readings"), readings);
  }
}

void ReadingsList::removeCurrent() {
  const int chosen = current();
  if (chosen < 0) return;
  std::vector<models::ReadingsFile> readings = workspace_.document().readings;
  readings.erase(readings.begin() + chosen);
  emit readingsEdited(tr("Remove readings"), readings);
}

}  // namespace nineline::pages
