// Blocks that become several: arcs, bending errors, reversals; and what stands on which of the lines.
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/errors/error_model_file.h"
#include "tests/core/compensation/correction.h"

namespace nineline::compensation {
namespace {

using test_support::backlash;
using test_support::correct;
using test_support::corrected;
using test_support::hasWarning;
using test_support::linesOf;
using test_support::modelFrom;
using test_support::scale;
using test_support::squareX;

constexpr double kRounding = 0.0005 * 1.7320508;  // mm: half an increment of three axes
constexpr double kTolerance = 0.0005;             // mm: half an increment, because the default is finer

ErrorModel square() { return modelFrom("generic-3axis", squareX()); }
/// The table moves the workpiece by +10 µm along X, the tool in W by −10 µm.
ErrorModel shifted() {
  return modelFrom("generic-3axis", R"({"effect": "location", "component": "X0X", "value_um": 10})");
}
const std::string kBump = R"({"effect": "table", "joint": "X", "component": "EXX", "start_mm": 0,
  "spacing_mm": 50, "values_um": [0, 0, 20, 0, 0]})";

CompensatedText needed(const ErrorModel& model, const std::string& text,
                       const CompensationOptions& options = {}) {
  const Result<CompensatedText> result = correct(model, text, options);
  EXPECT_TRUE(result) << result.error().message();
  return result ? *result : CompensatedText{};
}

double wordOf(const std::string& line, char letter) {
  const std::size_t begin = line.find(letter) + 1;
  return parseNumber(std::string_view(line).substr(begin, line.find_first_of(" GXYZIJKFM", begin) - begin))
      .value_or(NAN);
}

TEST(CorrectedArcs, StayOneArcWhereTheErrorIsAShift) {
  EXPECT_EQ(corrected(shifted(), "G90 G17 G0 X10 Y0 Z0\nG2 X10 Y0 I-10 J0 F100\nG3 X0 Y10 I-10 J0\n"),
            "G90 G17 G0 X10.01 Y0 Z0\nG2 X10.01 Y0 I-10 J0 F100\nG3 X0.01 Y10 I-10 J0\n");
  EXPECT_EQ(corrected(shifted(), "G90 G18 G0 X10 Y0 Z0\nG2 X0 Z-10 I-10 K0 F100\n"),
            "G90 G18 G0 X10.01 Y0 Z0\nG2 X0.01 Z-10 I-10 K0 F100\n");
  EXPECT_EQ(corrected(shifted(), "G90 G17 G0 X10 Y0 Z0\nG3 X0 Y10 Z5 I-10 J0 F100\n"),
            "G90 G17 G0 X10.01 Y0 Z0\nG3 X0.01 Y10 Z5 I-10 J0 F100\n");
}

TEST(CorrectedArcs, KeepTheirRadiusWordWhereItStatesTheCentreWell) {
  const std::string start = "G90 G17 G0 X10 Y0 Z0\n";
  const std::string shifted_start = "G90 G17 G0 X10.01 Y0 Z0\n";
  EXPECT_EQ(corrected(shifted(), start + "G3 X0 Y10 R10 F100\n"), shifted_start + "G3 X0.01 Y10 R10 F100\n");
  EXPECT_EQ(corrected(shifted(), start + "G3 X0 Y-10 R-10 F100\n"),
            shifted_start + "G3 X0.01 Y-10 R-10 F100\n");
  // At half a turn R says nothing about the centre: it becomes I and J.
  const std::string half = corrected(shifted(), start + "G3 X-10 Y0 R10 F100\n");
  EXPECT_EQ(half.find('R'), std::string::npos) << half;
  EXPECT_NEAR(wordOf(linesOf(half)[1], 'I'), -10.0, 1e-9) << half;
}

TEST(CorrectedArcs, WithAbsoluteCentresMoveThem) {
  EXPECT_EQ(corrected(shifted(), "G90 G17 G90.1 G0 X10 Y0 Z0\nG3 X0 Y10 I0 J0 F100\n"),
            "G90 G17 G90.1 G0 X10.01 Y0 Z0\nG3 X0.01 Y10 I0.01 J0 F100\n");
}

TEST(CorrectedArcs, SplitWhereSquarenessMakesAnEllipse) {
  const CompensatedText result = needed(square(), "G90 G17 G0 X100 Y0 Z0\nG2 X100 Y0 I-100 J0 F500\n");
  EXPECT_GT(result.report.inserted, 0U);
  EXPECT_NEAR(umFromMm(result.report.before.norm.max), 10.0, 0.01);  // θ r at Y ±100
  EXPECT_LE(result.report.after.norm.max, kTolerance + kRounding);
}

TEST(CorrectedArcs, ShorterThanTheRoundingDoNotTurnAbout) {
  std::string text = "G90 G17 G0 X100.0004 Y50 Z0\n";
  for (int i = 1; i <= 40; ++i) text += "G3 X" + std::to_string(100.0 + 0.001 * i) + " Y50 R5 F100\n";
  CompensationOptions options;
  options.linear_decimals = 3;
  const CompensatedText result =
      needed(modelFrom("generic-3axis", squareX() + "," + scale("X", 130)), text, options);
  EXPECT_LE(result.report.after.norm.max, 0.003);
}

TEST(CorrectedBlocks, SplitAlongABump) {
  const ErrorModel model = modelFrom("linear-stage", kBump);
  const std::string text = "G90 G1 X0 F100\nX200\n";
  const CompensatedText result = needed(model, text);
  EXPECT_GT(result.report.inserted, 2U);
  EXPECT_GT(result.report.before.norm.max, 0.019);
  EXPECT_LE(result.report.after.norm.max, kTolerance + 0.0005);
  CompensationOptions options;
  options.keep_block_count = true;
  const CompensatedText kept = needed(model, text, options);
  EXPECT_EQ(kept.report.inserted, 0U);
  EXPECT_TRUE(hasWarning(kept.report, "compensation.tolerance"));
}

