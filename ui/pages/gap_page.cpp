#include "ui/pages/gap_page.h"

#include <QDateTime>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QTableView>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "core/errors/error_model_file.h"
#include "ui/models/gap_text.h"
#include "ui/models/messages.h"
#include "ui/pages/gap_chart.h"
#include "ui/pages/readings_list.h"

namespace nineline::pages {

namespace {

constexpr int kProgressSteps = 1000;

}  // namespace

GapPage::GapPage(Context context, QWidget* parent)
    : Page(
          context,
          tr("Compare readings of the machine with the model: where they disagree, what is missing, and what "
             "is left once it is added."),
          parent),
      effects_(new models::FoundEffectsModel(this)) {
  auto* layout = new QHBoxLayout(body());
  layout->setContentsMargins(0, 0, 0, 0);
  auto* splitter = new QSplitter(body());
  splitter->addWidget(makeLeft());
  auto* right = new QSplitter(Qt::Vertical, splitter);
  chart_ = new GapChart(right);
  right->addWidget(chart_);
  right->addWidget(makeFindings());
  right->setSizes({300, 320});
  splitter->addWidget(right);
  splitter->setStretchFactor(1, 1);
  splitter->setSizes({430, 820});
  layout->addWidget(splitter);
  connect(chart_, &GapChart::pictureWanted, this, [this]() {
    chart_->savePicture(askSave(tr("Save picture"), QStringLiteral("gap.png"), tr("Pictures (*.png)")));
  });
  connect(&runner_, &jobs::JobRunner::progressed, this,
          [this](double fraction) { progress_->setValue(static_cast<int>(fraction * kProgressSteps)); });
  connect(&runner_, &jobs::JobRunner::finished, this, &GapPage::refresh);
  connect(&runner_, &jobs::JobRunner::failed, &workspace(), &models::Workspace::failed);
  connect(&workspace(), &models::Workspace::changed, this, &GapPage::refresh);
  connect(&workspace(), &models::Workspace::gapChanged, this, &GapPage::refreshFindings);
  connect(&workspace(), &models::Workspace::readingsChanged, this, [this]() { chart_->show(workspace()); });
  refreshFindings();
  refresh();
}

QWidget* GapPage::makeLeft() {
  auto* panel = new QWidget(this);
  auto* layout = new QVBoxLayout(panel);
  layout->setContentsMargins(0, 0, 8, 0);
  readings_ = new ReadingsList(workspace(), panel);
  connect(readings_, &ReadingsList::readingsEdited, this, [this](const QString& text, const auto& readings) {
    models::Document next = document();
    next.readings = readings;
    edit(text, std::move(next));
  });
  connect(readings_, &ReadingsList::failed, this,
          [this](const Error& error) { showError(tr("Readings"), error); });
  layout->addWidget(readings_, 1);
  start_ = new QPushButton(tr("Search for missing effects"), panel);
  start_->setObjectName(QStringLiteral("primary"));
  start_->setShortcut(QKeySequence(Qt::Key_F6));
  connect(start_, &QPushButton::clicked, this, &GapPage::start);
  layout->addWidget(start_);
  auto* row = new QHBoxLayout;
  progress_ = new QProgressBar(panel);
  progress_->setRange(0, kProgressSteps);
  cancel_ = new QPushButton(tr("Cancel"), panel);
  connect(cancel_, &QPushButton::clicked, &runner_, &jobs::JobRunner::cancel);
  row->addWidget(progress_, 1);
  row->addWidget(cancel_);
  layout->addLayout(row);
  headline_ = new QLabel(panel);
  headline_->setObjectName(QStringLiteral("headline"));
  headline_->setWordWrap(true);
  layout->addWidget(headline_);
  shrink_ = new QLabel(panel);
  shrink_->setObjectName(QStringLiteral("tile"));
  shrink_->setWordWrap(true);
  layout->addWidget(shrink_);
  add_ = new QPushButton(tr("Add to model"), panel);
  add_->setObjectName(QStringLiteral("addToModel"));
  connect(add_, &QPushButton::clicked, this, &GapPage::addToModel);
  layout->addWidget(add_);
  return panel;
}

QWidget* GapPage::makeFindings() {
  auto* splitter = new QSplitter(Qt::Vertical, this);
  table_ = new QTableView(splitter);
  table_->setObjectName(QStringLiteral("foundEffects"));
  table_->setModel(effects_);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->setAlternatingRowColors(true);
  details_ = new QTextBrowser(splitter);
  details_->setObjectName(QStringLiteral("gapDetails"));
  splitter->addWidget(table_);
  splitter->addWidget(details_);
  splitter->setSizes({110, 210});
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &GapPage::describe);
  return splitter;
}

void GapPage::start() {
  if (!workspace().model()) return showError(tr("Model gap"), workspace().model().error());
  jobs::GapInput input{*workspace().model(), {}, {}};
  for (const models::LoadedReadings& readings : workspace().readings()) {
    if (readings.isUsable()) input.measurements.push_back(readings.measurement);
  }
  if (input.measurements.empty()) {
    headline_->setText(workspace().explanation(models::Step::ModelGap));
    return;
  }
  input.options.when = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
  headline_->setText(tr("Searching…"));
  progress_->setValue(0);
  runner_.run([input = std::move(input)](Progress& progress) { return jobs::findGap(input, progress); },
              [this, of = document()](const Result<jobs::GapOutcomePtr>& gap) { show(gap, of); });
  refresh();
}

void GapPage::show(const Result<jobs::GapOutcomePtr>& outcome, const models::Document& of) {
  progress_->setValue(outcome ? kProgressSteps : 0);
  if (outcome) return workspace().setGap(*outcome, of);
  if (outcome.error().code == "cancelled") {
    headline_->setText(tr("Cancelled. Nothing was changed."));
  } else {
    headline_->setText(models::messageOf(outcome.error()));
  }
}

void GapPage::addToModel() {
  const jobs::GapOutcomePtr gap = workspace().gap();
  if (gap == nullptr || !gap->report.model || workspace().isGapStale()) return;
  models::Document next = document();
  next.effects = *errors::errorModelToJson(*gap->report.model).find("effects");
  edit(tr("Add found effects to the model"), std::move(next));
}

void GapPage::refresh() {
  const bool running = runner_.isRunning();
  start_->setEnabled(!running && !workspace().readings().empty());
  cancel_->setEnabled(running);
  const jobs::GapOutcomePtr gap = workspace().gap();
  const bool current = gap != nullptr && !workspace().isGapStale();
  add_->setEnabled(!running && current && models::addsSomething(gap->report));
  if (running) return;
  headline_->setText(current ? models::verdictText(gap->report)
                             : workspace().explanation(models::Step::ModelGap));
  shrink_->setVisible(current);
  if (current) shrink_->setText(models::shrinkText(*gap));
}

void GapPage::refreshFindings() {
  const jobs::GapOutcomePtr gap = workspace().gap();
  effects_->setEffects(gap == nullptr ? std::vector<discovery::FoundEffect>{} : gap->report.effects);
  if (effects_->rowCount() > 0) table_->selectRow(0);
  chart_->show(workspace());
  describe();
}

void GapPage::describe() {
  const jobs::GapOutcomePtr gap = workspace().gap();
  if (gap == nullptr) return details_->clear();
  details_->setHtml(models::detailsText(gap->report, effects_->effect(table_->currentIndex().row())));
}

}  // namespace nineline::pages
