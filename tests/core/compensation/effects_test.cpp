#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/units.h"
#include "tests/core/compensation/correction.h"

namespace nineline::compensation {
namespace {

using test_support::correct;
using test_support::modelFrom;

std::string entry(const std::string& id, const std::string& component, const std::string& parameters,
                  const std::string& more = "") {
  return R"({"effect": ")" + id + R"(", "component": ")" + component + R"(", "parameters": {)" + parameters +
         "}" + more + "}";
}

/// A program that goes to and fro on X and once round an arc, on the mill.
const char* const kProgram =
    "G90 G17 G54\nG01 X0. Y0. Z0. F1000\nX100. Y10.\nX20. Y30.\nX120. Y40.\nG03 X120. Y80. I0. J20.\n"
    "G01 X10.\nM30\n";

ProgramSetup stated(const std::vector<std::pair<std::string, double>>& conditions) {
  ProgramSetup setup;
  setup.state.conditions = conditions;
  return setup;
}

CompensationReport reportOf(const std::string& effects, ProgramSetup setup = {}) {
  CompensationOptions options;
  options.linear_decimals = 6;
  const Result<CompensatedText> result =
      correct(modelFrom("generic-3axis", effects), kProgram, options, setup);
  if (!result) throw std::runtime_error(result.error().message());
  return result->report;
}

TEST(EnlargedModels, WhatStandsStillIsRemovedWholly) {
  ProgramSetup setup = stated({{"temp_screw_X_C", 26.0},
                               {"temp_head_C", 30.0},
                               {"temp_ambient_C", 18.0},
                               {"temp_front_C", 24.0},
                               {"temp_back_C", 21.0}});
  setup.state.load = 80.0;
  setup.state.pass = 4.0;
  const CompensationReport report =
      reportOf(entry("thermal_screw", "EXX", R"("k": 11, "q_fixed": -500)") + ", " +
                   entry("thermal_head", "EZZ", R"("k": 3, "tau": 900)") + ", " +
                   entry("thermal_tilt", "EBZ", R"("k": 2)", R"(, "sensor": "front", "sensor_2": "back")") +
                   ", " + entry("straightness", "EYX", R"("amplitude": 15, "shape": 3)") + ", " +
                   entry("angular", "ECX", R"("amplitude": 8)") + ", " + entry("sag", "EZX", R"("k": 90)") +
                   ", " + entry("load_deformation", "EZZ", R"("k": 0.05)", R"(, "active": true)") + ", " +
                   entry("wheel_wear", "EXX", R"("rate": 1.5)", R"(, "active": true)"),
               setup);
  EXPECT_GT(report.before.norm.rms, mmFromUm(20.0));
  EXPECT_LT(report.after.norm.max, mmFromUm(0.15));  // the tolerance is 0.1 um
}

TEST(EnlargedModels, WhatFollowsTheSenseIsRemovedAlongLinesAndArcs) {
  for (const std::string& effect :
       {entry("hysteresis", "EXX", R"("width": 8, "length": 15)"), entry("windup", "EXX", R"("k": 60)"),
        entry("lateral_play", "EYX", R"("width": 6)"), entry("angular_play", "ECX", R"("width": 8)")}) {
    const CompensationReport report = reportOf(effect);
    EXPECT_GT(report.before.norm.rms, mmFromUm(1.0)) << effect;
    EXPECT_LT(report.after.norm.rms, 0.05 * report.before.norm.rms) << effect;
  }
}

TEST(EnlargedModels, WhatNoProgramRemovesIsNamed) {
  const CompensationReport report =
      reportOf(entry("servo_lag", "EXX", R"("tau": 0.5)") + ", " + entry("scale", "EXX", R"("k": 100)"));
  const auto& found = report.diagnostics.all();
  EXPECT_TRUE(std::any_of(found.begin(), found.end(), [](const Diagnostic& one) {
    return one.code == "compensation.left_alone" && one.text.find("servo_lag") != std::string::npos;
  }));
  EXPECT_LT(report.after.norm.rms, report.before.norm.rms);
}

TEST(EnlargedModels, AsksForWhatItNeedsAndOnlyForThat) {
  const std::string wear = R"("rate": 1.5)";
  const auto passive = modelFrom("generic-3axis", entry("wheel_wear", "EXX", wear));
  const Result<CompensatedText> untouched = correct(passive, kProgram);
  ASSERT_TRUE(untouched) << untouched.error().message();
  EXPECT_EQ(untouched->text, kProgram);
  const auto active = modelFrom("generic-3axis", entry("wheel_wear", "EXX", wear, R"(, "active": true)"));
  const Result<CompensatedText> refused = correct(active, kProgram);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().text.find("pass_1"), std::string::npos) << refused.error().text;
}

}  // namespace
}  // namespace nineline::compensation
