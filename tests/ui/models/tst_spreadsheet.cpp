#include <QTest>

#include "ui/models/spreadsheet.h"

using nineline::models::cellFromTyped;
using nineline::models::cellsOf;
using nineline::models::numberFromTyped;

class TestSpreadsheet : public QObject {
  Q_OBJECT

 private slots:
  void numbers_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<double>("value");
    QTest::newRow("point") << "1.25" << 1.25;
    QTest::newRow("comma") << "1,25" << 1.25;
    QTest::newRow("blanks") << "  -3 " << -3.0;
    QTest::newRow("typographic minus") << QStringLiteral("−4,5") << -4.5;
    QTest::newRow("exponent") << "1e-3" << 0.001;
  }
  void numbers() {
    QFETCH(QString, typed);
    QFETCH(double, value);
    QVERIFY(numberFromTyped(typed).has_value());
    QCOMPARE(*numberFromTyped(typed), value);
  }

  void noNumbers_data() {
    QTest::addColumn<QString>("typed");
    for (const char* typed : {"", "abc", "1.2.3", "1,2,3", "1,234.5", "nan", "inf", "1 2"}) {
      QTest::newRow(typed) << typed;
    }
  }
  void noNumbers() {
    QFETCH(QString, typed);
    QVERIFY(!numberFromTyped(typed));
  }

  void badCellsKeepWhatWasTyped() {
    QCOMPARE(*cellFromTyped(QStringLiteral(" 12o ")).string(), std::string("12o"));
    QVERIFY(cellFromTyped(QStringLiteral("  ")).isNull());
  }

  void columns_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QStringList>("first");
    QTest::addColumn<int>("rows");
    QTest::newRow("tabs and line feeds") << "0\t1.5\n25\t1.7\n" << QStringList{"0", "1.5"} << 2;
    QTest::newRow("carriage returns") << "0\t1,5\r\n25\t1,7\r\n" << QStringList{"0", "1,5"} << 2;
    QTest::newRow("semicolons, decimal commas") << "0;1,5\n25;1,7" << QStringList{"0", "1,5"} << 2;
    QTest::newRow("comma separated") << "0,1.5\n25,1.7" << QStringList{"0", "1.5"} << 2;
    QTest::newRow("one column of decimal commas") << "1,5\n1,7\n" << QStringList{"1,5"} << 2;
    QTest::newRow("quotes and byte order mark")
        << QStringLiteral("\uFEFF\"0\";\"2\"") << QStringList{"0", "2"} << 1;
    QTest::newRow("trailing empty lines") << "1\n2\n\n\n" << QStringList{"1"} << 2;
  }
  void columns() {
    QFETCH(QString, text);
    QFETCH(QStringList, first);
    QFETCH(int, rows);
    const auto cells = cellsOf(text);
    QCOMPARE(static_cast<int>(cells.size()), rows);
    QCOMPARE(cells.front(), first);
  }
};

QTEST_GUILESS_MAIN(TestSpreadsheet)
#include "tst_spreadsheet.moc"
