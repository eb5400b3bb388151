#include "core/postprocessing/cl_reader.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

namespace nineline::postprocessing {
namespace {

ClProgram read(std::string_view text) {
  Result<ClProgram> program = readClData(text, "part.cls");
  EXPECT_TRUE(program) << program.error().message();
  return program ? *program : ClProgram{};
}
std::string faultOf(std::string_view text) {
  const Result<ClProgram> program = readClData(text, "part.cls");
  return program ? "none" : program.error().message();
}

TEST(ClReader, ReadsPointsWithCommasOrBlanks) {
  const ClProgram program = read(
      "PARTNO BLADE 7\nFEDRAT/600.0,MMPM\nGOTO/1.0,2.0,3.0,0,0,1\n"
      "GOTO / 4 5.5  -6 0.6 0 0.8 $$ note\nRAPID\nGOTO/7,8,9\nGOTO/7,8,10\nFINI\n");
  ASSERT_EQ(program.points.size(), 4U);
  EXPECT_EQ(program.name, "BLADE 7");
  EXPECT_EQ(program.points[1].tip, Vector3d(4.0, 5.5, -6.0));
  EXPECT_LT((program.points[1].axis - Vector3d(0.6, 0.0, 0.8)).norm(), 1e-15);
  EXPECT_EQ(program.points[1].line, 4U);
  EXPECT_DOUBLE_EQ(*program.points[0].feed, 10.0);  // 600 mm/min
  EXPECT_FALSE(program.points[1].rapid);
  EXPECT_TRUE(program.points[2].rapid);
  EXPECT_EQ(program.points[2].axis, program.points[1].axis);  // stays in force
  EXPECT_FALSE(program.points[3].rapid);                      // RAPID holds for one motion
}

TEST(ClReader, JoinsContinuedLinesAndKeepsPlaces) {
  const ClProgram program = read("FEDRAT/10\nGOTO/1,2,3, $ the axis follows\n 0.0,0.0,$\n1.0\nGOTO/0,0,0\n");
  ASSERT_EQ(program.points.size(), 2U);
  EXPECT_EQ(program.points[0].tip, Vector3d(1, 2, 3));
  EXPECT_EQ(faultOf("FEDRAT/10\nGOTO/1,2,3,$\n 0.0,zero,1.0\n"),
            "part.cls:3:6: GOTO needs a number, found 'zero'.");
}

TEST(ClReader, IncrementsAndUnits) {
  const ClProgram program =
      read("UNITS/INCHES\nFEDRAT/IPM,10\nFROM/0,0,1\nGODLTA/1,0,0\nUNITS/MM\nGODLTA/0,1,0\nGODLTA/-2\n");
  ASSERT_EQ(program.points.size(), 4U);
  EXPECT_EQ(program.points[0].kind, ClPoint::Kind::From);
  EXPECT_EQ(program.goto_count, 3U);
  EXPECT_LT((program.points[1].tip - Vector3d(25.4, 0, 25.4)).norm(), 1e-12);
  EXPECT_LT((program.points[2].tip - Vector3d(25.4, 1, 25.4)).norm(), 1e-12);
  EXPECT_LT((program.points[3].tip - Vector3d(25.4, 1, 23.4)).norm(), 1e-12);
  EXPECT_NEAR(*program.points[1].feed, 254.0 / 60.0, 1e-12);
}

TEST(ClReader, PassesUnknownStatementsWithAWarning) {
  const ClProgram program = read("FEDRAT/10\nWIDGET/ON,3\nPPRINT ROUGH THE HUB\nGOTO/1,2,3\nWIDGET/OFF\n");
  ASSERT_EQ(program.events.size(), 3U);
  EXPECT_EQ(program.events[0].text, "WIDGET/ON,3");
  EXPECT_EQ(program.events[1].text, "ROUGH THE HUB");
  EXPECT_EQ(program.events[2].before, 1U);
  ASSERT_EQ(program.warnings.all().size(), 1U);
  EXPECT_EQ(program.warnings.all()[0].count, 2U);
}

TEST(ClReader, ReadsMachineFunctions) {
  const ClProgram program = read(
      "LOADTL/5,LENGTH,120.\nSPINDL/1200,RPM,CCLW\nCOOLNT/FLOOD\nFEDRAT/0.1,MMPR\nGOTO/1,2,3\nDELAY/2.5\n"
      "COOLNT/OFF\nSPINDL/OFF\nSTOP\nFINI\n");
  ASSERT_EQ(program.events.size(), 7U);
  EXPECT_EQ(program.events[0].value, 5.0);
  EXPECT_EQ(program.events[1].value, 1200.0);
  EXPECT_EQ(program.events[1].choice, -1);
  EXPECT_EQ(program.events[3].kind, ClEvent::Kind::Dwell);
  EXPECT_EQ(program.points[0].feed_kind, ClFeed::PerRevolution);
  EXPECT_DOUBLE_EQ(*program.points[0].feed, 0.1);
}

TEST(ClReader, ExpandsArcsWithinTheirTolerance) {
  ClOptions options;
  options.arc_tolerance = 0.002;
  const Result<ClProgram> program = readClData(
      "FEDRAT/100\nGOTO/60,20,5,0,0,1\nCIRCLE/10,20,5,0,0,1,50\nGOTO/10,70,5\n", "part.cls", options);
  ASSERT_TRUE(program);
  const auto& points = program->points;
  ASSERT_GT(points.size(), 10U);
  EXPECT_EQ(program->goto_count, 2U);
  const Vector3d centre(10, 20, 5);
  for (std::size_t i = 1; i < points.size(); ++i) {
    EXPECT_NEAR((points[i].tip - centre).norm(), 50.0, 1e-9);
    EXPECT_GT(points[i].tip.y(), points[i - 1].tip.y());  // counter-clockwise, a quarter
    const double sagitta = 50.0 - (0.5 * (points[i].tip + points[i - 1].tip) - centre).norm();
    EXPECT_LE(sagitta, 0.002);
    EXPECT_GT(sagitta, 0.0005);  // and not far too many
  }
  EXPECT_EQ(points.back().kind, ClPoint::Kind::Goto);
}

TEST(ClReader, DrillsAlongTheToolAxis) {
  const ClProgram program = read(
      "FEDRAT/100\nCYCLE/DEEP,DEPTH,10,CLEAR,2,STEP,5,MMPM,60\nGOTO/1,0,0,1,0,0\nCYCLE/OFF\nGOTO/9,0,0\n");
  std::vector<double> x;
  for (const ClPoint& point : program.points) x.push_back(point.tip.x());
  EXPECT_EQ(x, (std::vector<double>{3, -4, 3, -3.5, -9, 3, 9}));
  EXPECT_TRUE(program.points[0].rapid);
  EXPECT_FALSE(program.points[1].rapid);
  EXPECT_DOUBLE_EQ(*program.points[1].feed, 1.0);
  EXPECT_EQ(program.goto_count, 2U);
}

TEST(ClReader, ReadsATable) {
  const ClProgram program =
      read("x_mm;y_mm;z_mm;i_1;j_1;k_1;feed_mm_min\n1;2;3;0;0;1;600\r\n4;5;6;0;1;0;\n\n7;8;9;;;;300\n");
  ASSERT_EQ(program.points.size(), 3U);
  EXPECT_EQ(program.points[2].axis, Vector3d::UnitY());
  EXPECT_DOUBLE_EQ(*program.points[1].feed, 10.0);
  EXPECT_EQ(faultOf("x_mm,y_mm,z_mm,feed_mm_min\n1,2,3,5\n1,two,3,5\n"),
            "part.cls:3:3: The column Y_MM needs a number, found 'two'.");
}

TEST(ClReader, RefusesWhatCouldBeMotionOrIsNoNumber) {
  EXPECT_EQ(faultOf("FEDRAT/10\nGOTO/1,,3\n"), "part.cls:2:8: GOTO needs a number, found ''.");
  EXPECT_EQ(faultOf("FEDRAT/10\nGOTO/1,2,nan\n"), "part.cls:2:10: GOTO needs a number, found 'nan'.");
  EXPECT_EQ(faultOf("FEDRAT/10\nGOTO/1,2\n"),
            "part.cls:2:1: GOTO has 2 numbers, expected x, y, z or x, y, z, i, j, k.");
  EXPECT_EQ(faultOf("FEDRAT/10\nGOTO/1,2,3,0,0,2\n"),
            "part.cls:2:12: GOTO has a direction of length 2, expected a unit vector.");
  EXPECT_EQ(faultOf("FEDRAT/10\nGOTO/1,2,3\nTLON,GOFWD/(CIRCLE/1,2,3)\n").substr(0, 32),
            "part.cls:3:1: The statement TLON");
  EXPECT_EQ(faultOf("GOTO/1,2,3\n"), "part.cls:1: The tool cuts before any FEDRAT states a feed.");
  EXPECT_EQ(faultOf("FEDRAT/-3\nGOTO/1,2,3\n"), "part.cls:1:1: FEDRAT needs a feed above 0.");
  EXPECT_EQ(faultOf("FEDRAT/3\nGODLTA/1,2,3\n").substr(0, 19), "part.cls:2:1: GODLT");
  EXPECT_EQ(faultOf("").substr(0, 17), "part.cls: No GOTO");
  EXPECT_EQ(faultOf("FEDRAT/3\nGOTO/60,20,5\nCIRCLE/10,20,5,0,0,1,49\nGOTO/10,70,5\n").substr(0, 26),
            "part.cls:4:1: The arc of l");
}

}  // namespace
}  // namespace nineline::postprocessing
