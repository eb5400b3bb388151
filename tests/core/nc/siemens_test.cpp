#include <gtest/gtest.h>

#include "core/base/units.h"
#include "tests/core/nc/program_runner.h"

namespace nineline::nc::testing {
namespace {

std::vector<double> xOf(const ProgramRun& run) {
  EXPECT_EQ(run.error, "");
  std::vector<double> values;
  for (const Motion& motion : run.motions) values.push_back(motion.end[0]);
  return values;
}

TEST(Siemens, AssignedWordsAndModes) {
  const ProgramRun run = runSiemens("N10 G90 G0 X=10.5 Y=-2\nX=IC(2) Y=AC(7)\nG91 X=AC(1) Y3\n");
  ASSERT_EQ(run.motions.size(), 3U) << run.error;
  EXPECT_EQ(run.motions[0].end, (AxisValues{10.5, -2.0, 0.0}));
  EXPECT_EQ(run.motions[1].end, (AxisValues{12.5, 7.0, 0.0}));
  EXPECT_EQ(run.motions[2].end, (AxisValues{1.0, 10.0, 0.0}));
  EXPECT_TRUE(run.blocks[0].rewritable);
  EXPECT_FALSE(run.blocks[1].rewritable);
}

TEST(Siemens, VariablesAndExpressions) {
  EXPECT_EQ(
      xOf(runSiemens(
          "DEF REAL _A=1.5, BB\nR1=2 R2=R1*3+1\nBB=_A+7\nG0 X=BB\nX=-BB\nX=SQRT(16)*(1+1)\nR[3]=5\nX=R3\n")),
      (std::vector<double>{8.5, -8.5, 8.0, 5.0}));
}

TEST(Siemens, JumpsAndConditions) {
  EXPECT_EQ(xOf(runSiemens("R1=0\nLOOP1: R1=R1+1\nG0 X=R1\nIF R1<3 GOTOB LOOP1\nX9\n")),
            (std::vector<double>{1, 2, 3, 9}));
  EXPECT_EQ(xOf(runSiemens("R1=1\nIF R1==2\nG0 X1\nELSE\nG0 X2\nENDIF\nGOTOF ENDE\nX7\nENDE: X8\n")),
            (std::vector<double>{2, 8}));
  EXPECT_EQ(xOf(runSiemens("R1=0\nWHILE R1<2\nR1=R1+1\nG0 X=R1\nENDWHILE\n")), (std::vector<double>{1, 2}));
}

TEST(Siemens, MachineCoordinatesAndOffsets) {
  InterpreterOptions options = optionsFor("XYZ", Dialect::Siemens);
  options.work_offsets["G54"] = {100.0, 0.0, 0.0};
  options.work_offsets["G506"] = {7.0, 0.0, 0.0};
  const ProgramRun result = run("G54 G0 X1\nSUPA G0 X5 D0\nG500 X2\nG506 X1\n", options);
  EXPECT_EQ(xOf(result), (std::vector<double>{101, 5, 2, 8}));
  EXPECT_EQ(result.motions[1].role, MotionRole::Machine);
}

TEST(Siemens, WordsThatDoNotMovePass) {
  const ProgramRun result = runSiemens(
      "%_N_TEST_MPF\n;$PATH=/_N_MPF_DIR\nG17 G710 G90 G60 G601 "
      "FNORM\nCYCLE800()\nCYCLE832(0.02,1,1)\nMSG(\"A (B) ; C\")\n"
      "T=\"MILL_D8\" D1\nM6\nTRAORI\nG1 X1 F=100*2\nTRAFOOF\nSOFT FFWON\nG4 F1.5\nSPOS=90\nM30\n");
  EXPECT_EQ(result.error, "");
  EXPECT_FALSE(result.diagnostics.hasErrors());
  ASSERT_EQ(result.motions.size(), 1U);
  EXPECT_TRUE(result.motions[0].tool_centre_point);
  EXPECT_DOUBLE_EQ(result.motions[0].feed, 200.0 / 60.0);
}

TEST(Siemens, TheShortestWayOfARotaryAxis) {
  const ProgramRun result = runSiemens("G0 C350\nC=DC(10)\n", "XC");
  ASSERT_EQ(result.motions.size(), 2U) << result.error;
  EXPECT_NEAR(result.motions[1].end[1], radFromDeg(370.0), 1e-12);
}

TEST(Dialect, IsRecognisedFromTheText) {
  const auto dialectOf = [](const std::string& program) {
    InterpreterOptions options = optionsFor("XYZ", Dialect::Fanuc);
    options.dialect.reset();
    return run(program, options).dialect;
  };
  EXPECT_EQ(dialectOf("%\nO0001 (PART)\nG90 G54 G0 X0\nM30\n%\n"), Dialect::Fanuc);
  EXPECT_EQ(dialectOf("#1=5\nWHILE [#1 LT 6] DO1\n#1=#1+1\nEND1\n"), Dialect::Fanuc);
  EXPECT_EQ(dialectOf("%_N_PART_MPF\nG0 X0\n"), Dialect::Siemens);
  EXPECT_EQ(dialectOf("N10 R1=5\nN20 G0 X=R1\n"), Dialect::Siemens);
  EXPECT_EQ(dialectOf("o<part> sub\no<part> endsub\nG0 X0\nM2\n"), Dialect::LinuxCnc);
  EXPECT_EQ(dialectOf("G0 X#<width>\n"), Dialect::LinuxCnc);
}

}  // namespace
}  // namespace nineline::nc::testing
