#include "core/simulation/simulation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/errors/error_model_file.h"
#include "core/kinematics/machine_file.h"

namespace nineline::simulation {
namespace {

constexpr double kExact = 1e-12;

ErrorModel modelFrom(const std::string& machine, const std::string& effects) {
  const Result<ErrorModel> model = errors::readErrorModel(
      R"({"format": "nineline-model/1", "machine": ")" + machine + R"(", "effects": [)" + effects + "]}",
      "test");
  EXPECT_TRUE(model) << model.error().message();
  return model.value();
}

ErrorModel ideal(const std::string& machine) { return ErrorModel(*kinematics::findBuiltInMachine(machine)); }

const std::string kBacklash = R"({"effect": "backlash", "joint": "X", "component": "EXX",
  "parameters": {"width": {"value": 10, "unit": "um"}}})";
const std::string kScale = R"({"effect": "scale", "joint": "X", "component": "EXX",
  "parameters": {"k": {"value": 100, "unit": "um/m"}}})";

struct SimulatedPath {
  std::vector<PathSample> samples;
  Result<SimulationReport> report;
  /// Samples at the ends of blocks, in order.
  [[nodiscard]] std::vector<PathSample> ends() const {
    std::vector<PathSample> found;
    for (const PathSample& sample : samples) {
      if (sample.block_end) found.push_back(sample);
    }
    return found;
  }
};

SimulatedPath simulated(const ErrorModel& model, const std::string& text, const ProgramSetup& setup = {}) {
  nc::MemoryText program("test.nc", text);
  NoProgress progress;
  std::vector<PathSample> samples;
  Result<SimulationReport> report = simulateProgram(
      model, program, setup,
      [&](const PathSample& sample) {
        samples.push_back(sample);
        return true;
      },
      progress);
  return {std::move(samples), std::move(report)};
}

TEST(Simulation, BacklashIsATrueDeadBand) {
  // Width 10 µm: the joint lags by 5 µm, stands while the command crosses 10 µm, then lags on the other side.
  const SimulatedPath run = simulated(modelFrom("linear-stage", kBacklash),
                                      "G90 G1 X1 F60\nX0.996\nX0.992\nX0.98\nX0.985\nX0.9895\nX0.991\n");
  ASSERT_TRUE(run.report);
  const std::vector<double> actual = {0.995, 0.995, 0.995, 0.985, 0.985, 0.985, 0.986};
  const std::vector<PathSample> ends = run.ends();
  ASSERT_EQ(ends.size(), actual.size());
  for (std::size_t i = 0; i < actual.size(); ++i) EXPECT_NEAR(ends[i].actual.tip.x(), actual[i], kExact) << i;
}

TEST(Simulation, SamplesTheEndOfADeadBand) {
  const SimulatedPath run = simulated(modelFrom("linear-stage", kBacklash), "G90 G1 X1 F60\nX0\n");
  bool seen = false;
  for (const PathSample& sample : run.samples) seen = seen || std::abs(sample.q[0] - 0.99) < 1e-9;
  EXPECT_TRUE(seen);
}

TEST(Simulation, HasEveryBlockEndAndMarksRapids) {
  const SimulatedPath run =
      simulated(modelFrom("linear-stage", kScale), "G90 G0 X10\nG1 X20 F100\nX-30\nG0 X5\n");
  ASSERT_TRUE(run.report);
  const std::vector<PathSample> ends = run.ends();
  ASSERT_EQ(ends.size(), 4U);
  const std::vector<double> x = {10, 20, -30, 5};
  const std::vector<bool> rapid = {true, false, false, true};
  double s = 0.0;
  double last = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    s += std::abs(x[i] - last);
    last = x[i];
    EXPECT_EQ(ends[i].line, i + 1);
    EXPECT_EQ(ends[i].rapid, rapid[i]);
    EXPECT_NEAR(ends[i].ideal.tip.x(), x[i], kExact);
    EXPECT_NEAR(ends[i].deviation.tip.x(), 1e-4 * x[i], kExact);
    EXPECT_NEAR(ends[i].deviation.joints[0], 1e-4 * x[i], kExact);
    EXPECT_NEAR(ends[i].s, s, 1e-9);
  }
  EXPECT_EQ(run.report->blocks, 4U);
  EXPECT_EQ(run.report->motions, 4U);
  EXPECT_NEAR(run.report->path_length, 105.0, 1e-9);
  EXPECT_NEAR(run.report->deviation.x.max, 0.003, kExact);  // cutting motions only
}