TEST(CorrectedBlocks, KeepTheirTimeInInverseTimeFeed) {
  const CompensatedText result = needed(square(), "G90 G17 G0 X100 Y0 Z0\nG93\nG2 X100 Y0 I-100 J0 F2\n");
  double minutes = 0.0;
  int pieces = 0;
  for (const std::string& line : linesOf(result.text)) {
    if (line.find('F') == std::string::npos) continue;
    minutes += 1.0 / wordOf(line, 'F');
    ++pieces;
  }
  EXPECT_GT(pieces, 1);
  EXPECT_NEAR(minutes, 0.5, 1e-5);
}

TEST(CorrectedBlocks, CarryCodesWhereTheyAct) {
  const std::string start = "G90 G17 G0 X100 Y0 Z0\n";
  const std::vector<std::string> stops =
      linesOf(needed(square(), start + "G2 X100 Y0 I-100 J0 F500 M0\n").text);
  ASSERT_GT(stops.size(), 2U);
  for (std::size_t i = 1; i < stops.size(); ++i)
    EXPECT_EQ(stops[i].find("M0") != std::string::npos, i + 1 == stops.size()) << stops[i];
  // Controls differ on when M5 acts: its block stays one block.
  EXPECT_EQ(linesOf(needed(square(), start + "G2 X100 Y0 I-100 J0 F500 M5\n").text).size(), 2U);
  const std::vector<std::string> starts =
      linesOf(needed(square(), start + "G2 X100 Y0 I-100 J0 F500 S900 M3\nX101 Y1 R20\n").text);
  ASSERT_GT(starts.size(), 3U);
  for (std::size_t i = 1; i < starts.size(); ++i)
    EXPECT_EQ(starts[i].find("S900 M3") != std::string::npos, i == 1) << starts[i];
}

/// With a linear word of a micrometre beside it, F would count that micrometre and C would turn at any speed.
TEST(CorrectedBlocks, TurnARotaryAxisAloneWithoutLinearWords) {
  const std::string example = NINELINE_SOURCE_DIR "/resources/examples/b2-k3032-model.json";
  const auto model = errors::loadErrorModel(example);
  ASSERT_TRUE(model) << model.error().message();
  const CompensatedText result =
      needed(*model, "G21 G90 G94\nG0 X50. Z10. C0.\nG1 X40. F200\nC90. F500\nX41.\n");
  const std::vector<std::string> lines = linesOf(result.text);
  bool turning = false;
  for (const std::string& line : lines) {
    if (line.find("F500") != std::string::npos) turning = true;
    if (turning && line[0] != 'C') break;
    if (turning) {
      EXPECT_EQ(line.find_first_of("XZ"), std::string::npos) << line;
    }
  }
  EXPECT_TRUE(turning);
  EXPECT_TRUE(hasWarning(result.report, "compensation.turning"));
}

/// A line before the one that says G91 would be read as absolute.
TEST(CorrectedBlocks, PutNoLineBeforeOneThatSetsModes) {
  const CompensatedText result =
      needed(square(), "G90 G17 G0 X100 Y0 Z0\nG91 G2 X0 Y0 I-100 J0 F500 M5\nG90 G1 X0 Y0\n");
  EXPECT_EQ(linesOf(result.text).size(), 3U);
  const ErrorModel play = modelFrom("generic-3axis", backlash("X", 10));
  const CompensatedText lines =
      needed(play, "G90 G0 X0 Y0 Z0\nG1 X100 Y100 F500\nG91 G1 X-50 Y50\nX-50 Y50\n");
  EXPECT_EQ(linesOf(lines.text)[2].substr(0, 6), "G91 G1") << lines.text;
  EXPECT_LE(lines.report.after.norm.max, kTolerance + kRounding) << lines.text;
}

TEST(Reversals, TakeUpThePlayBeforeTheBlock) {
  const ErrorModel model = modelFrom("generic-3axis", backlash("X", 10));
  EXPECT_EQ(corrected(model, "G90 G0 X-1 Y0 Z0\nG1 X10 Y0 F100\nG1 X0 Y10\n"),
            "G90 G0 X-1.005 Y0 Z0\nG1 X10.005 Y0 F100\nG01 X9.995\nG1 X-0.005 Y10\n");
  // alone, the joint crosses its play on the way
  EXPECT_EQ(corrected(modelFrom("linear-stage", backlash("X", 10)), "G90 G1 X10 F100\nX0\n"),
            "G90 G1 X10.005 F100\nX-0.005\n");
}

TEST(Reversals, InsideArcsAndIncrementsLeaveNothing) {
  const ErrorModel model = modelFrom("generic-3axis", backlash("X", 10) + "," + backlash("Y", 6));
  for (const char* text :
       {"G90 G17 G0 X-10 Y-10 Z0\nX10 Y0\nG1 X12 Y1 F100\nG3 X12 Y1 I-10 J0\nX12 Y1 I-10 J0\nG2 X12 Y1 I-10 "
        "J0\n",
        "G90 G17 G0 X-10 Y-10 Z0\nG91\nG1 X20 Y10 F100\nX-5 Y5\nG3 X0 Y0 I-10 J0\nG1 X5 Y-5\nX-5 Y-5\n"}) {
    const CompensatedText result = needed(model, text);
    EXPECT_GT(result.report.before.norm.max, 0.004);
    EXPECT_LE(result.report.after.norm.max, kTolerance + kRounding) << result.text;
  }
}

}  // namespace
}  // namespace nineline::compensation
