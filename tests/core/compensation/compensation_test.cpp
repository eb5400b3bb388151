// Whole programs: five axes, refusals, warnings, files.
#include "core/compensation/compensation.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "core/base/file.h"
#include "core/base/text.h"
#include "core/base/units.h"
#include "core/kinematics/machine_file.h"
#include "tests/core/compensation/correction.h"
#include "tests/core/compensation/published_case.h"
#include "tests/support/random_machines.h"

namespace nineline::compensation {
namespace {

using test_support::correct;
using test_support::hasWarning;
using test_support::linesOf;
using test_support::modelFrom;
using test_support::PublishedCase;
using test_support::scale;
using test_support::squareX;

ErrorModel stage(double k = 100) { return modelFrom("linear-stage", scale("X", k)); }

Error refusal(const ErrorModel& model, const std::string& text, const CompensationOptions& options = {}) {
  const Result<CompensatedText> result = correct(model, text, options);
  EXPECT_FALSE(result) << result->text;
  return result ? Error{} : result.error();
}

/// Mean error of X, Z and C (arc at 24 mm) over the block ends of the published case, before and after.
struct Means {
  Eigen::Vector3d before = Eigen::Vector3d::Zero();
  Eigen::Vector3d after = Eigen::Vector3d::Zero();
  Eigen::Vector3d largest_after = Eigen::Vector3d::Zero();
  int count = 0;
};

Means publishedProgram(int decimals) {
  std::string text = "G90\n";
  for (int k = 0; k < test_support::kPublishedPoints; ++k) {
    const test_support::GrinderPlace place = test_support::publishedCommand(k);
    text += fmt::format("G01 X{:.6f} Z{:.6f} C{:.6f} F10\n", place.x, place.z, degFromRad(place.gamma));
  }
  CompensationOptions options;
  options.linear_decimals = options.rotary_decimals = decimals;
  options.keep_block_count = true;  // the published points and no others
  Means means;
  NoProgress progress;
  const auto take = [&](const simulation::PathSample& before, const simulation::PathSample& after) {
    if (!before.block_end) return;
    const test_support::GrinderGeometry geometry = PublishedCase().geometry();
    const test_support::GrinderPlace command{before.q[2], before.q[0], before.q[1]};
    const auto arc = [&](const Eigen::Vector3d& tip) {
      const test_support::GrinderPlace error = test_support::axisErrors(geometry, tip, command);
      return Eigen::Vector3d(error.x, error.z, 24.0 * error.gamma);
    };
    means.before += arc(before.actual.tip) / test_support::kPublishedPoints;
    means.after += arc(after.actual.tip) / test_support::kPublishedPoints;
    means.largest_after = means.largest_after.cwiseMax(arc(after.actual.tip).cwiseAbs());
    ++means.count;
  };
  simulation::ProgramSetup setup;
  setup.start = test_support::publishedCommand(0).joints();
  const Result<CompensatedText> result =
      compensateText(PublishedCase().model(), "thread.nc", text, setup, options, progress, take);
  EXPECT_TRUE(result) << result.error().message();
  return means;
}

TEST(PublishedProgram, IsBelowOnePercentAtANanometre) {
  const Means means = publishedProgram(6);
  EXPECT_EQ(means.count, test_support::kPublishedPoints);
  EXPECT_NEAR(means.before.x(), -0.0960001, 1e-7);
  EXPECT_NEAR(means.before.y(), 0.1570000, 1e-7);
  EXPECT_NEAR(means.before.z(), 0.0040000, 1e-7);
  const Eigen::Vector3d left = means.after.cwiseQuotient(means.before).cwiseAbs();
  EXPECT_LT(left.maxCoeff(), 0.01);
  EXPECT_LT(left.maxCoeff(), 1e-4);
  EXPECT_LT(means.largest_after.maxCoeff(), 1e-6);
}

TEST(PublishedProgram, IsAsGoodAsAMicrometreAllows) {
  const Means means = publishedProgram(3);
  EXPECT_LT(means.largest_after.x(), 0.00051);
  EXPECT_LT(means.largest_after.y(), 0.00051);
  EXPECT_LT(means.largest_after.z(), 24.0 * radFromDeg(0.00051));
  EXPECT_LT(std::abs(means.after.x() / means.before.x()), 0.01);
  EXPECT_LT(std::abs(means.after.y() / means.before.y()), 0.01);
}

const std::string kFiveAxes =
    "G90 G0 X10 Y20 Z30 A30 C0\nG1 X40 Y-20 Z50 A20 C35 F1000\nX60 Y10 Z40 A50 C-80\nX-20 A45\nC200 Y5\n";

ErrorModel trunnion() {
  test_support::Random random(11);
  return test_support::randomModel(random, *kinematics::findBuiltInMachine("trunnion-ac"));
}

TEST(FiveAxes, AreCorrectedInTipAndToolAxis) {
  CompensationOptions options;
  options.linear_decimals = options.rotary_decimals = 6;
  for (const std::string& text : {kFiveAxes, "G43.4\n" + kFiveAxes}) {
    const Result<CompensatedText> result = correct(trunnion(), text, options);
    ASSERT_TRUE(result) << result.error().message();
    EXPECT_GT(result->report.before.axis_tilt.max, 2e-5);
    EXPECT_LE(result->report.after.norm.max, options.tolerance * 1.1);
    EXPECT_LE(result->report.after.axis_tilt.max, options.angle_tolerance * 1.1);
  }
}

TEST(FiveAxes, KeepTheirRotaryWordsForTheTipOnly) {
  CompensationOptions options;
  options.linear_decimals = 6;
  options.mode = Mode::TipOnly;
  const Result<CompensatedText> result = correct(trunnion(), kFiveAxes, options);
  ASSERT_TRUE(result) << result.error().message();
  EXPECT_LE(result->report.after.norm.max, 0.001);
  EXPECT_GT(result->report.after.axis_tilt.max, 2e-5);
  EXPECT_TRUE(hasWarning(result->report, "compensation.remains"));
  options.keep_block_count = true;
  const Result<CompensatedText> kept = correct(trunnion(), kFiveAxes, options);
  ASSERT_TRUE(kept) << kept.error().message();
  EXPECT_NE(kept->text.find(" A20 C35"), std::string::npos) << kept->text;
  EXPECT_NE(kept->text.find(" A50 C-80"), std::string::npos) << kept->text;
}

TEST(Remains, AreReportedForAMissingAxis) {
  const ErrorModel model =
      modelFrom("linear-stage", R"({"effect": "location", "component": "Y0X", "value_um": 7})");
  const Result<CompensatedText> result = correct(model, "G90 G1 X100 F100\n");
  ASSERT_TRUE(result);
  EXPECT_TRUE(hasWarning(result->report, "compensation.remains"));
  EXPECT_NEAR(result->report.after.y.max, 0.007, 1e-12);
}

TEST(Refusals, NameTheLine) {
  const Error limit = refusal(stage(9000), "G90 G1 X10 F100\nX200\n");  // 1.8 mm
  EXPECT_EQ(limit.code, "compensation.limit");
  EXPECT_EQ(limit.kind, ErrorKind::NoAnswer);
  EXPECT_EQ(limit.line, 2U);
  const Error travel = refusal(stage(-100), "G90 G1 X10 F100\n\nX1000\n");  // 1000.1 mm
  EXPECT_EQ(travel.code, "travel");
  EXPECT_EQ(travel.kind, ErrorKind::NoAnswer);
  EXPECT_EQ(travel.line, 3U);
  const Error word = refusal(stage(), "G90 G1 X10 F100\nX1.2.3\n");
  EXPECT_EQ(word.kind, ErrorKind::BadInput);
  EXPECT_EQ(word.line, 2U);
  EXPECT_EQ(word.source, "test.nc");
  const Error computed = refusal(stage(), "#1=5\nG90 G1 X#1 F100\n");
  EXPECT_EQ(computed.code, "compensation.computed");
  EXPECT_EQ(computed.line, 2U);
}

TEST(Refusals, OfMissingTemperaturesNameThem) {
  const ErrorModel model =
      modelFrom("linear-stage",
                R"({"effect": "thermal_screw", "joint": "X", "component": "EXX", "sensor": "temp_screw_X_C",
        "parameters": {"k": {"value": 11, "unit": "um/m/C"}, "q_fixed": {"value": 0, "unit": "mm"}}})");
  const Error missing = refusal(model, "G90 G1 X10 F100\n");
  EXPECT_EQ(missing.code, "state.missing");
  EXPECT_NE(missing.text.find("temp_screw_X_C"), std::string::npos);
  simulation::ProgramSetup setup;
  setup.state.conditions = {{"temp_screw_X_C", 30.0}};  // 110 µm/m
  EXPECT_EQ(test_support::corrected(model, "G90 G1 X100 F100\n", {}, setup), "G90 G1 X99.989 F100\n");
}

TEST(Refusals, OfOptionsAreUsageErrors) {
  CompensationOptions options;
  options.tolerance = 0.0;
  EXPECT_EQ(refusal(stage(), "G1 X1\n", options).kind, ErrorKind::Usage);
  options = {};
  options.linear_decimals = 12;
  EXPECT_EQ(refusal(stage(), "G1 X1\n", options).kind, ErrorKind::Usage);
  options = {};
  options.mode = Mode::Thread;
  EXPECT_EQ(refusal(stage(), "G1 X1\n", options).kind, ErrorKind::Usage);
}

TEST(Warnings, OfCutterCompensationAndTables) {
  const Result<CompensatedText> cutter =
      correct(modelFrom("generic-3axis", squareX()), "G90 G0 X0 Y0 Z0\nG41 D1 G1 X10 Y10 F100\nG40\n");
  ASSERT_TRUE(cutter) << cutter.error().message();
  EXPECT_TRUE(hasWarning(cutter->report, "compensation.cutter"));
  const Result<CompensatedText> outside = correct(
      modelFrom("linear-stage", R"({"effect": "table", "joint": "X", "component": "EXX", "start_mm": 0,
        "spacing_mm": 10, "values_um": [0, 1, 2]})"),
      "G90 G1 X15 F100\nX25\n");
  ASSERT_TRUE(outside);
  EXPECT_TRUE(hasWarning(outside->report, "table.outside"));
}

