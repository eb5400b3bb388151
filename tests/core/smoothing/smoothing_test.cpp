#include "core/smoothing/smoothing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/kinematics/chain.h"
#include "core/smoothing/certificate.h"
#include "tests/core/smoothing/sample_programs.h"

namespace nineline::smoothing {
namespace {

using testing::impellerProgram;
using testing::impellerSetup;
using testing::machineNamed;
using testing::readBack;
using testing::setupOf;

Result<SmoothedText> smooth(const Machine& machine, const std::string& text,
                            const nc::InterpreterOptions& setup, const SmoothingOptions& options = {}) {
  NoProgress progress;
  return smoothText(machine, "in.nc", text, setup, options, progress);
}

SmoothedText smoothImpeller(int points, const SmoothingOptions& options = {}) {
  Result<SmoothedText> smoothed =
      smooth(machineNamed("trunnion-ac"), impellerProgram(points, 6), impellerSetup(), options);
  EXPECT_TRUE(smoothed) << smoothed.error().message();
  return *std::move(smoothed);
}

std::string threeAxisArc(int points, const std::string& head = "G90 G21 G0 X50. Y0. Z0.\nG1 F600\n") {
  std::string text = head;
  for (int j = 1; j < points; ++j) {
    const double angle = 2.0 * j / (points - 1);
    text +=
        "X" + std::to_string(50.0 * std::cos(angle)) + " Y" + std::to_string(50.0 * std::sin(angle)) + "\n";
  }
  return text + "G0 Z10.\nM30\n";
}

TEST(Smoothing, PathReadAgainLiesWithinTheBoundOfTheTrueCurve) {
  const SmoothedText smoothed = smoothImpeller(120);
  EXPECT_EQ(smoothed.report.segments, 1U);
  EXPECT_EQ(smoothed.report.points_smoothed, 119U);
  EXPECT_LE(smoothed.report.bound, 0.005);
  EXPECT_LE(smoothed.report.max_position_error, smoothed.report.bound);
  const Machine& machine = machineNamed("trunnion-ac");
  const testing::ReadPath path = readBack(machine, smoothed.text, impellerSetup());
  ASSERT_GT(path.values.size(), 20U);
  double worst = 0.0;
  for (std::size_t j = 0; j + 1 < path.values.size(); ++j) {
    for (int part = 0; part < 8; ++part) {  // between block ends the axes run in step
      nc::AxisValues q = path.values[j];
      for (std::size_t k = 0; k < q.size(); ++k) q[k] += part / 8.0 * (path.values[j + 1][k] - q[k]);
      worst = std::max(worst, testing::distanceToImpeller(forward(machine, q).tip));
    }
  }
  EXPECT_LE(worst, 0.005);
}

TEST(Smoothing, EveryProgrammedPointIsWithinTheBoundOfTheNewPath) {
  const Machine& machine = machineNamed("trunnion-ac");
  const SmoothedText smoothed = smoothImpeller(60);
  const testing::ReadPath before = readBack(machine, impellerProgram(60, 6), impellerSetup());
  const testing::ReadPath after = readBack(machine, smoothed.text, impellerSetup());
  std::vector<Vector3d> dense;
  for (std::size_t j = 0; j + 1 < after.values.size(); ++j) {
    for (int part = 0; part < 16; ++part) {
      nc::AxisValues q = after.values[j];
      for (std::size_t k = 0; k < q.size(); ++k) q[k] += part / 16.0 * (after.values[j + 1][k] - q[k]);
      dense.push_back(forward(machine, q).tip);
    }
  }
  dense.push_back(after.tips.back());
  for (const Vector3d& tip : before.tips) {
    double nearest = 1e9;
    for (std::size_t j = 0; j + 1 < dense.size(); ++j)
      nearest = std::min(nearest, distanceToSegment(tip, dense[j], dense[j + 1]));
    EXPECT_LE(nearest, smoothed.report.bound + 1e-4);
  }
}

TEST(Smoothing, WhatIsNotSmoothedStaysByteForByte) {
  const std::string text =
      "%\r\nO1 (A  B)\r\nN10 g90 G21\r\nG0 X0 Y0. Z5.\r\nG1 Z0 F100.\r\nX1.Y1.\r\n/X2.\r\nG2 X3 Y1 "
      "I0.5 J0\r\n; end\r\nM30\r\n%";
  const Result<SmoothedText> smoothed =
      smooth(machineNamed("generic-3axis"), text, setupOf(machineNamed("generic-3axis")));
  ASSERT_TRUE(smoothed) << smoothed.error().message();
  EXPECT_EQ(smoothed->text, text);
  EXPECT_EQ(smoothed->report.segments, 0U);
  EXPECT_EQ(smoothed->report.points_in, smoothed->report.points_out);
}

TEST(Smoothing, KeepsHeadAndTailOfASmoothedProgram) {
  const SmoothedText smoothed = smoothImpeller(60);
  const std::string program = impellerProgram(60, 6);
  const std::string head = program.substr(0, program.find("G1 "));
  EXPECT_EQ(smoothed.text.substr(0, head.size()), head);
  EXPECT_TRUE(smoothed.text.ends_with("M5\nM30\n%\n"));
  EXPECT_EQ(smoothed.text.find("nan"), std::string::npos);
}

TEST(Smoothing, ThreeAxisPathsProfit) {
  const Machine& machine = machineNamed("generic-3axis");
  const Result<SmoothedText> smoothed = smooth(machine, threeAxisArc(300), setupOf(machine));
  ASSERT_TRUE(smoothed) << smoothed.error().message();
  EXPECT_EQ(smoothed->report.segments, 1U);
  EXPECT_LT(smoothed->report.points_out, 300U);
  for (const Vector3d& tip : readBack(machine, smoothed->text, setupOf(machine)).tips) {
    if (tip.z() != 0.0) continue;
    EXPECT_NEAR(std::hypot(tip.x(), tip.y()), 50.0, 0.005);
  }
}

TEST(Smoothing, FeedsStayWhereTheyWere) {
  const Machine& machine = machineNamed("generic-3axis");
  std::string text = threeAxisArc(200);
  text.insert(text.find('\n', text.size() / 2), " F900");
  text.insert(text.find("\nG0 Z10."), " F50");
  const Result<SmoothedText> smoothed = smooth(machine, text, setupOf(machine));
  ASSERT_TRUE(smoothed);
  EXPECT_EQ(smoothed->report.segments, 1U);
  EXPECT_NE(smoothed->text.find(" F900."), std::string::npos);
  EXPECT_LT(smoothed->text.find(" F900."), smoothed->text.find(" F50."));
}

TEST(Smoothing, SplitsNothingAtRepeatedPointsAndNeverWritesNonsense) {
  const Machine& machine = machineNamed("generic-3axis");
  std::string text = threeAxisArc(100);
  const std::size_t end = text.find('\n', text.size() / 2) + 1;
  const std::size_t begin = text.rfind('\n', end - 2) + 1;
  text.insert(end, text.substr(begin, end - begin));
  const Result<SmoothedText> smoothed = smooth(machine, text, setupOf(machine));
  ASSERT_TRUE(smoothed);
  EXPECT_EQ(smoothed->report.segments, 1U);
}

TEST(Smoothing, DegenerateProgramsStayAsTheyAre) {
  const Machine& machine = machineNamed("generic-3axis");
  for (const std::string text :
       {"", "M30\n", "G1 X1. F100\nM30\n", "G90 G0 X0 Y0 Z0\nG1 X1. F100\nX1.\nX1.\nM30\n",
        "G90 G0 X0 Y0 Z0\nG1 X1. F100\nX0.\nX1.\nX0.\nM30\n",
        "G91\nG1 X1. F100\nX1. Y.1\nX1. Y.2\nX1. Y.3\nM30\n",
        "G90 G0 X0 Y0 Z0\nG1 X1. F100\nX2. Y.01\nM30\n"}) {
    const Result<SmoothedText> smoothed = smooth(machine, text, setupOf(machine));
    ASSERT_TRUE(smoothed) << text << smoothed.error().message();
    EXPECT_EQ(smoothed->text, text);
  }
}

TEST(Smoothing, ALoopIsNotSmoothed) {
  const Machine& machine = machineNamed("generic-3axis");
  std::string body = threeAxisArc(30, "G90 G21 G0 X50. Y0. Z0.\n#1=0\nWHILE [#1 LT 2] DO1\nG1 F600\n");
  body.insert(body.find("G0 Z10."), "#1=#1+1\nEND1\n");
  const Result<SmoothedText> smoothed = smooth(machine, body, setupOf(machine));
  ASSERT_TRUE(smoothed) << smoothed.error().message();
  EXPECT_EQ(smoothed->text, body);
  ASSERT_FALSE(smoothed->report.diagnostics.all().empty());
  EXPECT_EQ(smoothed->report.diagnostics.all().front().code, "smoothing.repeated");
}

TEST(Smoothing, UnreadableWordsAreRefusedWithTheirPlace) {
  const Machine& machine = machineNamed("generic-3axis");
  const Result<SmoothedText> smoothed = smooth(machine, "G1 X1. F100\nG1 Y1..2\nM30\n", setupOf(machine));
  const bool refused = !smoothed || smoothed->report.diagnostics.hasErrors();
  EXPECT_TRUE(refused);
}

TEST(Smoothing, SplinesNeedTipControlWhereRotaryAxesMove) {
  SmoothingOptions options;
  options.format = Format::FanucNurbs;
  const Result<SmoothedText> smoothed =
      smooth(machineNamed("trunnion-ac"), impellerProgram(60, 6), impellerSetup(), options);
  ASSERT_FALSE(smoothed);
  EXPECT_EQ(smoothed.error().kind, ErrorKind::BadInput);
  EXPECT_EQ(smoothed.error().line, 6U);
}

TEST(Smoothing, JumpsOfSecondDifferencesFall) {
  Result<SmoothedText> smoothed =
      smooth(machineNamed("trunnion-ac"), impellerProgram(400, 3), impellerSetup());
  ASSERT_TRUE(smoothed);
  for (const AxisJumps& one : smoothed->report.jumps)
    EXPECT_LT(one.after_rms, 0.1 * one.before_rms) << one.axis.text();
}

/// Control points, knots and words of a G06.2 block, to evaluate it apart from the writer.
TEST(Smoothing, NurbsTextDescribesTheCurve) {
  const Machine& machine = machineNamed("generic-3axis");
  SmoothingOptions options;
  options.format = Format::FanucNurbs;
  const Result<SmoothedText> smoothed = smooth(machine, threeAxisArc(200), setupOf(machine), options);
  ASSERT_TRUE(smoothed) << smoothed.error().message();
  std::vector<double> knots;
  std::vector<double> words;
  std::size_t at = smoothed->text.find("G06.2 P4 K");
  ASSERT_NE(at, std::string::npos);
  const std::string curve_text = smoothed->text.substr(at, smoothed->text.find("G01", at) - at);
  for (std::size_t i = 8; i < curve_text.size(); ++i) {
    if (curve_text[i] == 'K') knots.push_back(std::stod(curve_text.substr(i + 1)));
    if (curve_text[i] == 'X' || curve_text[i] == 'Y') words.push_back(std::stod(curve_text.substr(i + 1)));
  }
  ASSERT_EQ(knots.size(), words.size() / 2 + 4);
  PointRows control = PointRows::Zero(static_cast<Eigen::Index>(words.size() / 2), 3);
  for (std::size_t i = 0; i < words.size(); ++i)
    control(static_cast<Eigen::Index>(i / 2), static_cast<Eigen::Index>(i % 2)) = words[i];
  EXPECT_EQ(knots[0], knots[3]);
  const BSpline curve(knots, control);
  for (double u = 0.0; u <= curve.end(); u += 0.05)
    EXPECT_NEAR(std::hypot(curve.at(u)[0], curve.at(u)[1]), 50.0, 0.005) << u;
}

TEST(Smoothing, PolynomialBlocksEndWhereTheProgramEnds) {
  const Machine& machine = machineNamed("generic-3axis");
  SmoothingOptions options;
  options.format = Format::SiemensPoly;
  const Result<SmoothedText> smoothed = smooth(machine, threeAxisArc(200), setupOf(machine), options);
  ASSERT_TRUE(smoothed) << smoothed.error().message();
  const std::string& text = smoothed->text;
  std::array<double, 2> from{50.0, 0.0};
  std::size_t blocks = 0;
  for (std::size_t found = text.find("PO[X]"); found != std::string::npos;
       found = text.find("PO[X]", found + 1), ++blocks) {
    const std::size_t at = text.rfind('\n', found);
    const double length = std::stod(text.substr(text.find("PL=", at) + 3));
    std::array<std::array<double, 3>, 2> c{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      std::size_t place = text.find('(', text.find(axis == 0 ? "PO[X]" : "PO[Y]", at)) + 1;
      for (double& value : c[axis]) {
        value = std::stod(text.substr(place));
        place = text.find(',', place) + 1;
      }
    }
    for (double p = 0.0; p <= length; p += length / 50.0) {
      std::array<double, 2> point{};
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const auto& [end, a2, a3] = c[axis];
        const double a1 = (end - from[axis] - a2 * length * length - a3 * length * length * length) / length;
        point[axis] = from[axis] + p * (a1 + p * (a2 + p * a3));
      }
      EXPECT_NEAR(std::hypot(point[0], point[1]), 50.0, 0.005);
    }
    from = {c[0][0], c[1][0]};
  }
  EXPECT_GT(blocks, 1U);
  EXPECT_NEAR(from[0], 50.0 * std::cos(2.0), 1e-6);
}

TEST(Smoothing, TooFewDigitsForTheToleranceLeaveTheProgram) {
  SmoothingOptions options;
  options.linear_decimals = 2;
  options.tolerance = 0.002;
  const SmoothedText smoothed = smoothImpeller(60, options);
  EXPECT_EQ(smoothed.text, impellerProgram(60, 6));
  EXPECT_FALSE(smoothed.report.diagnostics.all().empty());
}

}  // namespace
}  // namespace nineline::smoothing
