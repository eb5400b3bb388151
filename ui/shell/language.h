#pragma once

#include <QString>
#include <QTranslator>
#include <vector>

namespace nineline::shell {

/// The languages of the window; switched without a restart.
class Language {
 public:
  struct Choice {
    QString code;  ///< "en", "zh_CN"
    QString name;  ///< in the language itself
  };
  [[nodiscard]] static std::vector<Choice> choices();
  /// Installs the translation; "" means that of the system.
  void use(const QString& code);
  [[nodiscard]] const QString& current() const { return current_; }

 private:
  QTranslator own_;
  QTranslator qt_;
  QString current_;
};

}  // namespace nineline::shell