TEST(Simulation, ChordsStayNearAnArc) {
  for (const char* text : {"G90 G17 G0 X80 Y0 Z0\nG3 X80 Y0 I-80 J0 F100\n",
                           "G90 G17 G0 X80 Y0 Z0\nG2 X0 Y-80 Z30 I-80 J0 F100\n"}) {
    const SimulatedPath run = simulated(ideal("generic-3axis"), text);
    ASSERT_TRUE(run.report);
    for (std::size_t i = 2; i < run.samples.size(); ++i) {
      const Eigen::Vector3d& a = run.samples[i - 1].ideal.tip;
      const Eigen::Vector3d& b = run.samples[i].ideal.tip;
      EXPECT_NEAR(b.head<2>().norm(), 80.0, 1e-9);
      EXPECT_GE((0.5 * (a + b)).head<2>().norm(), 80.0 - 0.002 - 1e-9);
    }
  }
  const SimulatedPath turning = simulated(ideal("b2-k3032"), "G90 G0 X80 Z0 C0\nG1 C360 Z-3 F1000\n");
  ASSERT_TRUE(turning.report);
  for (std::size_t i = 2; i < turning.samples.size(); ++i) {
    const Eigen::Vector3d middle = 0.5 * (turning.samples[i - 1].ideal.tip + turning.samples[i].ideal.tip);
    EXPECT_GE(middle.head<2>().norm(), 80.0 - 0.002 - 1e-9);
  }
}

TEST(Simulation, KnowsTheTimeOfEveryFeedMode) {
  const auto timeOf = [](const std::string& text) {
    const SimulatedPath run = simulated(ideal("linear-stage"), text);
    EXPECT_TRUE(run.report) << run.report.error().message();
    return run.report->time;
  };
  EXPECT_NEAR(timeOf("G90 G94 G1 X1 F60\n"), 1.0, 1e-9);
  EXPECT_NEAR(timeOf("G90 G93 G1 X1 F2\n"), 30.0, 1e-9);
  EXPECT_NEAR(timeOf("G90 G95 S60 M3\nG1 X1 F0.5\n"), 2.0, 1e-9);
  EXPECT_NEAR(timeOf("G90 G0 X100\n"), 0.4, 1e-9);  // 15 m/min
}

TEST(Simulation, RefusesWithTheLine) {
  const SimulatedPath outside = simulated(ideal("linear-stage"), "G90 G1 X10 F100\n\nX2000\n");
  ASSERT_FALSE(outside.report);
  EXPECT_EQ(outside.report.error().kind, ErrorKind::NoAnswer);
  EXPECT_EQ(outside.report.error().code, "travel");
  EXPECT_EQ(outside.report.error().line, 3U);
  EXPECT_EQ(outside.report.error().source, "test.nc");
  const SimulatedPath unreadable = simulated(ideal("linear-stage"), "G90 G1 X10 F100\nG1 X[\n");
  // The path is shown all the same; the fault is among the diagnostics.
  ASSERT_TRUE(unreadable.report);
  ASSERT_TRUE(unreadable.report->diagnostics.hasErrors());
  EXPECT_EQ(unreadable.report->diagnostics.firstError("test.nc").line, 2U);
}

