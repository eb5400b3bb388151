#include <gtest/gtest.h>

#include "tests/core/nc/program_runner.h"

namespace nineline::nc::testing {
namespace {

std::vector<double> levelsOf(const ProgramRun& run, std::size_t axis) {
  std::vector<double> levels;
  for (const Motion& motion : run.motions) levels.push_back(motion.end[axis]);
  return levels;
}

TEST(Cycles, DrillingReturnsToTheInitialLevelOrToR) {
  const ProgramRun run =
      runFanuc("G90 G0 X0 Y0 Z50.\nG98 G81 X10. Y0 Z-5. R2. F100.\nX20.\nG99 X30.\nG80\nX0\n");
  ASSERT_EQ(run.error, "");
  EXPECT_EQ(levelsOf(run, 2), (std::vector<double>{50, 50, 2, -5, 50, 50, 2, -5, 50, 50, 2, -5, 2, 2}));
  EXPECT_EQ(run.motions[2].role, MotionRole::Cycle);
  EXPECT_EQ(run.motions[3].kind, MotionKind::Linear);
  EXPECT_FALSE(run.blocks[1].rewritable);
  EXPECT_EQ(run.motions.back().role, MotionRole::Block);
}

TEST(Cycles, PecksGoDownStepByStep) {
  const ProgramRun run = runFanuc("G90 G0 Z10.\nG99 G83 X0 Z-5. R1. Q2. F50.\n");
  ASSERT_EQ(run.error, "");
  const std::vector<double> levels = levelsOf(run, 2);
  ASSERT_EQ(levels.size(), 10U);
  EXPECT_EQ(levels[2], -1.0);
  EXPECT_EQ(levels[3], 1.0);
  EXPECT_NEAR(levels[4], -1.0 + 0.254, 1e-12);
  EXPECT_EQ(levels[5], -3.0);
  EXPECT_EQ(levels[8], -5.0);
  EXPECT_EQ(levels[9], 1.0);
}

TEST(Cycles, IncrementsRepeat) {
  const ProgramRun run = runFanuc("G90 G0 X0 Y0 Z10.\nG91 G99 G81 X5. Z-6. R-8. K3 F50.\n");
  ASSERT_EQ(run.error, "");
  EXPECT_EQ(run.motions.back().end, (AxisValues{15.0, 0.0, 2.0}));
  EXPECT_EQ(run.motions[3].end[2], -4.0);
  EXPECT_EQ(runFanuc("G90 G0 Z10.\nG81 X5. Z-6. R1. K0 F9.\n").motions.size(), 1U);
}

TEST(Cycles, WorkInOtherPlanes) {
  const ProgramRun run = runFanuc("G90 G18 G0 X0 Y30. Z0\nG99 G85 X5. Z6. Y-3. R2. F50.\n");
  ASSERT_EQ(run.error, "");
  EXPECT_EQ(levelsOf(run, 1), (std::vector<double>{30, 30, 2, -3, 2}));
  EXPECT_EQ(run.motions.back().kind, MotionKind::Linear);  // G85 feeds out
}

TEST(Cycles, RemembersItsWordsUntilCancelled) {
  const ProgramRun run =
      runFanuc("G90 G0 Z10.\nG99 G81 X0 Z-5. R1. F50.\nX1. Z-7.\nX2.\nG80\nG81 X3. F50.\n");
  EXPECT_EQ(run.code, "nc.MissingWord");
  EXPECT_EQ(run.line, 6U);
  EXPECT_EQ(run.motions[run.motions.size() - 2].end[2], -7.0);
}

TEST(Threads, FanucAndLinuxCnc) {
  const ProgramRun fanuc = runFanuc("G90 G0 X0 Z5.\nG32 Z-15. F1.5\nG0 X5.\n", "XZC");
  ASSERT_EQ(fanuc.motions.size(), 3U) << fanuc.error;
  EXPECT_EQ(fanuc.motions[1].role, MotionRole::Thread);
  EXPECT_EQ(fanuc.motions[1].feed_mode, FeedMode::PerRevolution);
  EXPECT_EQ(fanuc.motions[1].feed, 1.5);
  const ProgramRun linux_cnc = runLinuxCnc("G20 G18 G0 X0 Z1\nG33 Z-1 K.05\nG33.1 Z-2 K.1\n", "XYZ");
  ASSERT_EQ(linux_cnc.motions.size(), 4U) << linux_cnc.error;
  EXPECT_DOUBLE_EQ(linux_cnc.motions[1].feed, 1.27);
  EXPECT_EQ(linux_cnc.motions[3].end[2], linux_cnc.motions[1].end[2]);
  EXPECT_EQ(runLinuxCnc("G33 Z-1\n").code, "nc.MissingWord");
}

TEST(Threads, TurningCyclesOfCodeSystemA) {
  InterpreterOptions options = optionsFor("XZ", Dialect::Fanuc);
  options.axes.axes[0].diameter = true;
  const ProgramRun run =
      testing::run("G50 S2000\nG99\nG0 X50. Z2.\nG92 X46. Z-20. F1.5\nX45.\nG0 U4.\n", options);
  ASSERT_EQ(run.error, "");
  ASSERT_EQ(run.motions.size(), 10U);
  EXPECT_EQ(run.motions[1].end[0], 23.0);
  EXPECT_EQ(run.motions[2].end[1], -20.0);
  EXPECT_EQ(run.motions[2].feed, 1.5);
  EXPECT_EQ(run.motions[2].feed_mode, FeedMode::PerRevolution);
  EXPECT_EQ(run.motions[4].end, (AxisValues{25.0, 2.0}));
  EXPECT_EQ(run.motions[6].end, (AxisValues{22.5, -20.0}));  // the cycle is modal
  EXPECT_EQ(run.motions[9].end[0], 27.0);
}

}  // namespace
}  // namespace nineline::nc::testing
