#include "ui/pages/compensate_page.h"

#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QTabWidget>
#include <QVBoxLayout>

#include "core/base/units.h"
#include "ui/models/messages.h"
#include "ui/models/quantities.h"
#include "ui/models/summary_model.h"
#include "ui/pages/option_fields.h"
#include "ui/pages/setup_editor.h"
#include "ui/widgets/message_list.h"
#include "ui/widgets/parameter_form.h"

namespace nineline::pages {

namespace {

constexpr int kProgressSteps = 1000;

void clearLayout(QGridLayout* layout) {
  while (QLayoutItem* item = layout->takeAt(0)) {
    if (item->widget() != nullptr) item->widget()->deleteLater();
    delete item;
  }
}

void addTile(QGridLayout* grid, int place, const QString& name, const QString& value) {
  auto* tile = new QLabel(QStringLiteral("<span style='font-size:16pt;font-weight:600'>%1</span><br>%2")
                              .arg(value.toHtmlEscaped(), name.toHtmlEscaped()));
  tile->setObjectName(QStringLiteral("tile"));
  grid->addWidget(tile, place / 3, place % 3);
}

}  // namespace

CompensatePage::CompensatePage(Context context, QWidget* parent)
    : Page(context, tr("Set how the program is corrected, then start the compensation."), parent) {
  auto* layout = new QHBoxLayout(body());
  layout->setContentsMargins(0, 0, 0, 0);
  auto* splitter = new QSplitter(body());
  splitter->addWidget(makeOptions());
  splitter->addWidget(makeRun());
  splitter->setStretchFactor(1, 1);
  splitter->setSizes({560, 690});
  layout->addWidget(splitter);
  connect(&runner_, &jobs::JobRunner::progressed, this, &CompensatePage::showProgress);
  connect(&runner_, &jobs::JobRunner::finished, this, &CompensatePage::refresh);
  connect(&runner_, &jobs::JobRunner::failed, &workspace(), &models::Workspace::failed);
  connect(&workspace(), &models::Workspace::changed, this, &CompensatePage::refresh);
  connect(&workspace(), &models::Workspace::optionsChanged, this, &CompensatePage::refreshOptions);
  refreshOptions();
  refresh();
}

QWidget* CompensatePage::makeOptions() {
  auto* tabs = new QTabWidget(this);
  form_ = new widgets::ParameterForm(optionFields(), tabs);
  connect(form_, &widgets::ParameterForm::edited, this, &CompensatePage::changeOption);
  tabs->addTab(form_, tr("Correction"));
  setup_ = new SetupEditor(workspace(), tabs);
  connect(setup_, &SetupEditor::setupEdited, this, [this](const Json& setup) {
    models::Document next = document();
    next.setup = setup;
    edit(tr("Change machine state"), std::move(next));
  });
  tabs->addTab(setup_, tr("Control and machine state"));
  return tabs;
}

QWidget* CompensatePage::makeRun() {
  auto* panel = new QWidget(this);
  auto* layout = new QVBoxLayout(panel);
  layout->setContentsMargins(12, 0, 0, 0);
  layout->setSpacing(10);
  start_ = new QPushButton(tr("Start compensation"), panel);
  start_->setObjectName(QStringLiteral("primary"));
  start_->setShortcut(QKeySequence(Qt::Key_F5));
  connect(start_, &QPushButton::clicked, this, &CompensatePage::start);
  layout->addWidget(start_);
  auto* row = new QHBoxLayout;
  progress_ = new QProgressBar(panel);
  progress_->setRange(0, kProgressSteps);
  cancel_ = new QPushButton(tr("Cancel"), panel);
  connect(cancel_, &QPushButton::clicked, &runner_, &jobs::JobRunner::cancel);
  row->addWidget(progress_, 1);
  row->addWidget(cancel_);
  layout->addLayout(row);
  remaining_ = new QLabel(panel);
  layout->addWidget(remaining_);
  headline_ = new QLabel(panel);
  headline_->setObjectName(QStringLiteral("headline"));
  headline_->setWordWrap(true);
  layout->addWidget(headline_);
  figures_ = new QGridLayout;
  figures_->setSpacing(8);
  layout->addLayout(figures_);
  messages_ = new widgets::MessageList(panel);
  layout->addWidget(messages_, 1);
  results_ = new QPushButton(tr("Show results"), panel);
  connect(results_, &QPushButton::clicked, this, [this]() { emit stepWanted(models::Step::Results); });
  layout->addWidget(results_);
  return panel;
}

void CompensatePage::changeOption(const QString& key, const Json& value) {
  models::Document next = document();
  next.options.set(key.toStdString(), value);
  edit(tr("Change option"), std::move(next));
}

void CompensatePage::start() {
  const Result<jobs::CompensationInput> input = workspace().compensationInput();
  if (!input) {
    headline_->setText(tr("The compensation cannot start."));
    clearLayout(figures_);
    return messages_->setError(input.error());
  }
  messages_->clear();
  clearLayout(figures_);
  headline_->setText(tr("Computing the corrected program…"));
  progress_->setValue(0);
  runner_.run([input = *input](Progress& progress) { return jobs::compensate(input, progress); },
              [this, of = document()](const Result<jobs::OutcomePtr>& outcome) { show(outcome, of); });
  start_->setEnabled(false);
  cancel_->setEnabled(true);
  results_->setEnabled(false);
}

void CompensatePage::show(const Result<jobs::OutcomePtr>& outcome, const models::Document& of) {
  progress_->setValue(outcome ? kProgressSteps : 0);
  remaining_->clear();
  if (outcome) return workspace().setOutcome(*outcome, of);
  const bool stopped = outcome.error().code == "cancelled";
  headline_->setText(stopped ? tr("Cancelled. Nothing was changed.") : tr("The program was not corrected."));
  messages_->setError(outcome.error());
}

void CompensatePage::showProgress(double fraction, const QString&, double seconds_left) {
  progress_->setValue(static_cast<int>(fraction * kProgressSteps));
  remaining_->setText(seconds_left < 0.0 ? QString()
                                         : tr("About %1 left").arg(models::timeText(seconds_left)));
}

void CompensatePage::refreshOptions() { form_->setValues(document().options); }

void CompensatePage::refresh() {
  const bool running = runner_.isRunning();
  start_->setEnabled(!running);
  cancel_->setEnabled(running);
  results_->setEnabled(workspace().outcome() != nullptr && !running);
  if (!running && workspace().outcome() != nullptr) showFigures();
}

void CompensatePage::showFigures() {
  const bool stale = workspace().isOutcomeStale();
  headline_->setText(stale ? workspace().explanation(models::Step::Compensate) : tr("NC program corrected"));
  clearLayout(figures_);
  const compensation::CompensationReport& report = workspace().outcome()->report;
  const auto& before = report.before.norm;
  const auto& after = report.after.norm;
  const auto um = [](double value) { return models::shownFigure(value, false) + QStringLiteral(" µm"); };
  addTile(figures_, 0, tr("blocks corrected, of %1").arg(report.blocks), QString::number(report.corrected));
  addTile(figures_, 1, tr("lines inserted"), QString::number(report.inserted));
  addTile(figures_, 2, tr("RMS deviation removed"),
          QStringLiteral("%1 %").arg(compensation::reductionPercent(before.rms, after.rms), 0, 'f', 2));
  addTile(figures_, 3, tr("RMS deviation before"), um(before.rms));
  addTile(figures_, 4, tr("RMS deviation after"), um(after.rms));
  addTile(figures_, 5, tr("largest deviation after"), um(after.max));
  const std::vector<Diagnostic>& warnings = report.diagnostics.all();
  if (warnings.empty()) {
    messages_->setFine(
        tr("The corrected program was read again and simulated apart from the correction: no "
           "warnings."));
  } else {
    messages_->setDiagnostics(warnings);
  }
}

}  // namespace nineline::pages