TEST(Simulation, AsksForTheConditionsOfTheModel) {
  const ErrorModel model =
      modelFrom("linear-stage",
                R"({"effect": "thermal_screw", "joint": "X", "component": "EXX", "sensor": "temp_screw_X_C",
        "parameters": {"k": {"value": 11, "unit": "um/m/C"}, "q_fixed": {"value": 0, "unit": "mm"}}})");
  const SimulatedPath missing = simulated(model, "G90 G1 X10 F100\n");
  ASSERT_FALSE(missing.report);
  EXPECT_EQ(missing.report.error().kind, ErrorKind::BadInput);
  EXPECT_NE(missing.report.error().text.find("temp_screw_X_C"), std::string::npos);
  ProgramSetup setup;
  setup.state.conditions = {{"temp_screw_X_C", 22.0}};
  const SimulatedPath known = simulated(model, "G90 G1 X100 F100\n", setup);
  ASSERT_TRUE(known.report);
  EXPECT_NEAR(known.samples.back().deviation.tip.x(), 22e-6 * 100.0, kExact);
}

TEST(Simulation, WarnsOnceOutsideATable) {
  const SimulatedPath run =
      simulated(modelFrom("linear-stage", R"({"effect": "table", "joint": "X", "component": "EXX",
    "start_mm": 0, "spacing_mm": 10, "values_um": [0, 1, 2]})"),
                "G90 G1 X15 F100\nX25\nX30\n");
  ASSERT_TRUE(run.report);
  ASSERT_EQ(run.report->diagnostics.all().size(), 1U);
  EXPECT_EQ(run.report->diagnostics.all()[0].code, "table.outside");
  EXPECT_GT(run.report->diagnostics.all()[0].count, 1U);
  EXPECT_NEAR(run.samples.back().deviation.tip.x(), 0.002, kExact);
}

TEST(Simulation, StopsWhenTheSinkHasEnough) {
  nc::MemoryText program("test.nc", "G90 G1 X15 F100\nX25\nX30\n");
  NoProgress progress;
  int seen = 0;
  ASSERT_TRUE(simulateProgram(
      ideal("linear-stage"), program, {}, [&](const PathSample&) { return ++seen < 2; }, progress));
  EXPECT_EQ(seen, 2);
}

TEST(PathCsv, HasTheColumnsOfTheContract) {
  const kinematics::Machine& machine = *kinematics::findBuiltInMachine("b2-k3032");
  EXPECT_EQ(
      pathCsvHeader(machine),
      "block_1,s_mm,t_s,rapid_1,Z_mm,C_deg,X_mm,ideal_x_mm,ideal_y_mm,ideal_z_mm,actual_x_mm,actual_y_mm,"
      "actual_z_mm,ideal_i_1,ideal_j_1,ideal_k_1,actual_i_1,actual_j_1,actual_k_1,dev_x_um,dev_y_um,"
      "dev_z_um,err_Z_um,err_C_arcsec,err_X_um\n");
  PathSample sample;
  sample.line = 7;
  sample.rapid = true;
  sample.q = {1.5, kPi, 20.0};
  sample.deviation.tip = {0.001, -0.002, 0.0};
  sample.deviation.joints = {0.003, radFromArcsec(4.0), -0.005};
  std::string row;
  appendPathCsvRow(machine, sample, row);
  ASSERT_EQ(row.back(), '\n');
  const std::string head = pathCsvHeader(machine);
  const std::vector<std::string_view> names = split(trimmed(head), ',');
  const std::vector<std::string_view> cells = split(trimmed(row), ',');
  ASSERT_EQ(cells.size(), names.size());
  const auto cell = [&](std::string_view name) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i] == name) return parseNumber(cells[i]).value();
    }
    return std::nan("");
  };
  EXPECT_EQ(cell("block_1"), 7.0);
  EXPECT_EQ(cell("rapid_1"), 1.0);
  EXPECT_EQ(cell("Z_mm"), 1.5);
  EXPECT_EQ(cell("C_deg"), 180.0);
  EXPECT_EQ(cell("dev_x_um"), 1.0);
  EXPECT_EQ(cell("dev_y_um"), -2.0);
  EXPECT_EQ(cell("err_Z_um"), 3.0);
  EXPECT_EQ(cell("err_C_arcsec"), 4.0);
  EXPECT_EQ(cell("err_X_um"), -5.0);
}

}  // namespace
}  // namespace nineline::simulation
