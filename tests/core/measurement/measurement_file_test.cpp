#include "core/measurement/measurement_file.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/units.h"
#include "core/kinematics/machine_file.h"
#include "tests/core/measurement/set_ups.h"

namespace nineline::measurement {
namespace {

const std::string kHead =
    "#nineline-measurement: 1\n#machine: b2-k3032\n#instrument: deviation\n#repeatability_um: 0.4\n";

/// "line:column code" of every error.
std::vector<std::string> errorsOf(const MeasurementReading& reading) {
  std::vector<std::string> errors;
  for (const Diagnostic& one : reading.diagnostics.all()) {
    if (one.severity != Severity::Error) continue;
    errors.push_back(std::to_string(one.line) + ":" + std::to_string(one.column) + " " + one.code);
  }
  return errors;
}

std::vector<std::string> errorsOf(const std::string& text) {
  return errorsOf(readMeasurement(text, "a.csv"));
}

std::string textsOf(const MeasurementReading& reading) {
  std::string texts;
  for (const Diagnostic& one : reading.diagnostics.all()) texts += one.text + "\n";
  return texts;
}

using Errors = std::vector<std::string>;

TEST(MeasurementFile, ReadsTheContractsExample) {
  const MeasurementReading reading = readMeasurement(
      kHead +
          "run,t_s,X_mm,Z_mm,C_deg,feed_mm_min,pass_1,temp_screw_Z_C,temp_bed_C,dev_x_um,dev_z_um\n"
          "1,0,100,-50,90,600,2,21.5,20.1,1.25,-3\n"
          "1,0.5,100,-40,180,600,2,,20.1,,-3.5\n",
      "a.csv");
  ASSERT_EQ(errorsOf(reading), Errors{}) << textsOf(reading);
  const Measurement& m = reading.measurement;
  ASSERT_EQ(m.samples.size(), 2u);
  EXPECT_EQ(m.machine_id, "b2-k3032");
  EXPECT_DOUBLE_EQ(*m.repeatability, 0.4e-3);
  EXPECT_EQ(m.samples[0].q[0], -50.0) << "Z is the first joint of the grinder";
  EXPECT_DOUBLE_EQ(m.samples[0].q[1], kPi / 2);
  EXPECT_EQ(m.samples[0].q[2], 100.0);
  EXPECT_EQ(m.samples[1].line, 7u);
  EXPECT_DOUBLE_EQ(*m.reading(0, 0), 1.25e-3);
  EXPECT_FALSE(m.reading(1, 0));
  EXPECT_DOUBLE_EQ(*m.reading(1, 1), -3.5e-3);
  EXPECT_EQ(m.value("temp_screw_Z_C", 0), 21.5);
  EXPECT_FALSE(m.value("temp_screw_Z_C", 1));
  EXPECT_EQ(m.run(0), 1.0);
}

TEST(MeasurementFile, TakesAnySeparatorLineEndAndByteOrderMark) {
  for (const char separator : {',', ';', '\t'}) {
    for (const std::string end : {"\n", "\r\n", "\r"}) {
      std::string text = "\xEF\xBB\xBF" + kHead + "Z_mm,dev_z_um\n1,2\n\n3, 4 \n";
      std::replace(text.begin(), text.end(), ',', separator);
      std::string converted;
      for (const char c : text) converted += c == '\n' ? end : std::string(1, c);
      const MeasurementReading reading = readMeasurement(converted, "a.csv");
      ASSERT_EQ(errorsOf(reading), Errors{}) << textsOf(reading);
      ASSERT_EQ(reading.measurement.samples.size(), 2u);
      EXPECT_DOUBLE_EQ(*reading.measurement.reading(1, 0), 4e-3);
    }
  }
}

TEST(MeasurementFile, KeepsWhatASpreadsheetAdds) {
  const MeasurementReading reading = readMeasurement(
      "#nineline-measurement: 1;;;\n#machine: b2-k3032;;;\n\"#instrument: deviation\";;;\n"
      "Z_mm;dev_z_um;operator;humidity_pct;\n1;2;\"Li; Wei\";40;\n;;;;\n3;\"4\";Li;41;\n",
      "a.csv");
  ASSERT_EQ(errorsOf(reading), Errors{}) << textsOf(reading);
  EXPECT_EQ(reading.measurement.samples.size(), 2u);
  EXPECT_EQ(reading.measurement.value("humidity_pct", 1), 41.0);
  EXPECT_EQ(reading.measurement.covariate("operator"), nullptr) << "text is left out, with a warning";
  EXPECT_NE(textsOf(reading).find("operator"), std::string::npos);
}

TEST(MeasurementFile, NamesPlaceAndRemedyOfEachFault) {
  const std::string body = kHead + "run,Z_mm,dev_z_um,temp_bed_C\n";
  EXPECT_EQ(errorsOf(body + "1,2,nan,20\n"), Errors{"6:5 measurement.number"});
  EXPECT_EQ(errorsOf(body + "1,inf,2,20\n"), Errors{"6:3 measurement.number"});
  EXPECT_EQ(errorsOf(body + "1,abc,2,20\n1.5,2,3,4\n"),
            (Errors{"6:3 measurement.number", "7:1 measurement.row"}));
  EXPECT_EQ(errorsOf(body + "1,2,3\n"), Errors{"6:0 measurement.row"});
  EXPECT_EQ(errorsOf(body + "1,2,3,20\n1,2,3,dead\n"), Errors{"7:7 measurement.number"});
  EXPECT_EQ(errorsOf(body), Errors{"5:0 measurement.row"}) << "no samples";
  EXPECT_EQ(errorsOf(kHead + "Z_mm;dev_z_um\n1;2,5\n"), Errors{"6:3 measurement.number"});
  EXPECT_NE(textsOf(readMeasurement(kHead + "Z_mm;dev_z_um\n1;2,5\n", "a")).find("decimal point"),
            std::string::npos);
  EXPECT_NE(textsOf(readMeasurement(kHead + "Z_mm,dev_z_um\n1,2,5\n", "a")).find("decimal sign"),
            std::string::npos);
  EXPECT_EQ(errorsOf(kHead + "Z_mm,dev_z_um,sigma_um\n1,2,0\n"), Errors{"6:5 measurement.sigma"});
  EXPECT_EQ(errorsOf(kHead + "Z_mm,approach_Z_1,dev_z_um\n1,2,0\n"), Errors{"6:3 measurement.row"});
}

TEST(MeasurementFile, RefusesColumnsThatCannotBe) {
  EXPECT_EQ(errorsOf(kHead + "Z_deg,dev_z_um\n1,2\n"), Errors{"5:1 measurement.columns"});
  EXPECT_EQ(errorsOf(kHead + "Z_mm,Z_mm,dev_z_um\n1,1,2\n"), Errors{"5:6 measurement.columns"});
  EXPECT_EQ(errorsOf(kHead + "Z_mm,dev_um\n1,2\n"), Errors{"5:0 measurement.columns"});
  const MeasurementReading other = readMeasurement(kHead + "Y_mm,Z_mm,dev_z_um\n5,1,2\n", "a.csv");
  EXPECT_EQ(errorsOf(other), Errors{});
  EXPECT_EQ(other.measurement.value("Y_mm", 0), 5.0) << "an axis that the machine lacks is a covariate";
}

TEST(MeasurementFile, RefusesWhatTheInstrumentNeeds) {
  const std::string version = "#nineline-measurement: 1\n#machine: b2-k3032\n";
  EXPECT_EQ(errorsOf("Z_mm,dev_um\n1,2\n"), Errors{"1:0 measurement.format"});
  EXPECT_EQ(errorsOf("#nineline-measurement: 2\n#machine: b2-k3032\n#instrument: deviation\ndev_z_um\n1\n"),
            Errors{"1:24 measurement.head"});
  EXPECT_EQ(errorsOf(version + "#instrument: laser\nZ_mm,dev_z_um\n1,2\n"), Errors{"3:14 measurement.head"});
  EXPECT_EQ(errorsOf(version + "#instrument: laser-linear\n#axis: C\n#point_mm: 0 0 0\nC_deg,dev_um\n1,2\n"),
            Errors{"4:8 measurement.head"});
  EXPECT_EQ(errorsOf(version + "#instrument: laser-linear\n#axis: Y\n#point_mm: 0 0\nZ_mm,dev_um\n1,2\n"),
            (Errors{"4:8 measurement.head", "5:12 measurement.head"}));
  EXPECT_EQ(errorsOf(version + "#instrument: ballbar\n#centre_mm: 0 0 0\nX_mm,dr_um\n1,2\n"),
            Errors{"1:0 measurement.head"});
  EXPECT_EQ(
      errorsOf(version + "#instrument: lead\n#pitch_mm: -1\n#starts: 1\n#hand: both\nZ_mm,dev_um\n1,2\n"),
      (Errors{"4:12 measurement.head", "6:8 measurement.head"}));
  EXPECT_EQ(
      errorsOf("#nineline-measurement: 1\n#machine: nobody\n#instrument: deviation\nZ_mm,dev_z_um\n1,2\n"),
      Errors{"2:0 measurement.machine"});
}

TEST(MeasurementFile, TheModelsMachineWins) {
  MeasurementReadOptions options;
  options.machine = kinematics::findBuiltInMachine("generic-3axis");
  const MeasurementReading reading = readMeasurement(kHead + "Y_mm,Z_mm,dev_z_um\n5,1,2\n", "a.csv", options);
  ASSERT_EQ(errorsOf(reading), Errors{});
  EXPECT_EQ(reading.measurement.samples[0].q[0], 5.0);
}

TEST(MeasurementFile, AStandInMachineKnowsTheAxesByTheirColumns) {
  MeasurementReadOptions options;
  options.allow_stand_in = true;
  const MeasurementReading reading = readMeasurement(
      "#nineline-measurement: 1\n#machine: shop-7\n#instrument: laser-linear\n#axis: X\n#point_mm: 0 0 0\n"
      "X_mm,B_deg,dev_um\n1,2,3\n",
      "a.csv", options);
  ASSERT_EQ(errorsOf(reading), Errors{}) << textsOf(reading);
  EXPECT_EQ(reading.machine->jointCount(), 2);
  EXPECT_TRUE(reading.machine->isRotary(1));
}

TEST(MeasurementFile, StopsAfterTwoHundredFaults) {
  std::string text = kHead + "Z_mm,dev_z_um\n";
  for (int i = 0; i < 1000; ++i) text += "x,y\n";
  EXPECT_EQ(errorsOf(text).size(), 200u);
}

TEST(MeasurementFile, DecodesGbkAndUtf16) {
  const std::string body = "Z_mm,dev_z_um\n1,2\n";
  // "#operator: 张三" in GBK.
  const MeasurementReading gbk = readMeasurement(kHead + "#operator: \xD5\xC5\xC8\xFD\n" + body, "a.csv");
  ASSERT_EQ(errorsOf(gbk), Errors{}) << textsOf(gbk);
  ASSERT_EQ(gbk.measurement.other_head.size(), 1u);
  EXPECT_EQ(gbk.measurement.other_head[0].second, "张三");
  std::string wide = "\xFF\xFE";
  for (const char c : kHead + body) wide += {c, '\0'};
  EXPECT_EQ(errorsOf(wide), Errors{});
  EXPECT_EQ(errorsOf(kHead + "#a: \xFF\xFF\n" + body), Errors{"0:0 text.encoding"});
  EXPECT_EQ(errorsOf(kHead + std::string("#a: \0\n", 6) + body), Errors{"5:0 text.encoding"});
}

TEST(MeasurementFile, MissingPositionsAreKeptAndSaid) {
  const MeasurementReading reading = readMeasurement(kHead + "X_mm,Z_mm,dev_z_um\n1,,2\n1,900,2\n", "a.csv");
  ASSERT_EQ(errorsOf(reading), Errors{});
  EXPECT_FALSE(reading.measurement.samples[0].has_positions);
  EXPECT_EQ(reading.diagnostics.all().size(), 2u) << "a missing position, one outside the travel";
}

TEST(MeasurementFile, WritesWhatItReads) {
  test_support::Random random(310);
  for (const char* id : {"b2-k3032", "generic-3axis", "trunnion-ac"}) {
    const Machine& machine = *kinematics::findBuiltInMachine(id);
    for (Measurement& measurement : everyInstrument(random, machine)) {
      measurement.machine_id = id;
      measurement.commanded.assign(static_cast<std::size_t>(machine.jointCount()), true);
      measurement.repeatability = 0.5e-3;
      measurement.instrument.plane = "XY";
      for (std::size_t i = 0; i < measurement.readings.size(); ++i) {
        if (i != 1) measurement.readings[i] = random.between(-1e-2, 1e-2);
      }
      measurement.samples[2].sigma = 1e-3;
      addColumn(measurement, "run", {1, 1, 2, 2});
      addColumn(measurement, "temp_bed_C", {20.5, std::nullopt, 21, 22});
      const std::string text = writeMeasurement(measurement, machine);
      const MeasurementReading again = readMeasurement(text, "a.csv");
      ASSERT_EQ(errorsOf(again), Errors{}) << textsOf(again) << text;
      EXPECT_EQ(writeMeasurement(again.measurement, machine), text);
      ASSERT_EQ(again.measurement.samples.size(), measurement.samples.size());
      for (std::size_t i = 0; i < measurement.samples.size(); ++i) {
        for (std::size_t j = 0; j < static_cast<std::size_t>(machine.jointCount()); ++j) {
          EXPECT_NEAR(again.measurement.samples[i].q[j], measurement.samples[i].q[j], 1e-9);
        }
      }
      EXPECT_EQ(again.measurement.instrument.axis, measurement.instrument.axis);
    }
  }
}

}  // namespace
}  // namespace nineline::measurement
