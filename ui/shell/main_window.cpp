#include "ui/shell/main_window.h"

#include <QCloseEvent>
#include <QMenuBar>
#include <QMessageBox>
#include <QSettings>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "ui/models/messages.h"
#include "ui/pages/compensate_page.h"
#include "ui/pages/export_page.h"
#include "ui/pages/gap_page.h"
#include "ui/pages/machine_page.h"
#include "ui/pages/measurements_page.h"
#include "ui/pages/program_page.h"
#include "ui/pages/results_page.h"
#include "ui/shell/example.h"
#include "ui/widgets/step_bar.h"

namespace nineline::shell {

namespace {
constexpr int kAutosave_ms = 20000;
}

MainWindow::MainWindow(QWidget* parent) : QMainWindow(parent), edits_(&workspace_) {
  const QSettings settings;
  language_.use(settings.value(QStringLiteral("language")).toString());
  workspace_.folder = settings.value(QStringLiteral("folder")).toString();
  resize(1280, 800);
  restoreGeometry(settings.value(QStringLiteral("geometry")).toByteArray());
  workspace_.setDocument(emptyProject());
  edits_.stack().setClean();
  rebuild();
  connect(&workspace_, &models::Workspace::changed, this, &MainWindow::refreshSteps);
  connect(&workspace_, &models::Workspace::outcomeChanged, this, &MainWindow::refreshTitle);
  connect(&edits_.stack(), &QUndoStack::cleanChanged, this, &MainWindow::refreshTitle);
  connect(&workspace_, &models::Workspace::failed, this, [this](const QString& text) {
    QMessageBox::critical(this, tr("Mistake of the program"),
                          tr("Nineline made a mistake and stopped what it was doing. Your work is kept.") +
                              QStringLiteral("\n\n") + text);
  });
  connect(&autosave_, &QTimer::timeout, this, &MainWindow::autosave);
  autosave_.start(kAutosave_ms);
}

MainWindow::~MainWindow() {
  // Pages listen to the workspace and the undo stack, which go first otherwise.
  delete takeCentralWidget();
}

void MainWindow::rebuild() {
  setMenuBar(new QMenuBar(this));  // an old one keeps the font of the language before
  buildMenus();
  delete takeCentralWidget();
  buildPages();
  refreshSteps();
  refreshTitle();
  goTo(step_);
}

void MainWindow::buildPages() {
  auto* central = new QWidget(this);
  auto* layout = new QVBoxLayout(central);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  steps_ = new widgets::StepBar(central);
  pages_ = new QStackedWidget(central);
  layout->addWidget(steps_);
  layout->addWidget(pages_, 1);
  const pages::Context context{&workspace_, &edits_};
  compensate_ = new pages::CompensatePage(context, pages_);
  gap_ = new pages::GapPage(context, pages_);
  const std::initializer_list<pages::Page*> all = {
      new pages::MachinePage(context, pages_), new pages::MeasurementsPage(context, pages_),
      new pages::ProgramPage(context, pages_), compensate_,
      new pages::ResultsPage(context, pages_), gap_,
      new pages::ExportPage(context, pages_)};
  for (pages::Page* page : all) {
    pages_->addWidget(page);
    connect(page, &pages::Page::stepWanted, this, &MainWindow::goTo);
  }
  connect(steps_, &widgets::StepBar::chosen, this, &MainWindow::goTo);
  setCentralWidget(central);
}

void MainWindow::goTo(models::Step step) {
  step_ = step;
  pages_->setCurrentIndex(static_cast<int>(step));
  steps_->setCurrent(step);
}

void MainWindow::refreshSteps() {
  for (int i = 0; i < models::kStepCount; ++i) {
    const auto step = static_cast<models::Step>(i);
    steps_->setState(step, workspace_.state(step), workspace_.explanation(step));
  }
}

void MainWindow::setLanguage(const QString& code) {
  language_.use(code);
  QSettings().setValue(QStringLiteral("language"), code);
  rebuild();
}

void MainWindow::startCompensation() { compensate_->start(); }

void MainWindow::startGapSearch() { gap_->start(); }

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!mayLeave()) return event->ignore();
  QSettings settings;
  settings.setValue(QStringLiteral("geometry"), saveGeometry());
  settings.setValue(QStringLiteral("folder"), workspace_.folder);
  settings.setValue(QStringLiteral("session"), store_.path());
  settings.setValue(QStringLiteral("step"), static_cast<int>(step_));
  forgetRecovery();
  event->accept();
}

}  // namespace nineline::shell
