#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "tests/core/nc/program_runner.h"

namespace nineline::nc::testing {
namespace {

constexpr double kTight = 1e-12;

Motion lastOf(const ProgramRun& run) {
  EXPECT_EQ(run.error, "");
  return run.motions.empty() ? Motion{} : run.motions.back();
}

TEST(Arcs, CentreForm) {
  const Motion arc = lastOf(runFanuc("G90 G17 G0 X10. Y0\nG3 X0 Y10. I-10. J0 F100.\n"));
  EXPECT_EQ(arc.kind, MotionKind::Arc);
  EXPECT_NEAR(arc.sweep, kPi / 2.0, kTight);
  EXPECT_NEAR(arc.centre[0], 0.0, kTight);
  const Motion clockwise = lastOf(runFanuc("G90 G17 G0 X10. Y0\nG2 X0 Y10. I-10. J0 F100.\n"));
  EXPECT_NEAR(clockwise.sweep, -1.5 * kPi, kTight);
}

TEST(Arcs, RadiusFormTakesTheShortOrTheLongWay) {
  const Motion small = lastOf(runFanuc("G90 G17 G0 X10. Y0\nG3 X0 Y10. R10. F100.\n"));
  EXPECT_NEAR(small.centre[0], 0.0, kTight);
  EXPECT_NEAR(small.centre[1], 0.0, kTight);
  EXPECT_NEAR(small.sweep, kPi / 2.0, kTight);
  const Motion large = lastOf(runFanuc("G90 G17 G0 X10. Y0\nG3 X0 Y10. R-10. F100.\n"));
  EXPECT_NEAR(large.centre[0], 10.0, kTight);
  EXPECT_NEAR(large.centre[1], 10.0, kTight);
  EXPECT_NEAR(large.sweep, 1.5 * kPi, kTight);
  const Motion half = lastOf(runFanuc("G90 G17 G0 X10. Y0\nG2 X-10. Y0 R10. F100.\n"));
  EXPECT_NEAR(half.sweep, -kPi, kTight);
}

TEST(Arcs, FullCircleWithoutAxisWords) {
  const Motion circle = lastOf(runFanuc("G90 G17 G0 X10. Y0\nG2 I-10. F100.\n"));
  EXPECT_NEAR(circle.sweep, -kTurn, kTight);
  EXPECT_EQ(circle.commanded, 0);
}

TEST(Arcs, PlanesCountFromTheFirstAxisToTheSecond) {
  const Motion zx = lastOf(runFanuc("G90 G18 G0 X0 Z10.\nG3 X10. Z0 K-10. F100.\n"));
  EXPECT_EQ(zx.plane, (std::array<std::int8_t, 2>{2, 0}));
  EXPECT_NEAR(zx.sweep, kPi / 2.0, kTight);
  const Motion yz = lastOf(runFanuc("G90 G19 G0 Y10. Z0\nG3 Y0 Z10. J-10. F100.\n"));
  EXPECT_EQ(yz.plane, (std::array<std::int8_t, 2>{1, 2}));
  EXPECT_NEAR(yz.sweep, kPi / 2.0, kTight);
}

TEST(Arcs, HelixCarriesTheOtherAxesInStep) {
  const ProgramRun run = runFanuc("G90 G17 G0 X10. Y0 Z0\nG3 X-10. Y0 Z4. C90. I-10. F100.\n", "XYZC");
  const Motion helix = lastOf(run);
  const AxisValues half = positionAt(helix, 4, 0.5);
  EXPECT_NEAR(half[1], 10.0, kTight);
  EXPECT_NEAR(half[2], 2.0, kTight);
  EXPECT_NEAR(half[3], radFromDeg(45.0), kTight);
}

TEST(Arcs, ExtraTurns) {
  const Motion linux_cnc = lastOf(runLinuxCnc("G90 G17 G0 X10 Y0\nG3 X10 Y0 Z5 I-10 P3 F100\n"));
  EXPECT_NEAR(linux_cnc.sweep, 3.0 * kTurn, kTight);
  const Motion siemens = lastOf(runSiemens("G90 G17 G0 X10 Y0\nG3 X0 Y10 I-10 J0 TURN=2 F100\n"));
  EXPECT_NEAR(siemens.sweep, 2.0 * kTurn + kPi / 2.0, kTight);
}

TEST(Arcs, AbsoluteCentres) {
  const Motion linux_cnc = lastOf(runLinuxCnc("G90 G17 G0 X12 Y5\nG90.1 G3 X2 Y15 I2 J5 F100\n"));
  EXPECT_NEAR(linux_cnc.centre[0], 2.0, kTight);
  EXPECT_NEAR(linux_cnc.sweep, kPi / 2.0, kTight);
  const Motion siemens = lastOf(runSiemens("G90 G17 G0 X12 Y5\nG3 X2 Y15 I=AC(2) J=AC(5) F100\n"));
  EXPECT_NEAR(siemens.centre[1], 5.0, kTight);
  EXPECT_NEAR(siemens.sweep, kPi / 2.0, kTight);
}

TEST(Arcs, DiametersLeaveTheCentreWordsARadius) {
  InterpreterOptions options = optionsFor("XZ", Dialect::Fanuc);
  options.axes.axes[0].diameter = true;
  const Motion arc = lastOf(run("G90 G18 G0 X20. Z0\nG2 X30. Z-5. I5. F.1\n", options));
  EXPECT_NEAR(arc.end[0], 15.0, kTight);
  EXPECT_NEAR(std::fabs(arc.sweep), kPi / 2.0, kTight);
}

TEST(Arcs, SiemensRadius) {
  const Motion arc = lastOf(runSiemens("G17 G0 X10 Y0\nG3 X0 Y10 CR=10 F100\n"));
  EXPECT_NEAR(arc.sweep, kPi / 2.0, kTight);
}

TEST(Arcs, RadiiThatDifferByRoundingPass) {
  EXPECT_EQ(runFanuc("G90 G17 G0 X10. Y0\nG3 X0 Y10.004 I-10. F100.\n").error, "");
  EXPECT_EQ(runFanuc("G90 G17 G0 X10. Y0\nG3 X0 Y10.04 I-10. F100.\n").code, "nc.BadArc");
}

}  // namespace
}  // namespace nineline::nc::testing
