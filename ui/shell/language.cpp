#include "ui/shell/language.h"

#include <QApplication>
#include <QFont>
#include <QLibraryInfo>
#include <QLocale>

namespace nineline::shell {

namespace {

/// A font whose own letters are Chinese has the height that Chinese lines need.
void useFont(bool chinese) {
  static const QFont kUsual = QApplication::font();
  QFont font = kUsual;
  if (chinese) {
    font.setFamilies({QStringLiteral("Noto Sans CJK SC"), QStringLiteral("Microsoft YaHei"),
                      QStringLiteral("PingFang SC"), kUsual.family()});
  }
  if (QApplication::font() != font) QApplication::setFont(font);
}

}  // namespace

std::vector<Language::Choice> Language::choices() {
  return {{QStringLiteral("en"), QStringLiteral("English")},
          {QStringLiteral("zh_CN"), QStringLiteral("简体中文")}};
}

void Language::use(const QString& code) {
  const bool chinese = code.isEmpty() ? QLocale::system().language() == QLocale::Chinese
                                      : code.startsWith(QLatin1String("zh"));
  current_ = chinese ? QStringLiteral("zh_CN") : QStringLiteral("en");
  useFont(chinese);
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
