#include <gtest/gtest.h>

#include "tests/core/nc/program_runner.h"

namespace nineline::nc::testing {
namespace {

std::vector<double> xOf(const ProgramRun& run) {
  EXPECT_EQ(run.error, "");
  std::vector<double> values;
  for (const Motion& motion : run.motions) values.push_back(motion.end[0]);
  return values;
}

/// X of the only motion of `G0 X[expression]`.
double valueOf(const std::string& expression) {
  const ProgramRun run = runFanuc("G90 G0 X[" + expression + "]\n");
  EXPECT_EQ(run.error, "") << expression;
  return run.motions.size() == 1 ? run.motions[0].end[0] : -999.0;
}

TEST(Macro, Expressions) {
  EXPECT_EQ(valueOf("1+2*3"), 7.0);
  EXPECT_EQ(valueOf("[1+2]*3"), 9.0);
  EXPECT_EQ(valueOf("-3+1"), -2.0);
  EXPECT_EQ(valueOf("7-2-1"), 4.0);
  EXPECT_NEAR(valueOf("SIN[30]"), 0.5, 1e-15);
  EXPECT_NEAR(valueOf("ATAN[1]/[1]"), 45.0, 1e-12);
  EXPECT_EQ(valueOf("SQRT[16]"), 4.0);
  EXPECT_EQ(valueOf("ABS[-2.5]"), 2.5);
  EXPECT_EQ(valueOf("FIX[2.9]+FUP[2.1]+ROUND[2.5]"), 8.0);
  EXPECT_EQ(valueOf("10 MOD 4"), 2.0);
  EXPECT_EQ(valueOf("1 LT 2"), 1.0);
  EXPECT_EQ(valueOf("[1 EQ 2] OR [3 NE 4]"), 1.0);
}

TEST(Macro, VariablesAreValues) {
  EXPECT_EQ(xOf(runFanuc("#1=10\n#2=#1*2+1\nG90 G0 X#2\nX-#1\nX[#[1]/4]\n")),
            (std::vector<double>{21.0, -10.0, 2.5}));
  EXPECT_EQ(runFanuc("G0 X1. Y#5\n").motions.at(0).commanded, 1);  // a vacant variable: no word
}

TEST(Macro, JumpsAndConditions) {
  EXPECT_EQ(xOf(runFanuc("#1=0\nN10 #1=#1+1\nG90 G0 X#1\nIF [#1 LT 3] GOTO 10\nX9.\n")),
            (std::vector<double>{1, 2, 3, 9}));
  EXPECT_EQ(xOf(runFanuc("IF [1 EQ 1] THEN #1=5\nIF [1 EQ 2] THEN #1=6\nG0 X#1\n")),
            (std::vector<double>{5}));
  EXPECT_EQ(xOf(runFanuc("GOTO 20\nG0 X1.\nN20 G0 X2.\n")), (std::vector<double>{2}));
}

TEST(Macro, NestedLoops) {
  const ProgramRun run = runFanuc(
      "#1=0\nWHILE [#1 LT 2] DO1\n#2=0\nWHILE [#2 LT 2] DO2\nG90 G0 "
      "X[#1*10+#2]\n#2=#2+1\nEND2\n#1=#1+1\nEND1\nX99.\n");
  EXPECT_EQ(xOf(run), (std::vector<double>{0, 1, 10, 11, 99}));
  EXPECT_TRUE(run.blocks.back().motions.size() == 1);
  bool repeated = false;
  for (const RunBlock& block : run.blocks) repeated = repeated || block.repeated;
  EXPECT_TRUE(repeated);
}

TEST(Macro, SubprogramsRepeatAndReturn) {
  const std::string sub = "M30\nO1000\nG91 G0 X1.\nM98 P2\nM99\nO0002\nX.5\nM99\n";
  EXPECT_EQ(xOf(runFanuc("M98 P1000 L2\nG90 X9.\n" + sub)), (std::vector<double>{1, 1.5, 2.5, 3, 9}));
  EXPECT_EQ(xOf(runFanuc("M98 P31000\n" + sub)).size(), 6U);
  EXPECT_EQ(xOf(runFanuc("M97 P50 L2\nM30\nN50 G91 G0 X1.\nM99\n")), (std::vector<double>{1, 2}));
  const ProgramRun endless = runFanuc("G0 X1.\nM99\n");
  EXPECT_EQ(endless.motions.size(), 1U);
  EXPECT_TRUE(endless.warned("M99"));
}

TEST(Macro, CallsHaveTheirOwnVariables) {
  EXPECT_EQ(xOf(runFanuc("#1=7\nG65 P9010 A2. B3. X4.\nG0 X#1\nM30\nO9010\nG0 X[#1*#2+#24]\n#1=99\nM99\n")),
            (std::vector<double>{10, 7}));
}

TEST(Macro, TheMainProgramEndsWhereTheNextBegins) {
  const ProgramRun run = runFanuc("O1\nG0 X1.\nO2\nX2.\n");
  EXPECT_EQ(xOf(run), (std::vector<double>{1}));
  EXPECT_TRUE(run.warned("ends without M30"));
}

TEST(LinuxCnc, ControlWordsAreExecuted) {
  EXPECT_EQ(
      xOf(runLinuxCnc("o<s> sub\nG0 X#1\n#<k> = 3\no<s> endsub [#1+1]\no<s> call [4]\nG0 X#<_value>\nM2\n")),
      (std::vector<double>{4, 5}));
  EXPECT_EQ(xOf(runLinuxCnc("#1=0\no1 while [#1 LT 3]\n#1=[#1+1]\no2 if [#1 EQ 2]\no1 continue\no2 endif\nG0 "
                            "X#1\no1 endwhile\nM2\n")),
            (std::vector<double>{1, 3}));
  EXPECT_EQ(xOf(runLinuxCnc("#1=0\no1 do\n#1=[#1+1]\nG0 X#1\no1 while [#1 LT 2]\no3 repeat [2]\nG91 G0 "
                            "X1\no3 endrepeat\nM2\n")),
            (std::vector<double>{1, 2, 3, 4}));
  EXPECT_EQ(xOf(runLinuxCnc(
                "#1=2\no1 if [#1 EQ 1]\nG0 X1\no1 elseif [#1 EQ 2]\nG0 X2\no1 else\nG0 X3\no1 endif\nM2\n")),
            (std::vector<double>{2}));
  EXPECT_EQ(
      xOf(runLinuxCnc(
          "#1=0\no1 while [1]\n#1=[#1+1]\no2 if [#1 GT 3]\no1 break\no2 endif\no1 endwhile\nG0 X#1\nM2\n")),
      (std::vector<double>{4}));
}

TEST(LinuxCnc, ParametersAreReadBeforeTheyAreSet) {
  EXPECT_EQ(xOf(runLinuxCnc("#3=15\n#3=6 G0 X#3\nX#3\n")), (std::vector<double>{15, 6}));
  EXPECT_EQ(xOf(runLinuxCnc("G0 X5\nX[#<_x> + 1]\nX[#5420 * 2]\n")), (std::vector<double>{5, 6, 12}));
  EXPECT_EQ(runLinuxCnc("G0 X#5061\n").code, "nc.NotConstant");
  EXPECT_EQ(runLinuxCnc("g0 x +0. 12 34 y 7\n").motions.at(0).end, (AxisValues{0.1234, 7.0}));
}

TEST(Flow, AProgramMayEndInsideALoopThatIsClosedFurtherOn) {
  EXPECT_EQ(xOf(runFanuc("#1=0\nWHILE[#1LT3]DO1\n#1=#1+1\nG90G0X#1\nM30\nEND1\n")), (std::vector<double>{1}));
  const ProgramRun left = runFanuc("WHILE[1EQ1]DO2\nGOTO 10\nEND2\nN10 G90 G0 X4.\nM30\n");
  EXPECT_EQ(left.error, "");
  EXPECT_EQ(left.blocks.back().line, 5U);
  const ProgramRun siemens = runSiemens("WHILE 1==1\nWHILE 1==1\nG0 X1\nM30\nENDWHILE\nENDWHILE\n");
  EXPECT_EQ(siemens.error, "");
  EXPECT_EQ(runSiemens("WHILE 1==1\nWHILE 1==1\nG0 X1\nM30\nENDWHILE\n").line, 1U);
  EXPECT_EQ(runLinuxCnc("o1 do\ng0 x1\nm2\no1 while [1 eq 1]\n").error, "");
  EXPECT_EQ(runLinuxCnc("o1 repeat [2]\ng0 x1\nm2\n").line, 1U);
}

TEST(Flow, SiemensLoopsNest) {
  EXPECT_EQ(xOf(runSiemens("R1=0\nG90 G0\nWHILE R1<2\nR1=R1+1\nR2=0\nWHILE R2<2\nR2=R2+1\n"
                           "X=10*R1+R2\nENDWHILE\nENDWHILE\nM30\n")),
            (std::vector<double>{11, 12, 21, 22}));
}

TEST(Words, AxisWordsBesideALinuxCncDwellMove) {
  const ProgramRun run = runLinuxCnc("G21 G90 G94\nG4 P.001 G0 X1 Y2 S1000 M3\nG4 P1\nG4 P.5 X3\n");
  EXPECT_EQ(run.error, "");
  EXPECT_EQ(xOf(run), (std::vector<double>{1, 3}));
  EXPECT_NE(runLinuxCnc("G21 G90 G94 F9\nG4 P2 G2 X2 I1\n").error, "");
  EXPECT_TRUE(runFanuc("G90 G0 X5.\nG04 X2.\n").motions.size() == 1);
  EXPECT_EQ(runFanuc("G90 G0 X5.\nG04 G01 X2.\n").line, 2U);
}

TEST(Words, AThreadMayHaveALeadOfE) { EXPECT_EQ(runFanuc("G90 G99 G32 Z-10.E1.5 F1.5\n").error, ""); }

}  // namespace
}  // namespace nineline::nc::testing
