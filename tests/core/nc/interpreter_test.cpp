#include "core/nc/interpreter.h"

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "tests/core/nc/program_runner.h"

namespace nineline::nc::testing {
namespace {

TEST(Interpreter, ModalMotionsAndFeeds) {
  const ProgramRun run = runFanuc("G90 G21 G94\nG0 X10. Y5.\nG1 Z-2. F600.\nX20.\nG0 Z50.\n");
  ASSERT_EQ(run.motions.size(), 4U) << run.error;
  EXPECT_EQ(run.motions[0].kind, MotionKind::Rapid);
  EXPECT_EQ(run.motions[0].feed, 0.0);
  EXPECT_EQ(run.motions[1].kind, MotionKind::Linear);
  EXPECT_EQ(run.motions[1].feed, 10.0);
  EXPECT_EQ(run.motions[2].end, (AxisValues{20.0, 5.0, -2.0}));
  EXPECT_EQ(run.motions[2].start, (AxisValues{10.0, 5.0, -2.0}));
  EXPECT_EQ(run.motions[2].commanded, 1);
  EXPECT_EQ(run.blocks[2].feed_stated, true);
  EXPECT_EQ(run.blocks[3].feed_stated, false);
  EXPECT_EQ(run.blocks[3].motion_code, 1);
}

TEST(Interpreter, IncrementsAndInches) {
  const ProgramRun run = runFanuc("G20 G90 G0 X1. Y2.\nG91 X.5 Y-.25\nG21 X1.\n");
  ASSERT_EQ(run.motions.size(), 3U);
  EXPECT_DOUBLE_EQ(run.motions[1].end[0], 38.1);
  EXPECT_DOUBLE_EQ(run.motions[1].end[1], 44.45);
  EXPECT_DOUBLE_EQ(run.motions[2].end[0], 39.1);
  EXPECT_EQ(run.blocks[1].frame.incremental, 7);
  EXPECT_EQ(run.blocks[0].frame.factor[0], 25.4);
}

TEST(Interpreter, EstablishedNeedsAnAbsoluteWord) {
  const ProgramRun run = runFanuc("G91 G0 X5.\nG90 Y1.\nG91 X1.\nG90 X2.\nG91 G28 Z0\n");
  ASSERT_EQ(run.motions.size(), 5U) << run.error;
  EXPECT_EQ(run.motions[0].established, 0);
  EXPECT_EQ(run.motions[1].established, 2);
  EXPECT_EQ(run.motions[2].established, 2);
  EXPECT_EQ(run.motions[3].established, 3);
  EXPECT_EQ(run.motions[4].established, 7);
}

TEST(Interpreter, RotaryWordsAreDegreesAndNeverInches) {
  const ProgramRun run = runFanuc("G20 G90 G1 C180. F360.\nX1. C90.\n", "XZC");
  ASSERT_EQ(run.motions.size(), 2U);
  EXPECT_DOUBLE_EQ(run.motions[0].end[2], kPi);
  EXPECT_DOUBLE_EQ(run.motions[0].feed, radFromDeg(6.0));
  EXPECT_DOUBLE_EQ(run.motions[1].feed, 360.0 * 25.4 / 60.0);
}

TEST(Interpreter, DiameterWordsAreHalved) {
  InterpreterOptions options = optionsFor("XZ", Dialect::Fanuc);
  options.axes.axes[0].diameter = true;
  const ProgramRun run = testing::run("G0 X40. Z5.\nU-2. W-1.\n", options);
  ASSERT_EQ(run.motions.size(), 2U) << run.error;
  EXPECT_EQ(run.motions[0].end[0], 20.0);
  EXPECT_EQ(run.motions[1].end[0], 19.0);
  EXPECT_EQ(run.motions[1].end[1], 4.0);
  EXPECT_EQ(run.blocks[1].frame.incremental, 3);
}

TEST(Interpreter, FeedModes) {
  const ProgramRun run = runFanuc("G0 X0\nG93 G1 X1. F30.\nG95 X2. F.2\nG94 X3.\n");
  ASSERT_EQ(run.motions.size(), 4U);
  EXPECT_EQ(run.motions[1].feed_mode, FeedMode::InverseTime);
  EXPECT_DOUBLE_EQ(run.motions[1].feed, 0.5);
  EXPECT_EQ(run.motions[2].feed_mode, FeedMode::PerRevolution);
  EXPECT_DOUBLE_EQ(run.motions[2].feed, 0.2);
  EXPECT_EQ(run.motions[3].feed, 0.0);  // not stated since the mode changed
}

TEST(Interpreter, WorkOffsetsToolLengthAndLocalOffsetAdd) {
  InterpreterOptions options = optionsFor("XYZ", Dialect::Fanuc);
  options.work_offsets["G55"] = {100.0, 50.0, -10.0};
  options.work_offsets["G54.1P3"] = {7.0, 0.0, 0.0};
  options.tool_lengths[5] = 80.0;
  const ProgramRun run = testing::run(
      "G90 G0 G55 X1.\nG43 H5 Z2.\nG52 X10.\nX1.\nG52 X0\nG54.1 P3 X0\nG49 Z0\nG53 X-5.\n", options);
  ASSERT_EQ(run.motions.size(), 6U) << run.error;
  EXPECT_EQ(run.motions[0].end[0], 101.0);
  EXPECT_EQ(run.motions[1].end[2], 72.0);
  EXPECT_EQ(run.motions[2].end[0], 111.0);
  EXPECT_EQ(run.motions[3].end[0], 7.0);
  EXPECT_EQ(run.motions[4].end[2], 0.0);
  EXPECT_EQ(run.motions[5].end[0], -5.0);
  EXPECT_EQ(run.motions[5].role, MotionRole::Machine);
}

TEST(Interpreter, SetPositionMovesTheWordsNotTheMachine) {
  const ProgramRun run = runFanuc("G90 G0 X10. Y10.\nG92 X0 Y2.\nX1. Y2.\n");
  ASSERT_EQ(run.motions.size(), 2U);
  EXPECT_EQ(run.motions[1].end, (AxisValues{11.0, 10.0, 0.0}));
}

TEST(Interpreter, DataBlocksWriteOffsets) {
  const ProgramRun run = runFanuc(
      "G90 G10 L2 P1 X5. Y6.\nG0 X1. Y1.\nG91 G10 L2 P1 X1.\nG90 X1.\nG10 L20 P2 X9.\nG54.1 P2 X0\nG10 L10 "
      "P7 R33.\nG43 H7 Z0\n");
  ASSERT_EQ(run.motions.size(), 4U) << run.error;
  EXPECT_EQ(run.motions[0].end, (AxisValues{6.0, 7.0, 0.0}));
  EXPECT_EQ(run.motions[1].end[0], 7.0);
  EXPECT_EQ(run.motions[2].end[0], 9.0);
  EXPECT_EQ(run.motions[3].end[2], 33.0);
}

TEST(Interpreter, RotationTurnsWordsAboutItsCentre) {
  const ProgramRun run =
      runFanuc("G90 G17 G0 X0 Y0\nG68 X10. Y0 R90.\nG1 X15. Y0 F100.\nG91 X1.\nG69 G90 X0 Y0\n");
  ASSERT_EQ(run.motions.size(), 4U) << run.error;
  EXPECT_NEAR(run.motions[1].end[0], 10.0, 1e-12);
  EXPECT_NEAR(run.motions[1].end[1], 5.0, 1e-12);
  EXPECT_NEAR(run.motions[2].end[1], 6.0, 1e-12);
  EXPECT_EQ(run.motions[3].end, (AxisValues{}));
}

TEST(Interpreter, ReferenceReturnGoesThroughThePointStated) {
  InterpreterOptions options = optionsFor("XYZ", Dialect::Fanuc);
  options.reference_points[1] = {1.0, 2.0, 300.0};
  const ProgramRun run = testing::run("G90 G0 X10. Y10. Z10.\nG91 G28 Z5.\nG90 G28 X0 Y0\n", options);
  ASSERT_EQ(run.motions.size(), 5U) << run.error;
  EXPECT_EQ(run.motions[1].end[2], 15.0);
  EXPECT_EQ(run.motions[2].end, (AxisValues{10.0, 10.0, 300.0}));
  EXPECT_EQ(run.motions[4].end, (AxisValues{1.0, 2.0, 300.0}));
  EXPECT_EQ(run.motions[4].role, MotionRole::Machine);
}

TEST(Interpreter, RewritableBlocksStateTheirEndByPlainWords) {
  const ProgramRun run =
      runFanuc("#1=5\nG90 G1 X1. F9.\nX#1\nG53 Z0\nG4 X2.\nG32 Z-9. F1.5\nM98 P7\nM30\nO7\nX3.\nM99\n");
  ASSERT_EQ(run.error, "");
  EXPECT_TRUE(run.blocks[1].rewritable);
  EXPECT_EQ(run.blocks[1].has_word, 1);
  EXPECT_FALSE(run.blocks[2].rewritable);
  EXPECT_FALSE(run.blocks[3].rewritable);
  EXPECT_FALSE(run.blocks[4].rewritable);
  EXPECT_TRUE(run.blocks[5].rewritable);
  EXPECT_EQ(run.blocks[5].motions.at(0).role, MotionRole::Thread);
  EXPECT_EQ(run.blocks[5].motions.at(0).feed, 1.5);
  EXPECT_EQ(run.blocks[8].depth, 1);
}

TEST(Interpreter, SkippedBlocksMoveOnlyWhereSkipIsOff) {
  InterpreterOptions options = optionsFor("XYZ", Dialect::Fanuc);
  EXPECT_EQ(testing::run("/G0 X1.\n/2 X2.\n", options).motions.size(), 2U);
  options.block_skip = true;
  const ProgramRun run = testing::run("/G0 X1.\n X2.\n", options);
  EXPECT_TRUE(run.blocks[0].skipped);
  EXPECT_EQ(run.motions.size(), 1U);
}

TEST(Interpreter, FreeFormIsRead) {
  const ProgramRun run =
      runFanuc("%\nO0001(A B)\n\n  n10g1x.5y-.5z1.f100(c)\nX 2. Y 3\n G0(a)X1;tail\nM30\n%\n");
  ASSERT_EQ(run.motions.size(), 3U) << run.error;
  EXPECT_EQ(run.motions[0].end, (AxisValues{0.5, -0.5, 1.0}));
  EXPECT_EQ(run.motions[1].end, (AxisValues{2.0, 3.0, 1.0}));
  EXPECT_EQ(run.motions[2].kind, MotionKind::Rapid);
  EXPECT_TRUE(run.diagnostics.all().empty());
}

TEST(Interpreter, OneBadWordHidesNoOther) {
  const ProgramRun run = runFanuc("G0 X1.\nX1..2\nY\nX3. X4.\nX5.\n");
  EXPECT_EQ(run.error, "");
  EXPECT_EQ(run.motions.size(), 2U);
  ASSERT_EQ(run.diagnostics.all().size(), 3U);
  EXPECT_EQ(run.diagnostics.all()[1].line, 3U);
  EXPECT_EQ(run.diagnostics.all()[1].column, 2U);
  EXPECT_TRUE(run.diagnostics.hasErrors());
}

TEST(Interpreter, UnknownCodesWarnOrAreRefused) {
  const ProgramRun passed = runFanuc("G123\nM277\nG0 X1.\n");
  EXPECT_EQ(passed.error, "");
  EXPECT_TRUE(passed.warned("G123"));
  EXPECT_TRUE(passed.warned("M277"));
  const ProgramRun refused = runFanuc("G0 X0\nG123 X1.\nX9.\n");
  EXPECT_EQ(refused.code, "nc.UnknownCode");
  EXPECT_EQ(refused.line, 2U);
  EXPECT_EQ(runFanuc("G0 B5.\n").error, "test.nc:1:4: The machine has no axis B");
}

TEST(Interpreter, AnErrorStays) {
  MemoryText text("t.nc", "G31 X1.\nG0 X1.\n");
  Interpreter interpreter(text, optionsFor("XYZ", Dialect::Fanuc));
  const Result<const ExecutedBlock*> first = interpreter.next();
  ASSERT_FALSE(first);
  const Result<const ExecutedBlock*> second = interpreter.next();
  ASSERT_FALSE(second);
  EXPECT_EQ(first.error().message(), second.error().message());
}

TEST(Interpreter, AxesWithDigits) {
  InterpreterOptions options = optionsFor("XZ", Dialect::Fanuc);
  options.axes.axes[2] = {{'C', 2}, true, false};
  options.axes.count = 3;
  const ProgramRun run = testing::run("G1 X1. C2=90. F10.\nC2=-45.5\n", options);
  ASSERT_EQ(run.motions.size(), 2U) << run.error;
  EXPECT_DOUBLE_EQ(run.motions[1].end[2], radFromDeg(-45.5));
  EXPECT_TRUE(run.blocks[1].rewritable);
}

TEST(Interpreter, ToolCentrePointAndCutterFlags) {
  const ProgramRun run = runFanuc("G43.4 H1\nG41 D1 G1 X1. F9.\nG40 X2.\nG49 X3.\n");
  ASSERT_EQ(run.motions.size(), 3U) << run.error;
  EXPECT_TRUE(run.motions[0].tool_centre_point);
  EXPECT_EQ(run.motions[0].cutter_compensation, -1);
  EXPECT_EQ(run.motions[1].cutter_compensation, 0);
  EXPECT_FALSE(run.motions[2].tool_centre_point);
}

}  // namespace
}  // namespace nineline::nc::testing
