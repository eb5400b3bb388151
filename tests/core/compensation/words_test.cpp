// What the words of corrected programs become: cases worked by hand.
#include <gtest/gtest.h>

#include "core/base/text.h"
#include "tests/core/compensation/correction.h"

namespace nineline::compensation {
namespace {

using test_support::corrected;
using test_support::linesOf;
using test_support::modelFrom;
using test_support::scale;
using test_support::squareX;

ErrorModel stage() { return modelFrom("linear-stage", scale("X", 100)); }  // actual = 1.0001 command
ErrorModel mill() { return modelFrom("generic-3axis", squareX()); }

TEST(CorrectedWords, DivideByTheScale) {
  EXPECT_EQ(corrected(stage(), "G90 G1 X100 F100\n"), "G90 G1 X99.99 F100\n");
  CompensationOptions options;
  options.linear_decimals = 6;  // 100 / 1.0001 = 99.990000999900…
  EXPECT_EQ(corrected(stage(), "G90 G1 X100 F100\n", options), "G90 G1 X99.990001 F100\n");
}

TEST(CorrectedWords, TakeSquarenessOutOfTheOtherAxis) {
  EXPECT_EQ(corrected(mill(), "G90 G0 X0 Y0 Z0\nG1 X50 Y100 F500\n"),
            "G90 G0 X0 Y0 Z0\nG1 X49.99 Y100 F500\n");
}

TEST(CorrectedWords, AreAddedWhereTheBlockLeavesAnAxisOut) {
  EXPECT_EQ(corrected(mill(), "G90 G0 X0 Y0 Z0\nG1 Y100 F500\nX50\nZ1\n"),
            "G90 G0 X0 Y0 Z0\nG1 Y100 X-0.01 F500\nX49.99\nZ1\n");
}

TEST(CorrectedWords, LeaveAnAxisAloneThatWasNeverPositioned) {
  EXPECT_EQ(corrected(mill(), "G90 G1 Y100 F500\nY200\n"), "G90 G1 Y100 F500\nY200\n");
}

TEST(CorrectedWords, KeepEverythingElseByteForByte) {
  EXPECT_EQ(
      corrected(stage(), "%\r\nO1 (X1)\r\nN10 G90 G01X100.F200 S1000 M3 T1 (X1 Y2) \r\n\r\nN20G4P1\r\nM5"),
      "%\r\nO1 (X1)\r\nN10 G90 G01X99.99F200 S1000 M3 T1 (X1 Y2) \r\n\r\nN20G4P1\r\nM5");
}

TEST(CorrectedWords, StayTheSameOnAnIdealMachine) {
  const std::string text =
      "%\nO7(TEST)\r\nN1 G21 G90 G54\nG00 X+1.50 Y0.0 Z.5;\n/G1X5.Y-0.F100\n G2 X15 Y0 I5. J0 (arc)\nG91 "
      "G1 X.1\n"
      "G90 G41 D1 Y3\nG40\n\nM30\n%";
  EXPECT_EQ(corrected(ErrorModel(mill().machine()), text), text);
}

TEST(CorrectedWords, KeepAMissingLineEnd) {
  EXPECT_EQ(corrected(stage(), "G90 G1 F100 X100"), "G90 G1 F100 X99.99");
}

TEST(CorrectedWords, CorrectSkippedBlocksOnlyWhereTheyRun) {
  simulation::ProgramSetup skipping;
  skipping.block_skip = true;
  const std::string text = "G90 G1 X0 F100\n/X100\n";
  EXPECT_EQ(corrected(stage(), text), "G90 G1 X0 F100\n/X99.99\n");
  EXPECT_EQ(corrected(stage(), text, {}, skipping), text);
}

TEST(CorrectedWords, AreInchesInInchPrograms) {
  // 10 in = 254 mm; 254 / 1.0001 mm = 9.99900 in
  EXPECT_EQ(corrected(stage(), "G20 G90 G1 X10. F10\n"), "G20 G90 G1 X9.999 F10\n");
}

TEST(CorrectedWords, AreDiametersOnADiameterAxis) {
  kinematics::Machine::Description description = stage().machine().description();
  description.tool_chain[0].diameter = true;
  const ErrorModel model =
      ErrorModel::make(kinematics::Machine::make(description).value(), stage().effects()).value();
  // X100: the axis stands at 50 mm; a pure scale scales the word as well
  EXPECT_EQ(corrected(model, "G90 G1 X100 F100\n"), "G90 G1 X99.99 F100\n");
  const ErrorModel shifted =
      ErrorModel::make(
          model.machine(),
          modelFrom("linear-stage", R"({"effect": "location", "component": "X0X", "value_um": 10})")
              .effects())
          .value();
  EXPECT_EQ(corrected(shifted, "G90 G1 X100 F100\n"), "G90 G1 X99.98 F100\n");
}

TEST(CorrectedWords, StandInTheWorkOffset) {
  // machine 15 mm → 14.99850015
  EXPECT_EQ(corrected(stage(), "G90 G10 L2 P1 X10\nG54 G1 X5 F100\n"),
            "G90 G10 L2 P1 X10\nG54 G1 X4.999 F100\n");
  simulation::ProgramSetup setup;
  setup.work_offsets["G55"] = {500.0};
  EXPECT_EQ(corrected(stage(), "G90 G55 G1 X0 F100\n", {}, setup), "G90 G55 G1 X-0.05 F100\n");
}

TEST(CorrectedWords, FollowAnOffsetThatNamesThePlace) {
  // G92 X0 at 99.99; the next target, 150 mm in machine coordinates, is 149.985: 49.995 from there
  EXPECT_EQ(corrected(stage(), "G90 G1 X100 F100\nG92 X0\nG1 X50\n"),
            "G90 G1 X99.99 F100\nG92 X0\nG1 X49.995\n");
}

TEST(CorrectedWords, TurnWithTheCoordinates) {
  // The machine stands at (0, 100): x = −0.01 there, which is y = +0.01 in the turned coordinates.
  EXPECT_EQ(corrected(mill(), "G90 G17 G0 X0 Y0 Z0\nG68 X0 Y0 R90\nG1 X100 F100\nG69\n"),
            "G90 G17 G0 X0 Y0 Z0\nG68 X0 Y0 R90\nG1 X100 Y0.01 F100\nG69\n");
}

TEST(CorrectedWords, StandOnTheToolLength) {
  simulation::ProgramSetup setup;
  setup.tool_lengths[1] = 50.0;
  EXPECT_EQ(corrected(modelFrom("generic-3axis", scale("Z", 100)), "G90 G43 H1 G1 Z10 F100\n", {}, setup),
            "G90 G43 H1 G1 Z9.994 F100\n");
}

TEST(CorrectedWords, OfIncrementsNeverAccumulateTheirRounding) {
  std::string text = "G90 G1 X0 F100\nG91\n";
  for (int i = 0; i < 10000; ++i) text += "X0.0014\n";
  CompensationOptions options;
  options.linear_decimals = 3;
  const std::string result = corrected(stage(), text, options);
  double position = 0.0;
  double worst = 0.0;
  int steps = 0;
  for (const std::string& line : linesOf(result)) {
    if (line[0] != 'X') continue;
    position += parseNumber(std::string_view(line).substr(1)).value();
    worst = std::max(worst, std::abs(position - 0.0014 * ++steps / 1.0001));
  }
  EXPECT_EQ(steps, 10000);
  EXPECT_LE(worst, 0.0005 + 1e-9);  // half an increment at every step, and so at the end
}

TEST(CorrectedWords, OfRapidsStayWhenAsked) {
  CompensationOptions options;
  options.correct_rapids = false;
  EXPECT_EQ(corrected(stage(), "G90 G0 X100\nG1 X200 F100\n", options), "G90 G0 X100\nG1 X199.98 F100\n");
  EXPECT_EQ(corrected(stage(), "G90 G0 X100\n"), "G90 G0 X99.99\n");
}

TEST(CorrectedWords, OfMachineCoordinatesStay) {
  EXPECT_EQ(corrected(stage(), "G90 G1 X100 F100\nG53 G0 X200\nG28 X50\nG1 X100\n"),
            "G90 G1 X99.99 F100\nG53 G0 X200\nG28 X50\nG1 X99.99\n");
}

TEST(CorrectedWords, OfASubprogramAreTheSameAtTheSamePlace) {
  const std::string text =
      "O1\nG90 G54 G0 X0 Y0 Z0\nM98 P100\nM98 P100\nM30\nO100\nG0 X0 Y0 Z0\nG1 X100 Y100 F100\nM99\n";
  EXPECT_EQ(
      corrected(mill(), text),
      "O1\nG90 G54 G0 X0 Y0 Z0\nM98 P100\nM98 P100\nM30\nO100\nG0 X0 Y0 Z0\nG1 X99.99 Y100 F100\nM99\n");
}

TEST(CorrectedWords, OfASubprogramAtDifferentPlacesAreRefused) {
  simulation::ProgramSetup setup;
  setup.work_offsets["G55"] = {0.0, 200.0, 0.0};
  const Result<CompensatedText> result = test_support::correct(
      modelFrom("generic-3axis", scale("X", 100)),
      "O1\nG90 G54 G0 X0 Y0 Z0\nM98 P100\nG55 G0 X0 Y0 Z0\nM98 P100\nM30\nO100\nG1 X100 Y100 F100\nM99\n", {},
      setup);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, "compensation.repeat");
  EXPECT_EQ(result.error().kind, ErrorKind::BadInput);
  EXPECT_EQ(result.error().line, 8U);
}

}  // namespace
}  // namespace nineline::compensation