class CancelledProgress final : public Progress {
 public:
  void report(double, const std::string&) override {}
  [[nodiscard]] bool isCancelled() const override { return true; }
};

TEST(Files, StayUntouchedOnFailureAndCancel) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / "nineline-compensation-files";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  const std::filesystem::path source = folder / "in.nc";
  const std::filesystem::path target = folder / "out.nc";
  std::string many = "G90 G1 X0 F100\n";
  for (int i = 0; i < 5000; ++i) many += "X1\n";
  NoProgress progress;
  CancelledProgress stop;
  ASSERT_TRUE(writeFile(target, "old"));
  ASSERT_TRUE(writeFile(source, "G90 G1 X100 F100\nX5000\n"));
  EXPECT_FALSE(compensateFile(stage(), source, target, {}, {}, progress));
  EXPECT_EQ(readFile(target).value(), "old");
  ASSERT_TRUE(writeFile(source, many));
  const Result<CompensationReport> stopped = compensateFile(stage(), source, target, {}, {}, stop);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, "cancelled");
  EXPECT_EQ(readFile(target).value(), "old");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 2);
  ASSERT_TRUE(writeFile(source, "G90 G1 X100 F100\n"));
  ASSERT_TRUE(compensateFile(stage(), source, target, {}, {}, progress));
  EXPECT_EQ(readFile(target).value(), "G90 G1 X99.99 F100\n");
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace nineline::compensation
