#pragma once

#include <QMainWindow>
#include <QTimer>

#include "ui/models/workspace.h"
#include "ui/pages/page.h"
#include "ui/shell/language.h"
#include "ui/shell/project_store.h"
#include "ui/widgets/edits.h"

class QMenu;
class QStackedWidget;

namespace nineline::pages {
class CompensatePage;
class GapPage;
}  // namespace nineline::pages
namespace nineline::widgets {
class StepBar;
}

namespace nineline::shell {

/// The wizard: steps above, the page of the chosen step below, menus.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  void openExample();
  /// False when the file was refused; the person has been told.
  bool openProject(const QString& path);
  /// What was open when the program ended, where that is wanted and possible.
  bool restoreSession();
  void goTo(models::Step step);
  void setLanguage(const QString& code);
  void startCompensation();
  void startGapSearch();
  [[nodiscard]] models::Workspace& workspace() { return workspace_; }
  [[nodiscard]] widgets::Edits& edits() { return edits_; }
  /// Saves the document beside the settings, after a mistake of the program; says where.
  [[nodiscard]] QString rescue();

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  void buildMenus();
  void buildFileMenu();
  void buildEditMenu();
  void buildViewMenu();
  void buildPages();
  /// Makes menus and pages anew, in the current language; the document stays.
  void rebuild();
  void refreshSteps();
  void refreshTitle();
  void fillRecent(QMenu* menu);
  void remember(const QString& path);

  void newProject();
  void askOpenProject();
  bool save();
  bool saveAs();
  /// False: the person wants to stay.
  bool mayLeave();
  void take(models::Document document);
  void autosave();
  [[nodiscard]] static QString recoveryPath();
  /// After a crash: the project that was never saved, where the person wants it back.
  bool recover();
  void forgetRecovery();
  bool saveOverForeignChanges(const Error& error);
  void showAbout();

  models::Workspace workspace_;
  widgets::Edits edits_;
  ProjectStore store_;
  ProjectStore recovery_;  ///< keeps a project that has no file yet
  Language language_;
  QTimer autosave_;
  widgets::StepBar* steps_ = nullptr;
  QStackedWidget* pages_ = nullptr;
  pages::CompensatePage* compensate_ = nullptr;
  pages::GapPage* gap_ = nullptr;
  models::Step step_ = models::Step::Machine;
};

}  // namespace nineline::shell
