#include "ui/shell/application.h"

#include <QFile>
#include <QIcon>
#include <QLocale>
#include <QMessageBox>
#include <exception>

#include "ui/views/opengl.h"

inline void initResources() {
  Q_INIT_RESOURCE(nineline);
  Q_INIT_RESOURCE(translations);
}

namespace nineline::shell {

namespace {

int& prepared(int& argc) {
  views::prepareOpenGl();
  return argc;
}

}  // namespace

Application::Application(int& argc, char** argv) : QApplication(prepared(argc), argv) {
  initResources();
  setApplicationName(QStringLiteral("nineline"));
  setOrganizationName(QStringLiteral("nineline"));
  setApplicationDisplayName(QStringLiteral("Nineline"));
  setWindowIcon(QIcon(QStringLiteral(":/icons/nineline.svg")));
  setStyle(QStringLiteral("Fusion"));
  QLocale::setDefault(QLocale::c());
  QFile sheet(QStringLiteral(":/styles/nineline.qss"));
  if (sheet.open(QIODevice::ReadOnly)) setStyleSheet(QString::fromUtf8(sheet.readAll()));
}

bool Application::notify(QObject* receiver, QEvent* event) {
  try {
    return QApplication::notify(receiver, event);
  } catch (const std::exception& mistake) {
    reportMistake(QString::fromUtf8(mistake.what()));
  }
  return false;
}

void Application::reportMistake(const QString& text) {
  if (reporting_) return;
  reporting_ = true;
  const QString rescued = rescue_ ? rescue_() : QString();
  QMessageBox box(QMessageBox::Critical, tr("Mistake of the program"),
                  tr("Nineline made a mistake and stopped what it was doing. Your work is kept.") +
                      QLatin1Char('\n') + rescued,
                  QMessageBox::Ok);
  box.setDetailedText(text);
  box.exec();
  reporting_ = false;
}

}  // namespace nineline::shell
