#include "core/measurement/column_mapping.h"

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/kinematics/machine_file.h"
#include "core/measurement/table_units.h"
#include "tests/core/measurement/set_ups.h"

namespace nineline::measurement {
namespace {

const Machine& grinder() { return *kinematics::findBuiltInMachine("b2-k3032"); }

ColumnMapping proposed(const std::string& text) {
  const Result<ColumnMapping> mapping = proposeMapping(text, "a.csv", grinder());
  if (!mapping) throw std::runtime_error(mapping.error().message());
  return *mapping;
}

ColumnMapping laserZ(ColumnMapping mapping) {
  mapping.instrument.kind = InstrumentKind::LaserLinear;
  mapping.instrument.axis = AxisId{'Z', 0};
  return mapping;
}

std::vector<std::string> idsOf(const std::vector<Question>& questions) {
  std::vector<std::string> ids;
  for (const Question& one : questions) ids.push_back(one.id);
  return ids;
}
using Ids = std::vector<std::string>;

TEST(TableUnits, AreReadFromHeaders) {
  EXPECT_EQ(unitInHeader("Target (mm)"), "mm");
  EXPECT_EQ(unitInHeader("Abweichung [µm]"), "um");
  EXPECT_EQ(unitInHeader("偏差（微米）"), "um");
  EXPECT_EQ(unitInHeader("dev_arcsec"), "arcsec");
  EXPECT_EQ(unitInHeader("Error"), std::nullopt);
  EXPECT_EQ(unitInHeader("Error (ppm)"), std::nullopt);
  EXPECT_DOUBLE_EQ(*factorOf("inch"), 25.4);
  EXPECT_DOUBLE_EQ(*factorOf("mrad"), 1e-3);
}

TEST(ColumnMapping, ReadsAGermanSpreadsheet) {
  const std::string text =
      "Prüfprotokoll;;\nSollwert Z [mm];Abweichung [µm];Bemerkung\n0,0;0,5;\n-100,5;1,25;ok\n-200,0;;\n";
  ColumnMapping mapping = laserZ(proposed(text));
  EXPECT_TRUE(mapping.decimal_comma);
  EXPECT_EQ(mapping.header_line, 2u);
  EXPECT_EQ(idsOf(openQuestions(mapping, grinder())), Ids{"meaning-3"}) << "nothing is assumed of a remark";
  EXPECT_TRUE(readMapped(text, "a.csv", mapping, grinder()).diagnostics.hasErrors());
  mapping.columns[2].meaning = Meaning::Ignored;
  const MeasurementReading reading = readMapped(text, "a.csv", mapping, grinder());
  ASSERT_FALSE(reading.diagnostics.hasErrors()) << reading.diagnostics.all().front().text;
  ASSERT_EQ(reading.measurement.samples.size(), 3u);
  EXPECT_EQ(reading.measurement.samples[1].q[0], -100.5);
  EXPECT_DOUBLE_EQ(*reading.measurement.readings[1], 1.25e-3);
  EXPECT_FALSE(reading.measurement.readings[2]);
}

TEST(ColumnMapping, AsksForWhatTheHeaderLeavesOpen) {
  const ColumnMapping mapping = laserZ(proposed("Target\tDeviation\n0\t1\n10\t2\n"));
  EXPECT_EQ(idsOf(openQuestions(mapping, grinder())), (Ids{"meaning-1", "meaning-2", "reading"}));
  const ColumnMapping without_axis = proposed("Target (mm);Deviation (um)\n0;1\n10;2\n");
  EXPECT_EQ(idsOf(openQuestions(without_axis, grinder())), Ids{"axis-1"});
  EXPECT_EQ(proposed("0;1;2\n10;2;3\n").header_line, 0u);
}

TEST(ColumnMapping, MakesDeviationsOfActualPositions) {
  const std::string text = "Target Z (inch),Measured (inch)\n0,0.0001\n10,10.0002\n";
  const ColumnMapping mapping = laserZ(proposed(text));
  ASSERT_EQ(idsOf(openQuestions(mapping, grinder())), Ids{});
  const MeasurementReading reading = readMapped(text, "a.csv", mapping, grinder());
  ASSERT_FALSE(reading.diagnostics.hasErrors());
  EXPECT_DOUBLE_EQ(reading.measurement.samples[1].q[0], 254.0);
  EXPECT_NEAR(*reading.measurement.readings[1], 0.0002 * 25.4, 1e-12);
}

TEST(ColumnMapping, NamesPlaceOfEachFault) {
  const std::string text = "Target Z (mm);Deviation (um)\n0;1\n10;n/a\n20;3;4\n";
  const MeasurementReading reading = readMapped(text, "a.csv", laserZ(proposed(text)), grinder());
  ASSERT_EQ(reading.diagnostics.all().size(), 2u);
  EXPECT_EQ(reading.diagnostics.all()[0].line, 3u);
  EXPECT_EQ(reading.diagnostics.all()[0].column, 4u);
  EXPECT_EQ(reading.diagnostics.all()[1].line, 4u);
  EXPECT_FALSE(proposeMapping("nothing here\n", "a", grinder()));
}

TEST(ColumnMapping, IsRememberedByItsLayout) {
  const ColumnMapping mapping = laserZ(proposed("Target Z (mm);Deviation (um);run\n0;1;1\n10;2;1\n"));
  const Result<ColumnMapping> again = mappingFromJson(mappingToJson(mapping), "settings");
  ASSERT_TRUE(again) << again.error().message();
  EXPECT_EQ(writeJson(mappingToJson(*again)), writeJson(mappingToJson(mapping)));
  EXPECT_EQ(layoutFingerprint(*again), layoutFingerprint(mapping));
  EXPECT_EQ(layoutFingerprint(proposed("Target Z (mm);Deviation (um);run\n5;9;2\n6;8;2\n")),
            layoutFingerprint(mapping));
  EXPECT_NE(layoutFingerprint(proposed("Target Z (mm);Error (um);run\n5;9;2\n6;8;2\n")),
            layoutFingerprint(mapping));
  EXPECT_FALSE(mappingFromJson(Json::object(), "settings"));
}

}  // namespace
}  // namespace nineline::measurement
