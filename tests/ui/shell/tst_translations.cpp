#include <QFile>
#include <QRegularExpression>
#include <QSet>
#include <QTest>
#include <QXmlStreamReader>

#include "core/errors/effect_spec.h"

/// Every text of the window has a finished Chinese translation with the same places for values.
class TestTranslations : public QObject {
  Q_OBJECT

 private slots:
  void chineseIsComplete() {
    QFile file(QStringLiteral(NINELINE_SOURCE_DIR "/translations/nineline_zh_CN.ts"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QXmlStreamReader xml(&file);
    QString source;
    int messages = 0;
    while (!xml.atEnd()) {
      if (xml.readNext() != QXmlStreamReader::StartElement) continue;
      if (xml.name() == QLatin1String("source")) {
        source = xml.readElementText();
      } else if (xml.name() == QLatin1String("translation")) {
        const QString type = xml.attributes().value(QLatin1String("type")).toString();
        const QString text = xml.readElementText();
        QVERIFY2(type.isEmpty(), qPrintable(source + QStringLiteral(" is ") + type));
        QVERIFY2(!text.isEmpty(), qPrintable(source));
        QVERIFY2(places(source) == places(text), qPrintable(source));
        ++messages;
      }
    }
    QVERIFY(!xml.hasError());
    QVERIFY(messages > 300);
  }

  /// The catalogue's texts live in core, where no tool finds them.
  void catalogueIsTranslated() {
    QFile file(QStringLiteral(NINELINE_SOURCE_DIR "/translations/nineline_zh_CN.ts"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QXmlStreamReader xml(&file);
    QSet<QString> known;
    while (!xml.atEnd()) {
      if (xml.readNext() != QXmlStreamReader::StartElement) continue;
      if (xml.name() == QLatin1String("source")) known.insert(xml.readElementText());
    }
    const auto check = [&known](std::string_view text) {
      const QString source = QString::fromUtf8(text.data(), static_cast<int>(text.size()));
      QVERIFY2(source.isEmpty() || known.contains(source), qPrintable(source));
    };
    for (const nineline::errors::EffectSpec& spec : nineline::errors::effectCatalogue()) {
      check(spec.title);
      check(spec.shop_floor.cause);
      check(spec.shop_floor.size);
      check(spec.shop_floor.remedy);
      for (const nineline::errors::LookAlike& other : spec.lookalikes) check(other.separated_by);
    }
  }

 private:
  static QStringList places(const QString& text) {
    static const QRegularExpression kPlace(QStringLiteral("%\\d"));
    QStringList found;
    auto matches = kPlace.globalMatch(text);
    while (matches.hasNext()) found << matches.next().captured();
    found.sort();
    return found;
  }
};

QTEST_GUILESS_MAIN(TestTranslations)
#include "tst_translations.moc"
