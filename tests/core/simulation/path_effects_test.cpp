#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "core/errors/error_model_file.h"
#include "core/simulation/simulation.h"

namespace nineline::simulation {
namespace {

constexpr double kExact = 1e-12;  // mm

/// Deviation along X at the end of every block of a program on a stage that moves X alone.
std::vector<double> deviations(const std::string& effect, const std::string& text,
                               const ProgramSetup& setup = {}) {
  const Result<ErrorModel> model = errors::readErrorModel(
      R"({"format": "nineline-model/1", "machine": "linear-stage", "effects": [)" + effect + "]}", "test");
  if (!model) throw std::runtime_error(model.error().message());
  nc::MemoryText program("test.nc", text);
  NoProgress progress;
  std::vector<double> found;
  const Result<SimulationReport> report = simulateProgram(
      *model, program, setup,
      [&](const PathSample& sample) {
        if (sample.block_end) found.push_back(sample.actual.tip.x() - sample.ideal.tip.x());
        return true;
      },
      progress);
  if (!report) throw std::runtime_error(report.error().message());
  return found;
}

std::string entry(const std::string& id, const std::string& parameters, const std::string& more = "") {
  return R"({"effect": ")" + id + R"(", "joint": "X", "parameters": {)" + parameters + "}" + more + "}";
}

void expectNear(const std::vector<double>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], kExact) << i;
}

TEST(PathEffects, ASpikeShowsAfterAReversalOnly) {
  const double e = std::exp(-0.5);
  expectNear(deviations(entry("reversal_spike", R"("height": 8, "length": 2)"),
                        "G90 G1 X10 F600\nX20\nX19\nX18\nX19\n"),
             {0.0, 0.0, 0.008 * e, 0.008 * e * e, -0.008 * e});
}

TEST(PathEffects, HysteresisRunsFromSideToSide) {
  const double e = std::exp(-0.5);
  // Complete at 20; 1 mm back; 1 mm forth from where it then is.
  const double back = 0.003 - 0.006 * e;
  expectNear(
      deviations(entry("hysteresis", R"("width": 6, "length": 2)"), "G90 G1 X10 F600\nX20\nX19\nX20\n"),
      {-0.003, -0.003, back, -0.003 + (back + 0.003) * e});
}

TEST(PathEffects, ALagFollowsTheSpeed) {
  // F600 is 10 mm/s, F1200 20 mm/s.
  expectNear(deviations(entry("servo_lag", R"("tau": 0.5)"), "G90 G1 X10 F600\nX20 F1200\nX10\n"),
             {-0.005, -0.010, 0.010});
}

TEST(PathEffects, ADriftGoesOnFromTheStatedTime) {
  ProgramSetup setup;
  setup.state.time = 3600.0;
  // 10 mm at 10 mm/s: one second each.
  expectNear(deviations(entry("drift", R"("rate": 3.6)"), "G90 G1 X10 F600\nX20\n", setup),
             {0.003601, 0.003602});
}

TEST(PathEffects, AConstantTemperatureIsAnEquilibrium) {
  ProgramSetup setup;
  setup.state.conditions = {{"temp_head_C", 25.0}};
  expectNear(deviations(entry("thermal_head", R"("k": 2, "tau": 900)", R"(, "sensor": "temp_head_C")"),
                        "G90 G1 X10 F600\nX20\n", setup),
             {0.010, 0.010});
}

TEST(PathEffects, TimeInTheResultBeginsAtZero) {
  const Result<ErrorModel> model = errors::readErrorModel(
      R"({"format": "nineline-model/1", "machine": "linear-stage", "effects": []})", "test");
  ASSERT_TRUE(model);
  ProgramSetup setup;
  setup.state.time = 100.0;
  nc::MemoryText program("test.nc", "G90 G1 X10 F600\n");
  NoProgress progress;
  const Result<SimulationReport> report = simulateProgram(
      *model, program, setup, [](const PathSample&) { return true; }, progress);
  ASSERT_TRUE(report);
  EXPECT_NEAR(report->time, 1.0, 1e-12);
}

}  // namespace
}  // namespace nineline::simulation
