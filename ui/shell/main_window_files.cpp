#include <QAbstractButton>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>

#include "core/base/file.h"
#include "ui/models/messages.h"
#include "ui/shell/example.h"
#include "ui/shell/main_window.h"

namespace nineline::shell {

namespace {

QString filter() { return MainWindow::tr("Nineline projects (*.nineline)"); }

}  // namespace

void MainWindow::take(models::Document document) {
  workspace_.setOutcome(nullptr, {});
  workspace_.setGap(nullptr, {});
  edits_.stack().clear();
  workspace_.setDocument(std::move(document));
  edits_.stack().setClean();
  refreshTitle();
}

void MainWindow::newProject() {
  if (!mayLeave()) return;
  store_.close();
  take(emptyProject());
  goTo(models::Step::Machine);
}

void MainWindow::openExample() {
  Result<models::Document> example = workedExample();
  if (!example) {
    QMessageBox::warning(this, tr("Worked example"), models::messageOf(example.error()));
    return;
  }
  store_.close();
  take(std::move(*example));
}

void MainWindow::askOpenProject() {
  if (!mayLeave()) return;
  const QString path = QFileDialog::getOpenFileName(this, tr("Open project"), workspace_.folder, filter());
  if (!path.isEmpty()) openProject(path);
}

bool MainWindow::openProject(const QString& path) {
  Result<models::Document> document = store_.open(path);
  if (!document) {
    QMessageBox::warning(
        this, tr("Project"),
        tr("'%1' was not opened.").arg(path) + QStringLiteral("\n\n") + models::messageOf(document.error()));
    return false;
  }
  workspace_.folder = QFileInfo(path).absolutePath();
  take(std::move(*document));
  remember(path);
  if (store_.isReadOnly()) {
    QMessageBox::information(this, tr("Project"),
                             tr("This project can be read, not written: save it under another name."));
  }
  return true;
}

bool MainWindow::restoreSession() {
  if (recover()) return true;
  const QSettings settings;
  const QString path = settings.value(QStringLiteral("session")).toString();
  if (path.isEmpty() || !QFileInfo::exists(path) || !openProject(path)) return false;
  goTo(static_cast<models::Step>(
      qBound(0, settings.value(QStringLiteral("step")).toInt(), models::kStepCount - 1)));
  return true;
}

bool MainWindow::save() {
  if (!store_.isOpen() || store_.isReadOnly()) return saveAs();
  const Result<void> saved = store_.save(workspace_.document(), workspace_.outcome());
  if (saved) {
    edits_.stack().setClean();
    refreshTitle();
    return true;
  }
  if (saved.error().code == "project.changed") return saveOverForeignChanges(saved.error());
  QMessageBox::warning(this, tr("Save project"), models::messageOf(saved.error()));
  return false;
}

bool MainWindow::saveOverForeignChanges(const Error& error) {
  QMessageBox box(QMessageBox::Question, tr("Save project"),
                  tr("Another window saved this project in the meantime.") + QStringLiteral("\n\n") +
                      models::messageOf(error),
                  QMessageBox::Cancel, this);
  const QAbstractButton* over = box.addButton(tr("Write over it"), QMessageBox::AcceptRole);
  const QAbstractButton* beside = box.addButton(tr("Save under another name"), QMessageBox::ActionRole);
  box.exec();
  if (box.clickedButton() == beside) return saveAs();
  return box.clickedButton() == over && store_.takeNote() && save();
}

bool MainWindow::saveAs() {
  QString path = QFileDialog::getSaveFileName(this, tr("Save project"),
                                              workspace_.folder.isEmpty()
                                                  ? QStringLiteral("project.nineline")
                                                  : workspace_.folder + QStringLiteral("/project.nineline"),
                                              filter());
  if (path.isEmpty()) return false;
  if (QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".nineline");
  const Result<void> saved = store_.saveAs(path, workspace_.document(), workspace_.outcome());
  if (!saved) {
    QMessageBox::warning(this, tr("Save project"), models::messageOf(saved.error()));
    return false;
  }
  workspace_.folder = QFileInfo(path).absolutePath();
  edits_.stack().setClean();
  forgetRecovery();
  remember(path);
  refreshTitle();
  return true;
}

bool MainWindow::mayLeave() {
  if (edits_.stack().isClean()) return true;
  const auto answer =
      QMessageBox::question(this, tr("Unsaved changes"), tr("Save the changes to this project first?"),
                            QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  if (answer == QMessageBox::Save) return save();
  return answer == QMessageBox::Discard;
}

QString MainWindow::recoveryPath() {
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
         QStringLiteral("/unsaved.nineline");
}

bool MainWindow::recover() {
  if (!QFileInfo::exists(recoveryPath())) return false;
  const auto answer = QMessageBox::question(
      this, tr("Unsaved project"), tr("Nineline ended before the last project was saved. Open it again?"));
  bool opened = false;
  if (answer == QMessageBox::Yes) {
    Result<models::Document> document = recovery_.open(recoveryPath());
    opened = document.has_value();
    if (opened) {
      workspace_.setOutcome(nullptr, {});
      edits_.apply(tr("Recover project"), std::move(*document));
    }
  }
  forgetRecovery();
  return opened;
}

void MainWindow::forgetRecovery() {
  recovery_.close();
  QFile::remove(recoveryPath());
}

void MainWindow::autosave() {
  if (edits_.stack().isClean() || store_.isReadOnly()) return;
  if (!store_.isOpen()) {
    QDir().mkpath(QFileInfo(recoveryPath()).absolutePath());
    const Result<void> kept = recovery_.isOpen()
                                  ? recovery_.save(workspace_.document(), nullptr)
                                  : recovery_.saveAs(recoveryPath(), workspace_.document(), nullptr);
    if (!kept) recovery_.close();
    return;
  }
  if (store_.save(workspace_.document(), workspace_.outcome())) {
    edits_.stack().setClean();
    refreshTitle();
  }
}

QString MainWindow::rescue() {
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  const QString path = folder + QStringLiteral("/nineline-rescued.nineline");
  ProjectStore store;
  const Result<void> saved = store.saveAs(path, workspace_.document(), workspace_.outcome());
  return saved ? tr("A copy of the project was saved as %1.").arg(path) : models::messageOf(saved.error());
}

void MainWindow::refreshTitle() {
  const QString name = store_.isOpen() ? QFileInfo(store_.path()).fileName() : tr("new project");
  setWindowTitle(QStringLiteral("%1[*]").arg(name));
  setWindowModified(!edits_.stack().isClean());
}

}  // namespace nineline::shell
