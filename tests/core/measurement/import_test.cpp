#include "core/measurement/import.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "core/base/units.h"
#include "core/errors/table_effects.h"
#include "core/kinematics/machine_file.h"
#include "tests/core/measurement/set_ups.h"

namespace nineline::measurement {
namespace {

const Machine& grinder() { return *kinematics::findBuiltInMachine("b2-k3032"); }
const Machine& mill() { return *kinematics::findBuiltInMachine("generic-3axis"); }

std::string rtl(const std::string& kind, const std::string& axis, const std::string& rows) {
  return "HEADER::\r\nFile type: " + kind +
         "\r\nOwner: \r\nVersion no: 2\r\nTARGET DATA::\r\nFiletype: 1\r\nTarget-count:3\r\nTargets :\r\n"
         "0.0000 100.0000\r\n200.0000\r\nFlags: 0\r\nUSER-TEXT::\r\nMachine: B2\r\nSerial "
         "No:\r\nDate:2024-05-01\r\nAxis: " +
         axis + "\r\nRUNS::\r\nRun-count:2\r\nDEVIATIONS::\r\nRun Target Data:\r\n" + rows +
         "ENVIRONMENT::\r\nTemperature: 20\r\nEOF::\r\n";
}
const std::string kRows = "1 1 0.0\r\n1 2 1.5\r\n1 3 3.0\r\n2 1 0.5\r\n2 2 2.5\r\n2 3 4.5\r\n";

std::vector<std::string> questionsOf(const Import& import) {
  std::vector<std::string> ids;
  for (const Question& one : import.questions) ids.push_back(one.id);
  return ids;
}
using Ids = std::vector<std::string>;

std::string faultsOf(const Import& import) {
  std::string text;
  for (const Diagnostic& one : import.diagnostics.all()) {
    if (one.severity == Severity::Error)
      text += std::to_string(one.line) + " " + one.code + ": " + one.text + "\n";
  }
  return text;
}

TEST(Import, KnowsFormatsByTheirContent) {
  EXPECT_EQ(formatOf(rtl("Linear", "Z", kRows)), "renishaw-rtl");
  EXPECT_EQ(formatOf("HEADER::\r\nActual sample rate:1000\r\nData:\r\n"), "renishaw-rtx");
  EXPECT_EQ(formatOf("<?xml version=\"1.0\"?>\n<TEST><TEST_SPEC NAME=\"a\"/></TEST>"), "renishaw-b5r");
  EXPECT_EQ(formatOf("// a\n[C0B]\nVALUE = 1e-5\n"), "etalon");
  EXPECT_EQ(formatOf("X Y Z EXX EYY\n0 0 0 0 0\n"), "isg-csv");
  EXPECT_EQ(formatOf("#nineline-measurement: 1\n"), "nineline");
  EXPECT_EQ(formatOf("Target;Deviation\n0;1\n"), "table");
  EXPECT_EQ(formatOf(""), "");
}

TEST(Import, RtlAsksBeforeItReads) {
  const Import open = importFile(rtl("Linear", "Z", kRows), "a.rtl", grinder(), {});
  EXPECT_EQ(faultsOf(open), "");
  EXPECT_EQ(questionsOf(open), (Ids{"point", "direction"}));
  EXPECT_TRUE(open.measurements.empty());
  EXPECT_EQ(questionsOf(importFile(rtl("Laser", "?", kRows), "a.rtl", grinder(), {})),
            (Ids{"axis", "kind", "point", "direction"}));
  EXPECT_EQ(questionsOf(importFile(rtl("Angular", "Z", kRows), "a.rtl", grinder(), {})),
            (Ids{"angle-unit", "about", "direction"}));
}

TEST(Import, RtlInTheOrderInWhichItWasTaken) {
  const Import import = importFile(rtl("Linear", "Z", kRows), "a.rtl", grinder(),
                                   {{"point", "0 50 0"}, {"direction", "alternate"}});
  ASSERT_TRUE(import.isComplete()) << faultsOf(import);
  const Measurement& m = import.measurements.front();
  EXPECT_EQ(m.instrument.kind, InstrumentKind::LaserLinear);
  EXPECT_EQ(m.instrument.point.y(), 50.0);
  std::vector<double> z;
  for (const Sample& sample : m.samples) z.push_back(sample.q[0]);
  EXPECT_EQ(z, (std::vector<double>{0, 100, 200, 200, 100, 0}));
  EXPECT_DOUBLE_EQ(*m.readings[3], 4.5e-3);
  EXPECT_EQ(m.value("approach_Z_1", 3), -1.0);
  EXPECT_EQ(m.run(3), 2.0);
}

TEST(Import, RtlAngularDeviationsInTheAnsweredUnit) {
  const std::map<std::string, double> units = {
      {"mrad", 1.5e-3}, {"urad", 1.5e-6}, {"arcsec", radFromArcsec(1.5)}};
  for (const auto& [unit, wanted] : units) {
    const Import import = importFile(rtl("Angular", "C", kRows), "a.rtl", grinder(),
                                     {{"angle-unit", unit}, {"about", "Z"}, {"direction", "forward"}});
    ASSERT_TRUE(import.isComplete()) << faultsOf(import);
    const Measurement& m = import.measurements.front();
    EXPECT_DOUBLE_EQ(*m.readings[1], wanted);
    EXPECT_DOUBLE_EQ(m.samples[1].q[1], radFromDeg(100.0)) << "targets of a rotary axis are degrees";
    EXPECT_EQ(m.instrument.about, 2);
  }
}

TEST(Import, RtlSuggestsThePairingThatTheScatterShows) {
  std::string rows;
  for (int run = 1; run <= 4; ++run) {
    for (int target = 1; target <= 3; ++target) {
      const double value = target + (run % 2 == 0 ? 6.0 : 0.0) + 0.1 * run;
      rows += std::to_string(run) + " " + std::to_string(target) + " " + std::to_string(value) + "\r\n";
    }
  }
  const Import import = importFile(rtl("Linear", "Z", rows), "a.rtl", grinder(), {{"point", "0 0 0"}});
  ASSERT_EQ(questionsOf(import), Ids{"direction"});
  EXPECT_EQ(import.questions[0].likeliest, "alternate");
  EXPECT_EQ(
      importFile(rtl("Linear", "Z", kRows), "a.rtl", grinder(), {{"point", "0 0 0"}}).questions[0].likeliest,
      std::nullopt);
}

TEST(Import, RtlNamesItsFaults) {
  const auto faults = [](const std::string& rows) {
    return faultsOf(importFile(rtl("Linear", "Z", rows), "a.rtl", grinder(), {}));
  };
  EXPECT_NE(faults("1 1 0,5\r\n").find("decimal sign"), std::string::npos) << faults("1 1 0,5\r\n");
  EXPECT_NE(faults("1 4 0.5\r\n").find("not among 3"), std::string::npos);
  EXPECT_NE(faults("1 1 0.5\r\n1 1 0.6\r\n").find("twice"), std::string::npos);
  EXPECT_NE(faults("1 1 nan\r\n").find("rtl.number"), std::string::npos);
  EXPECT_NE(faults("").find("Run Target Data"), std::string::npos);
  const Import half =
      importFile(rtl("Linear", "Z", "1 1 0\r\n1 2 0\r\n1 3 0\r\n2 1 0\r\n"), "a.rtl", grinder(), {});
  EXPECT_EQ(half.diagnostics.all().size(), 1u) << "half a run is a warning";
  const Import wrong = importFile(rtl("Linear", "Z", kRows), "a.rtl", grinder(), {{"direction", "odd"}});
  EXPECT_NE(faultsOf(wrong).find("expected one of alternate"), std::string::npos);
}

std::string rtx(const std::vector<double>& values, int stated, bool closed = true) {
  std::string bytes = "HEADER::\r\nOwner: \r\nVelocity: 1000\r\nSample no: " + std::to_string(stated) +
                      "\r\nActual sample rate: 2000.0\r\nAxis: X\r\nData:\r\n";
  for (const double value : values) {
    char raw[8];
    std::memcpy(raw, &value, 8);
    bytes.append(raw, 8);
  }
  return bytes + (closed ? "EOF::\r\n" : "");
}

TEST(Import, RtxIsARecordingAgainstTime) {
  const std::vector<double> values = {0.0, 1.25, -3.5, 1e-3};
  EXPECT_EQ(questionsOf(importFile(rtx(values, 4), "a.rtx", mill(), {})), Ids{"rtx-unit"});
  const Import import = importFile(rtx(values, 4), "a.rtx", mill(), {{"rtx-unit", "mm"}});
  ASSERT_TRUE(import.isComplete()) << faultsOf(import);
  EXPECT_EQ(import.recording->values, values);
  EXPECT_DOUBLE_EQ(import.recording->step, 0.0005);
  EXPECT_EQ(import.recording->axis, "X");
  EXPECT_NE(faultsOf(importFile(rtx(values, 9, false), "a.rtx", mill(), {})).find("cut off"),
            std::string::npos);
}

TEST(Import, B5rHoldsTheInstrumentsFigures) {
  const std::string text =
      "<?xml version=\"1.0\"?>\n<!-- a > b -->\n<BALLBAR>\n<TEST_SPEC NAME=\"XY 100 &amp; "
      "back\"/>\n<OPERATOR>Li</OPERATOR>\n"
      "<PLANE TEST_PLANE=\"XY\"/>\n<FEATURE NAME=\"Backlash X+\" DT=\"um\">3.2</FEATURE>\n"
      "<FEATURE NAME=\"Machine class\">good</FEATURE>\n</BALLBAR>\n";
  const Import import = importFile(text, "a.b5r", mill(), {});
  ASSERT_TRUE(import.isComplete()) << faultsOf(import);
  ASSERT_EQ(import.figures.size(), 2u);
  EXPECT_EQ(import.figures[0].value, 3.2);
  EXPECT_FALSE(import.figures[1].value);
  EXPECT_EQ(import.head[0].second, "XY 100 & back");
  EXPECT_NE(faultsOf(importFile("<A><TEST_SPEC NAME=\"x\"/><FEATURE", "a", mill(), {})).find("not closed"),
            std::string::npos);
}

TEST(Import, EtalonTablesBecomeEffects) {
  const std::string text =
      "// from the field\n[C0Y]\nVALUE = 0.0000223\n[EXY]\nGridpoints = {\n  -20.0 -0.001\n  -10.0 0.002 // "
      "c\n"
      "   10.0 0.004\n}  // end of EXY\n";
  EXPECT_EQ(questionsOf(importFile(text, "a", mill(), {})), Ids{"table-sign"});
  const Import import = importFile(text, "a", mill(), {{"table-sign", "error"}});
  ASSERT_TRUE(import.isComplete()) << faultsOf(import);
  ASSERT_EQ(import.effects.size(), 2u);
  const auto& location = dynamic_cast<const errors::LocationEffect&>(*import.effects[0]);
  EXPECT_DOUBLE_EQ(location.value(), 2.23e-5);
  const errors::ErrorTable& table = *import.effects[1]->table();
  EXPECT_NEAR(table.value(-20.0), -0.001, 1e-15);
  EXPECT_NEAR(table.value(0.0), 0.003, 1e-15) << "linear between uneven points";
  const Import turned = importFile(text, "a", mill(), {{"table-sign", "correction"}});
  EXPECT_NEAR(turned.effects[1]->table()->value(10.0), -0.004, 1e-15);
}

TEST(Import, EtalonAndIsgNameTheirFaults) {
  const Answers error = {{"table-sign", "error"}};
  const auto faults = [&](const std::string& text) { return faultsOf(importFile(text, "a", mill(), error)); };
  EXPECT_NE(faults("[EXB]\nGridpoints = { 0 1 }\n").find("lacks"), std::string::npos);
  EXPECT_NE(faults("[EXY]\nGridpoints = { 0 1 2 }\n").find("pairs"), std::string::npos);
  EXPECT_NE(faults("[EXY]\nGridpoints = { 0 1\n").find("cut off"), std::string::npos);
  EXPECT_NE(faults("[EXY]\nGridpoints = { 0 x }\n").find("'x'"), std::string::npos);
  EXPECT_NE(faults("X EYY\n0 1\n").find("needs a column Y"), std::string::npos);
  EXPECT_NE(faults("X Y EXX\n0 0 1\n0 5 2\n").find("another value"), std::string::npos);
  EXPECT_NE(faults("X EXX\n0 1 3\n").find("expected 2"), std::string::npos);
}

TEST(Import, IsgGridOfSeveralAxes) {
  const Import import =
      importFile("X,Y,EXX,EYY\n0,0,0.001,0.002\n0,50,0.001,0.004\n100,0,0.003,0.002\n100,50,0.003,0.004\n",
                 "a", mill(), {{"table-sign", "error"}});
  ASSERT_TRUE(import.isComplete()) << faultsOf(import);
  ASSERT_EQ(import.effects.size(), 2u);
  EXPECT_NEAR(import.effects[0]->table()->value(50.0), 0.002, 1e-15);
  EXPECT_NEAR(import.effects[1]->table()->value(50.0), 0.004, 1e-15);
}

}  // namespace
}  // namespace nineline::measurement
