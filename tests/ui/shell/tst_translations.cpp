#include <QFile>
#include <QRegularExpression>
#include <QTest>
#include <QXmlStreamReader>

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
