#include <QCommandLineParser>
#include <QTimer>
#include <exception>

#include "ui/shell/application.h"
#include "ui/shell/main_window.h"
#include "ui/shell/screenshots.h"

namespace {

using nineline::shell::Application;
using nineline::shell::MainWindow;

void openWhatIsAsked(MainWindow& window, const QCommandLineParser& parser, bool example) {
  if (!parser.positionalArguments().isEmpty()) {
    window.openProject(parser.positionalArguments().front());
  } else if (example || !window.restoreSession()) {
    window.openExample();
  }
}

int runWindow(Application& application) {
  QCommandLineParser parser;
  parser.addHelpOption();
  parser.addPositionalArgument(QStringLiteral("FILE"), QStringLiteral("A .nineline project to open."));
  const QCommandLineOption example(QStringLiteral("example"), QStringLiteral("Open the worked example."));
  const QCommandLineOption language(QStringLiteral("language"), QStringLiteral("en or zh_CN."),
                                    QStringLiteral("code"));
  QCommandLineOption screenshots(QStringLiteral("screenshots"), {}, QStringLiteral("folder"));
  screenshots.setFlags(QCommandLineOption::HiddenFromHelp);
  parser.addOptions({example, language, screenshots});
  parser.process(application);
  MainWindow window;
  application.setRescue([&window]() { return window.rescue(); });
  if (parser.isSet(language)) window.setLanguage(parser.value(language));
  window.show();
  openWhatIsAsked(window, parser, parser.isSet(example) || parser.isSet(screenshots));
  if (parser.isSet(screenshots)) nineline::shell::takeScreenshots(&window, parser.value(screenshots));
  return Application::exec();
}

}  // namespace

int main(int argc, char** argv) {
  Application application(argc, argv);
  try {
    return runWindow(application);
  } catch (const std::exception& mistake) {
    application.reportMistake(QString::fromUtf8(mistake.what()));
    return 1;
  }
}
