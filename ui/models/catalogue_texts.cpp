#include "ui/models/catalogue_texts.h"

#include <QCoreApplication>

namespace nineline::models {

namespace {

QString paragraph(const QString& heading, std::string_view text) {
  if (text.empty()) return {};
  return QStringLiteral("<p style='margin:4px 0'><b>%1</b> %2</p>")
      .arg(heading.toHtmlEscaped(), catalogueText(text).toHtmlEscaped());
}

QString heading(const char* text) { return QCoreApplication::translate("catalogue", text); }

}  // namespace

QString catalogueText(std::string_view text) {
  return QCoreApplication::translate("catalogue", std::string(text).c_str());
}

QString shopFloorText(const errors::EffectSpec& spec) {
  return paragraph(heading(QT_TRANSLATE_NOOP("catalogue", "Cause:")), spec.shop_floor.cause) +
         paragraph(heading(QT_TRANSLATE_NOOP("catalogue", "Usual size:")), spec.shop_floor.size) +
         paragraph(heading(QT_TRANSLATE_NOOP("catalogue", "Remedy:")), spec.shop_floor.remedy);
}

}  // namespace nineline::models
