#include <QTest>

#include "core/base/units.h"
#include "core/kinematics/machine_file.h"
#include "ui/models/document.h"
#include "ui/models/effect_entries.h"
#include "ui/models/error_curve.h"

using namespace nineline;
using models::Document;

namespace {

const kinematics::Machine& grinder() { return *kinematics::findBuiltInMachine("b2-k3032"); }

Document sample() {
  Document document;
  document.machine_text = writeJson(kinematics::machineToJson(grinder()));
  document.program_name = "a.nc";
  document.program = std::make_shared<const std::string>("G01 X1\n");
  return document;
}

errors::Component component(const char* name) { return *errors::parseComponent(name); }

}  // namespace

class TestDocument : public QObject {
  Q_OBJECT

 private slots:
  void comesBackFromJson() {
    Document document = sample();
    document.effects = models::withLocation(document.effects, component("B0X"), Json(4.1));
    document.options.set("tolerance_um", 2.5);
    document.readings.push_back({"z.csv", std::make_shared<const std::string>("#axis: Z\nZ_mm,dev_um\n")});
    const Result<Document> back = models::documentFromJson(models::documentToJson(document));
    QVERIFY(back);
    QVERIFY(!models::differences(document, *back).any());
  }

  void tellsWhatDiffers() {
    Document changed = sample();
    changed.options.set("tolerance_um", 2.0);
    const models::Changes changes = models::differences(sample(), changed);
    QVERIFY(changes.options);
    QVERIFY(!changes.machine && !changes.effects && !changes.program && !changes.setup);
  }

  void changedReadingsAreNoticed() {
    Document one = sample();
    one.readings.push_back({"z.csv", std::make_shared<const std::string>("1\n")});
    Document other = one;
    QVERIFY(!models::differences(one, other).any());
    other.readings[0].text = std::make_shared<const std::string>("2\n");
    QVERIFY(models::differences(one, other).readings);
  }

  void aBadValueIsKeptAndCoreRefusesIt() {
    Document document = sample();
    Json entry = models::tableEntry(document.effects, component("EZZ"), grinder());
    Json values = *entry.find("values_um");
    (*values.items())[3] = Json("12o");
    entry.set("values_um", values);
    document.effects = models::withEntry(document.effects, component("EZZ"), entry);
    const auto model = models::modelOf(document);
    QVERIFY(!model);
    QVERIFY(QString::fromStdString(model.error().text).contains(QStringLiteral("12o")));
  }

  void newTableSpansTheTravel() {
    const Json entry = models::tableEntry(Json::array(), component("EZZ"), grinder());
    QCOMPARE(*entry.find("start_mm")->number(), -400.0);
    const double spacing = *entry.find("spacing_mm")->number();
    QCOMPARE(-400.0 + spacing * static_cast<double>(entry.find("values_um")->items()->size() - 1), 400.0);
    const Json turn = models::tableEntry(Json::array(), component("ECC"), grinder());
    QCOMPARE(*turn.find("spacing_deg")->number() *
                 static_cast<double>(turn.find("values_arcsec")->items()->size()),
             360.0);
  }

  void curvePassesThroughTheNodes() {
    Json entry = models::tableEntry(Json::array(), component("EZZ"), grinder());
    Json::Array values(21, Json(0.0));
    values[10] = Json(5.0);
    entry.set("values_um", Json(values));
    const auto curve = models::sampleTable(grinder(), component("EZZ"), entry);
    QVERIFY(!curve.x.empty());
    double nearest = 1e9;
    double value = 0.0;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      if (std::abs(curve.x[i]) < nearest) nearest = std::abs(curve.x[i]), value = curve.y[i];
    }
    QVERIFY(nearest < 2.0);
    QVERIFY(std::abs(value - 5.0) < 0.1);
  }

  void anotherMachineKeepsWhatItCanUse() {
    Json effects = models::withLocation(Json::array(), component("C0X"), Json(1.0));
    effects.push(models::newEffect("backlash", grinder(), grinder().find({'Z', 0})));
    effects.push(models::newEffect("backlash", grinder(), grinder().find({'C', 0})));
    const Json kept = models::effectsFor(*kinematics::findBuiltInMachine("generic-3axis"), effects);
    QCOMPARE(kept.items()->size(), std::size_t{2});
  }

  void setupConvertsUnitsAndRefusesText() {
    Document document = sample();
    Json start = Json::object();
    start.set("C", 90.0);
    start.set("X", 12.5);
    document.setup.set("start", start);
    const auto setup = models::setupOf(document, grinder());
    QVERIFY(setup);
    QCOMPARE(setup->start[static_cast<std::size_t>(grinder().find({'C', 0}))], kPi / 2.0);
    QCOMPARE(setup->start[static_cast<std::size_t>(grinder().find({'X', 0}))], 12.5);
    start.set("X", "12o");
    document.setup.set("start", start);
    QVERIFY(!models::setupOf(document, grinder()));
  }

  void optionsAreCheckedAndConverted() {
    Document document = sample();
    document.options.set("tolerance_um", 2.0);
    document.options.set("mode", "thread");
    document.options.set("linear_decimals", 6);
    const auto options = models::optionsOf(document);
    QVERIFY(options);
    QCOMPARE(options->tolerance, 2e-3);
    QVERIFY(options->mode == compensation::Mode::Thread);
    QCOMPARE(*options->linear_decimals, 6);
    for (const double bad : {0.0, -1.0}) {
      document.options.set("tolerance_um", bad);
      QVERIFY(!models::optionsOf(document));
    }
    document.options.set("tolerance_um", 1.0);
    document.options.set("linear_decimals", 12);
    QVERIFY(!models::optionsOf(document));
  }
};

QTEST_GUILESS_MAIN(TestDocument)
#include "tst_document.moc"
