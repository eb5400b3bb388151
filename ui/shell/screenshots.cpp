#include "ui/shell/screenshots.h"

#include <QApplication>
#include <QDir>
#include <QPixmap>
#include <QTabWidget>
#include <QTimer>
#include <QTreeView>

#include "ui/shell/main_window.h"

namespace nineline::shell {

namespace {

constexpr int kSettle_ms = 700;

void save(MainWindow* window, const QString& folder, const QString& name) {
  QApplication::processEvents();
  window->grab().save(QStringLiteral("%1/page-%2.png").arg(folder, name), "PNG");
}

/// The tabs behind the first one, and the other editors of the measurements.
void shootHidden(MainWindow* window, const QString& folder, const QString& name) {
  for (QTabWidget* tabs : window->findChildren<QTabWidget*>()) {
    if (!tabs->isVisible()) continue;
    tabs->setCurrentIndex(1);
    save(window, folder, name + QStringLiteral("-tab"));
    tabs->setCurrentIndex(0);
  }
  auto* tree = window->findChild<QTreeView*>(QStringLiteral("componentTree"));
  if (tree == nullptr || !tree->isVisible()) return;
  const QModelIndex before = tree->currentIndex();
  const QAbstractItemModel* model = tree->model();
  tree->setCurrentIndex(model->index(model->rowCount() - 1, 0));
  save(window, folder, name + QStringLiteral("-effects"));
  const QModelIndex axis = model->index(1, 0);
  tree->setCurrentIndex(model->index(model->rowCount(axis) - 1, 0, axis));
  save(window, folder, name + QStringLiteral("-location"));
  tree->setCurrentIndex(before);
}

void shoot(MainWindow* window, const QString& folder, int step) {
  if (step == models::kStepCount) {
    QApplication::exit(0);
    return;
  }
  window->goTo(static_cast<models::Step>(step));
  QTimer::singleShot(kSettle_ms, window, [window, folder, step]() {
    save(window, folder, QString::number(step + 1));
    shootHidden(window, folder, QString::number(step + 1));
    shoot(window, folder, step + 1);
  });
}

}  // namespace

void takeScreenshots(MainWindow* window, const QString& folder) {
  QDir().mkpath(folder);
  QObject::connect(&window->workspace(), &models::Workspace::outcomeChanged, window, [window, folder]() {
    if (window->workspace().outcome() != nullptr) window->startGapSearch();
  });
  QObject::connect(&window->workspace(), &models::Workspace::gapChanged, window, [window, folder]() {
    if (window->workspace().gap() != nullptr) shoot(window, folder, 0);
  });
  QTimer::singleShot(kSettle_ms, window, [window]() { window->startCompensation(); });
}

}  // namespace nineline::shell
