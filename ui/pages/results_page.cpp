#include "ui/pages/results_page.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTableView>
#include <QVBoxLayout>

#include "core/base/file.h"
#include "core/kinematics/machine_file.h"
#include "ui/models/path_parts.h"
#include "ui/models/summary_model.h"
#include "ui/pages/error_curves.h"
#include "ui/pages/path_panel.h"

namespace nineline::pages {

namespace {
constexpr std::size_t kManyCuts = 3;  // that hide each other in one picture
constexpr int kPartWidth = 220;
}  // namespace

ResultsPage::ResultsPage(Context context, QWidget* parent)
    : Page(context, tr("What the errors did to the tool path, and what is left of it after compensation."),
           parent),
      summary_(new models::SummaryModel(this)) {
  auto* layout = new QVBoxLayout(body());
  layout->setContentsMargins(0, 0, 0, 0);
  note_ = new QLabel(body());
  note_->setObjectName(QStringLiteral("fault"));
  note_->setWordWrap(true);
  layout->addWidget(note_);
  layout->addWidget(makePartChooser());
  auto* splitter = new QSplitter(body());
  path_ = new PathPanel(splitter);
  splitter->addWidget(path_);
  auto* right = new QSplitter(Qt::Vertical, splitter);
  curves_ = new ErrorCurves(right);
  right->addWidget(curves_);
  right->addWidget(makeFigures());
  right->setStretchFactor(0, 1);
  right->setSizes({300, 290});
  splitter->addWidget(right);
  splitter->setStretchFactor(0, 1);
  splitter->setSizes({600, 650});
  layout->addWidget(splitter, 1);
  const auto ask_picture = [this](const QString& name) {
    return askSave(tr("Save picture"), name, tr("Pictures (*.png)"));
  };
  connect(path_, &PathPanel::pictureWanted, this,
          [this, ask_picture]() { path_->savePicture(ask_picture(QStringLiteral("path.png"))); });
  connect(curves_, &ErrorCurves::pictureWanted, this,
          [this, ask_picture]() { curves_->savePicture(ask_picture(QStringLiteral("curves.png"))); });
  connect(&workspace(), &models::Workspace::outcomeChanged, this, &ResultsPage::refresh);
  connect(&workspace(), &models::Workspace::changed, this, &ResultsPage::refreshNote);
  refresh();
  refreshNote();
}

QWidget* ResultsPage::makeFigures() {
  auto* panel = new QWidget(this);
  auto* layout = new QVBoxLayout(panel);
  layout->setContentsMargins(0, 4, 0, 0);
  auto* table = new QTableView(panel);
  table->setObjectName(QStringLiteral("summaryTable"));
  table->setModel(summary_);
  table->verticalHeader()->hide();
  table->verticalHeader()->setDefaultSectionSize(25);
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  table->setWordWrap(false);
  table->setTextElideMode(Qt::ElideNone);
  table->setAlternatingRowColors(true);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  layout->addWidget(table, 1);
  auto* save = new QPushButton(tr("Save figures and path as CSV…"), panel);
  connect(save, &QPushButton::clicked, this, &ResultsPage::saveTable);
  layout->addWidget(save);
  return panel;
}

void ResultsPage::refresh() {
  const jobs::OutcomePtr outcome = workspace().outcome();
  const auto machine = kinematics::readMachine(workspace().outcomeDocument().machine_text, "");
  if (outcome == nullptr || !machine) {
    summary_->clear();
    return;
  }
  summary_->setSummaries(*machine, outcome->report.before, outcome->report.after);
  const std::size_t cuts = models::cutsOf(outcome->before).size();
  {
    const QSignalBlocker blocker(part_);
    part_->setItemText(1, tr("Last of %1 cuts").arg(cuts));
    part_->setCurrentIndex(cuts >= kManyCuts ? 1 : 0);
  }
  showPart();
}

QWidget* ResultsPage::makePartChooser() {
  auto* panel = new QWidget(this);
  auto* layout = new QHBoxLayout(panel);
  layout->setContentsMargins(0, 0, 0, 0);
  part_ = new QComboBox(panel);
  part_->addItem(tr("Whole program"));
  part_->addItem(tr("Last cut"));
  part_->setMinimumWidth(kPartWidth);
  layout->addWidget(new QLabel(tr("Path and curves of"), panel));
  layout->addWidget(part_);
  layout->addWidget(new QLabel(tr("The table is of the whole program."), panel));
  layout->addStretch(1);
  connect(part_, qOverload<int>(&QComboBox::currentIndexChanged), this, &ResultsPage::showPart);
  return panel;
}

void ResultsPage::showPart() {
  const jobs::OutcomePtr outcome = workspace().outcome();
  const auto machine = kinematics::readMachine(workspace().outcomeDocument().machine_text, "");
  if (outcome == nullptr || !machine) return;
  auto shown = std::make_shared<jobs::CompensationOutcome>();
  const auto cuts = models::cutsOf(outcome->before);
  const models::PathPart part =
      part_->currentIndex() == 1 && !cuts.empty() ? cuts.back() : models::PathPart{0, outcome->before.size()};
  shown->before = models::samplesOf(outcome->before, part);
  shown->after = models::samplesOf(outcome->after, part);
  path_->setOutcome(*machine, shown);
  curves_->setOutcome(*machine, shown);
}

void ResultsPage::refreshNote() {
  const QString note = workspace().explanation(models::Step::Results);
  note_->setText(note);
  note_->setVisible(!note.isEmpty());
}

void ResultsPage::saveTable() {
  const jobs::OutcomePtr outcome = workspace().outcome();
  const auto machine = kinematics::readMachine(workspace().outcomeDocument().machine_text, "");
  if (outcome == nullptr || !machine) return;
  const QString path = askSave(tr("Save figures and path"), QStringLiteral("path.csv"), tr("Tables (*.csv)"));
  if (path.isEmpty()) return;
  std::string rows = simulation::pathCsvHeader(*machine);
  for (const auto& sample : outcome->after) simulation::appendPathCsvRow(*machine, sample, rows);
  QString figures_path = path;
  figures_path.replace(QLatin1String(".csv"), QLatin1String("-figures.csv"));
  if (figures_path == path) figures_path += QLatin1String("-figures.csv");
  const Result<void> written = writeFile(path.toStdString(), rows);
  if (!written) return showError(tr("Save figures and path"), written.error());
  const Result<void> figures = writeFile(figures_path.toStdString(), summary_->toCsv().toStdString());
  if (!figures) showError(tr("Save figures and path"), figures.error());
}

}  // namespace nineline::pages
