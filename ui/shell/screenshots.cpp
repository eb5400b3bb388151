#include "ui/shell/screenshots.h"

#include <QApplication>
#include <QDir>
#include <QPixmap>
#include <QTimer>

#include "ui/shell/main_window.h"

namespace nineline::shell {

namespace {

constexpr int kSettle_ms = 700;

void shoot(MainWindow* window, const QString& folder, int step) {
  if (step == models::kStepCount) {
    QApplication::exit(0);
    return;
  }
  window->goTo(static_cast<models::Step>(step));
  QTimer::singleShot(kSettle_ms, window, [window, folder, step]() {
    window->grab().save(QStringLiteral("%1/page-%2.png").arg(folder).arg(step + 1), "PNG");
    shoot(window, folder, step + 1);
  });
}

}  // namespace

void takeScreenshots(MainWindow* window, const QString& folder) {
  QDir().mkpath(folder);
  QObject::connect(&window->workspace(), &models::Workspace::outcomeChanged, window, [window, folder]() {
    if (window->workspace().outcome() != nullptr) shoot(window, folder, 0);
  });
  QTimer::singleShot(kSettle_ms, window, [window]() { window->startCompensation(); });
}

}  // namespace nineline::shell
