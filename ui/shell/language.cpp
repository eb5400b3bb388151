#include "ui/shell/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>

namespace nineline::shell {

std::vector<Language::Choice> Language::choices() {
  return {{QStringLiteral("en"), QStringLiteral("English")},
          {QStringLiteral("zh_CN"), QStringLiteral("简体中文")}};
}

void Language::use(const QString& code) {
  const bool chinese = code.isEmpty() ? QLocale::system().language() == QLocale::Chinese
                                      : code.startsWith(QLatin1String("zh"));
  current_ = chinese ? QStringLiteral("zh_CN") : QStringLiteral("en");
  QCoreApplication::removeTranslator(&own_);
  QCoreApplication::removeTranslator(&qt_);
  if (!chinese) return;
#if QT_VERSION >= QT_VERSION_CHECK(6, 0, 0)
  const QString folder = QLibraryInfo::path(QLibraryInfo::TranslationsPath);
#else
  const QString folder = QLibraryInfo::location(QLibraryInfo::TranslationsPath);
#endif
  if (qt_.load(QStringLiteral("qtbase_zh_CN"), folder)) QCoreApplication::installTranslator(&qt_);
  if (own_.load(QStringLiteral(":/i18n/nineline_zh_CN.qm"))) QCoreApplication::installTranslator(&own_);
}

}  // namespace nineline::shell
