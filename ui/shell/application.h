#pragma once

#include <QApplication>
#include <functional>

namespace nineline::shell {

/// The application object: style, resources, and the last boundary for mistakes of the program inside event
/// handlers.
class Application : public QApplication {
  Q_OBJECT

 public:
  Application(int& argc, char** argv);
  bool notify(QObject* receiver, QEvent* event) override;
  /// Called after a mistake of the program: saves what can be saved and says what was done with it.
  void setRescue(std::function<QString()> rescue) { rescue_ = std::move(rescue); }
  /// Tells the person about a mistake of the program and offers to save the project.
  void reportMistake(const QString& text);

 private:
  std::function<QString()> rescue_;
  bool reporting_ = false;
};

}  // namespace nineline::shell
