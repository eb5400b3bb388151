#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>

#include "core/kinematics/machine_file.h"
#include "ui/models/component_tree_model.h"
#include "ui/models/difference_model.h"
#include "ui/models/effect_entries.h"
#include "ui/models/error_table_model.h"
#include "ui/models/location_model.h"
#include "ui/models/spreadsheet.h"
#include "ui/models/summary_model.h"

using namespace nineline;

namespace {

constexpr auto kStrict = QAbstractItemModelTester::FailureReportingMode::QtTest;

const kinematics::Machine& grinder() { return *kinematics::findBuiltInMachine("b2-k3032"); }
errors::Component component(const char* name) { return *errors::parseComponent(name); }

}  // namespace

class TestItemModels : public QObject {
  Q_OBJECT

 private slots:
  void componentTree() {
    models::ComponentTreeModel model;
    const QAbstractItemModelTester tester(&model, kStrict);
    QCOMPARE(model.rowCount(), 0);
    model.setMachine(&grinder());
    QCOMPARE(model.rowCount(), grinder().jointCount() + 1);
    const QModelIndex ezz = model.indexOf(component("EZZ"));
    QVERIFY(ezz.data().toString().startsWith(QStringLiteral("EZZ  positioning error of Z")));
    QVERIFY(ezz.siblingAtColumn(1).data().toString().isEmpty());
    const Json entry = models::tableEntry(Json::array(), component("EZZ"), grinder());
    model.setEffects(models::withEntry(Json::array(), component("EZZ"), entry));
    QCOMPARE(ezz.siblingAtColumn(1).data().toString(), QStringLiteral("21"));
    model.setMachine(kinematics::findBuiltInMachine("trunnion-ac"));
    model.setMachine(nullptr);
    QCOMPARE(model.rowCount(), 0);
  }

  void tableTakesTypingAndMarksWhatIsWrong() {
    models::ErrorTableModel model;
    const QAbstractItemModelTester tester(&model, kStrict);
    QObject::connect(&model, &models::ErrorTableModel::entryEdited, &model, [&model](const Json& entry) {
      model.setEntry(grinder(), component("EZZ"), Json(entry));
    });
    model.setEntry(grinder(), component("EZZ"),
                   models::tableEntry(Json::array(), component("EZZ"), grinder()));
    QCOMPARE(model.rowCount(), 21);
    const QModelIndex cell = model.index(2, 1);
    QVERIFY(model.setData(cell, QStringLiteral("1,5"), Qt::EditRole));
    QCOMPARE(cell.data().toString(), QStringLiteral("1.5"));
    QVERIFY(!cell.data(Qt::UserRole).toBool());
    model.setData(cell, QStringLiteral("12o"), Qt::EditRole);
    QCOMPARE(cell.data(Qt::EditRole).toString(), QStringLiteral("12o"));
    QVERIFY(cell.data(Qt::UserRole).toBool());
    QVERIFY(!cell.data(Qt::ToolTipRole).toString().isEmpty());
    model.setData(cell, QStringLiteral("5000"), Qt::EditRole);
    QVERIFY(cell.data(Qt::UserRole).toBool());  // mm typed as µm
    QVERIFY(!model.setData(model.index(0, 0), QStringLiteral("3"), Qt::EditRole));
  }

  void tableTakesPastedColumns() {
    models::ErrorTableModel model;
    const QAbstractItemModelTester tester(&model, kStrict);
    QObject::connect(&model, &models::ErrorTableModel::entryEdited, &model, [&model](const Json& entry) {
      model.setEntry(grinder(), component("EZZ"), Json(entry));
    });
    model.setEntry(grinder(), component("EZZ"),
                   models::tableEntry(Json::array(), component("EZZ"), grinder()));
    QVERIFY(model.paste(models::cellsOf(QStringLiteral("1,5\n2,5\n")), 20).isEmpty());
    QCOMPARE(model.rowCount(), 22);
    QVERIFY(model.paste(models::cellsOf(QStringLiteral("Z\tEZZ\n0\t1\n10\t2\n20\t3\n")), 5).isEmpty());
    QCOMPARE(model.rowCount(), 3);
    QCOMPARE(*model.start(), 0.0);
    QCOMPARE(*model.spacing(), 10.0);
    QCOMPARE(model.points().back(), (std::pair{20.0, 3.0}));
    QVERIFY(!model.paste(models::cellsOf(QStringLiteral("0\t1\n10\t2\n25\t3\n")), 0).isEmpty());
    QVERIFY(!model.paste(models::cellsOf(QStringLiteral("10\t1\n0\t2\n")), 0).isEmpty());
    QCOMPARE(model.rowCount(), 3);
  }

  void locations() {
    models::LocationModel model;
    const QAbstractItemModelTester tester(&model, kStrict);
    QSignalSpy edited(&model, &models::LocationModel::valueEdited);
    model.setEffects(grinder(), grinder().find({'X', 0}),
                     models::withLocation(Json::array(), component("B0X"), Json(4.5)));
    QCOMPARE(model.rowCount(), 6);
    QCOMPARE(model.index(4, 1).data().toString(), QStringLiteral("4.5"));
    QCOMPARE(model.index(4, 2).data().toString(), QStringLiteral("″"));
    QVERIFY(model.setData(model.index(0, 1), QStringLiteral("3"), Qt::EditRole));
    QCOMPARE(edited.size(), 1);
  }

  void summary() {
    models::SummaryModel model;
    const QAbstractItemModelTester tester(&model, kStrict);
    simulation::DeviationSummary before;
    before.joints.resize(3);
    simulation::DeviationSummary after = before;
    before.joints[0] = {0.157, 0.1572, 0.18};
    after.joints[0] = {0.0, 0.001572, 0.002};
    model.setSummaries(grinder(), before, after);
    QCOMPARE(model.index(0, 1).data().toString(), QStringLiteral("157.0"));
    QCOMPARE(model.index(0, 7).data().toString(), QStringLiteral("99.0 %"));
    QVERIFY(model.toCsv().contains(QStringLiteral("157.0")));
    model.clear();
    QCOMPARE(model.rowCount(), 0);
  }

  void differencePairsLinesAndMeasuresWords() {
    models::DifferenceModel model;
    const QAbstractItemModelTester tester(&model, kStrict);
    model.setTexts(std::make_shared<const std::string>("%\nG01 X10.000 C90.000 F100\nM30\n"),
                   std::make_shared<const std::string>("%\nG01 X10.012 C89.999 F100\nX10.5\nM30\n"));
    QCOMPARE(model.rowCount(), 4);
    QCOMPARE(model.nextChange(-1), 1);
    QCOMPARE(model.index(1, 3).data().toString(), QStringLiteral("C −3.6″   X +12.0 µm"));
    QCOMPARE(model.index(2, 1).data().toString(), QString());
    QCOMPARE(model.index(2, 2).data().toString(), QStringLiteral("X10.5"));
    QCOMPARE(model.index(3, 1).data().toString(), QStringLiteral("M30"));
    QCOMPARE(model.nextChange(2), -1);
  }
};

QTEST_GUILESS_MAIN(TestItemModels)
#include "tst_item_models.moc"
