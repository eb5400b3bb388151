#include <QActionGroup>
#include <QFileInfo>
#include <QMenuBar>
#include <QMessageBox>
#include <QSettings>

#include "ui/shell/main_window.h"
#include "ui/widgets/step_bar.h"

namespace nineline::shell {

namespace {
constexpr int kMostRecent = 8;
}

void MainWindow::buildMenus() {
  buildFileMenu();
  buildEditMenu();
  buildViewMenu();
  QMenu* languages = menuBar()->addMenu(tr("&Language"));
  auto* group = new QActionGroup(languages);
  for (const Language::Choice& choice : Language::choices()) {
    QAction* action = languages->addAction(choice.name);
    action->setCheckable(true);
    action->setChecked(choice.code == language_.current());
    group->addAction(action);
    // Queued: the menu that this action stands in is made anew.
    connect(
        action, &QAction::triggered, this, [this, code = choice.code]() { setLanguage(code); },
        Qt::QueuedConnection);
  }
  QMenu* help = menuBar()->addMenu(tr("&Help"));
  connect(help->addAction(tr("&About Nineline")), &QAction::triggered, this, &MainWindow::showAbout);
}

void MainWindow::buildFileMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&File"));
  const auto add = [this, menu](const QString& text, const QKeySequence& keys, auto slot) {
    QAction* action = menu->addAction(text);
    action->setShortcut(keys);
    connect(action, &QAction::triggered, this, slot);
  };
  add(tr("&New project"), QKeySequence::New, [this]() { newProject(); });
  add(tr("&Open project…"), QKeySequence::Open, [this]() { askOpenProject(); });
  QMenu* recent = menu->addMenu(tr("Recent projects"));
  connect(recent, &QMenu::aboutToShow, this, [this, recent]() { fillRecent(recent); });
  add(tr("Open &worked example"), {}, [this]() {
    if (mayLeave()) openExample();
  });
  menu->addSeparator();
  add(tr("&Save project"), QKeySequence::Save, [this]() { save(); });
  add(tr("Save project &as…"), QKeySequence::SaveAs, [this]() { saveAs(); });
  menu->addSeparator();
  add(tr("&Quit"), QKeySequence::Quit, [this]() { close(); });
}

void MainWindow::buildEditMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Edit"));
  QAction* undo = edits_.stack().createUndoAction(menu, tr("Undo"));
  undo->setShortcut(QKeySequence::Undo);
  QAction* redo = edits_.stack().createRedoAction(menu, tr("Redo"));
  redo->setShortcut(QKeySequence::Redo);
  menu->addAction(undo);
  menu->addAction(redo);
}

void MainWindow::buildViewMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&View"));
  for (int i = 0; i < models::kStepCount; ++i) {
    const auto step = static_cast<models::Step>(i);
    connect(menu->addAction(widgets::StepBar::nameOf(step)), &QAction::triggered, this,
            [this, step]() { goTo(step); });
  }
  menu->addSeparator();
  QAction* full = menu->addAction(tr("Full screen"));
  full->setShortcut(QKeySequence(Qt::Key_F11));
  full->setCheckable(true);
  full->setChecked(isFullScreen());
  connect(full, &QAction::toggled, this, [this](bool on) { on ? showFullScreen() : showNormal(); });
}

void MainWindow::fillRecent(QMenu* menu) {
  menu->clear();
  const QStringList paths = QSettings().value(QStringLiteral("recent")).toStringList();
  for (const QString& path : paths) {
    QAction* action = menu->addAction(QFileInfo(path).fileName());
    action->setToolTip(path);
    connect(action, &QAction::triggered, this, [this, path]() {
      if (mayLeave()) openProject(path);
    });
  }
  if (paths.isEmpty()) menu->addAction(tr("None yet"))->setEnabled(false);
}

void MainWindow::remember(const QString& path) {
  QSettings settings;
  QStringList paths = settings.value(QStringLiteral("recent")).toStringList();
  const QString whole = QFileInfo(path).absoluteFilePath();
  paths.removeAll(whole);
  paths.prepend(whole);
  while (paths.size() > kMostRecent) paths.removeLast();
  settings.setValue(QStringLiteral("recent"), paths);
  settings.setValue(QStringLiteral("session"), whole);
}

void MainWindow::showAbout() {
  QMessageBox::about(this, tr("About Nineline"),
                     tr("<h3>Nineline %1</h3><p>Measured machine errors in, corrected NC program out.</p>"
                        "<p>Every error of every axis is one effect of one model; the program that comes out "
                        "is read again and simulated before you get it.</p>")
                         .arg(QStringLiteral(NINELINE_VERSION)));
}

}  // namespace nineline::shell
