#include "core/measurement/run_checks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/kinematics/machine_file.h"
#include "tests/core/measurement/set_ups.h"

namespace nineline::measurement {
namespace {

const Machine& stage() { return *kinematics::findBuiltInMachine("linear-stage"); }

double curve(double x) { return 8e-3 * std::sin(x / 90.0) + 2e-5 * x; }

/// Runs 0…400 mm in steps of 20, forward and backward in turn, of two channels; `change` spoils one sample.
struct Case {
  std::size_t runs = 6;
  std::function<bool(int run, double x)> keep = [](int, double) { return true; };
  std::function<void(int run, double x, double& one, double& two)> change = [](int, double, double&,
                                                                               double&) {};
};

Measurement measurementOf(const Case& what, unsigned seed = 330) {
  test_support::Random random(seed);
  std::vector<JointPositions> positions;
  std::vector<std::optional<double>> runs;
  std::vector<std::optional<double>> readings;
  for (int run = 1; run <= static_cast<int>(what.runs); ++run) {
    for (int i = 0; i <= 20; ++i) {
      const double x = run % 2 == 1 ? 20.0 * i : 400.0 - 20.0 * i;
      if (!what.keep(run, x)) continue;
      double one = curve(x) + random.between(-4e-4, 4e-4) + (run % 2 == 0 ? 1e-3 : 0.0);
      double two = 5e-3 * std::cos(x / 60.0) + random.between(-4e-4, 4e-4);
      what.change(run, x, one, two);
      positions.push_back({x});
      runs.emplace_back(run);
      readings.emplace_back(one);
      readings.emplace_back(two);
    }
  }
  Measurement measurement = measurementAt(Instrument{}, {{Quantity::DevX}, {Quantity::DevY}}, positions);
  measurement.readings = readings;
  measurement.repeatability = 4e-4;
  addColumn(measurement, "run", runs);
  return measurement;
}

std::vector<std::string> codesOf(const std::vector<RunFault>& faults) {
  std::vector<std::string> codes;
  for (const RunFault& fault : faults) {
    codes.push_back(fault.code + (fault.run ? " " + std::to_string(static_cast<int>(*fault.run)) : ""));
  }
  return codes;
}
using Codes = std::vector<std::string>;

Codes codesOf(const Case& what) { return codesOf(checkRuns(measurementOf(what), stage())); }

TEST(RunChecks, SayNothingOfSoundRuns) {
  for (unsigned seed = 400; seed < 600; ++seed) {
    EXPECT_EQ(codesOf(checkRuns(measurementOf(Case{}, seed), stage())), Codes{}) << seed;
  }
}

TEST(RunChecks, NoticeASign) {
  Case what;
  what.change = [](int run, double, double& one, double&) { one = run == 3 ? -one : one; };
  const std::vector<RunFault> faults = checkRuns(measurementOf(what), stage());
  ASSERT_EQ(codesOf(faults), Codes{"run.sign 3"});
  EXPECT_EQ(faults[0].first_row, 43u);
  EXPECT_EQ(faults[0].last_row, 63u);
  EXPECT_EQ(faults[0].factor, -1.0);
}

TEST(RunChecks, NoticeUnits) {
  for (const double factor : {1000.0, 1e-3, 25.4, 1.0 / 25.4}) {
    Case what;
    what.change = [factor](int run, double, double& one, double& two) {
      if (run != 4) return;
      one *= factor;
      two *= factor;
    };
    EXPECT_EQ(codesOf(what), (Codes{"run.factor 4", "run.factor 4"})) << factor;
  }
}

TEST(RunChecks, NoticeTheOppositeOrderAndExchangedChannels) {
  Case what;
  what.change = [](int run, double x, double& one, double&) { one = run == 5 ? curve(400.0 - x) : one; };
  const Codes reversed = codesOf(what);
  ASSERT_EQ(reversed.size(), 1u);
  EXPECT_EQ(reversed[0], "run.reversed 5");
  what.change = [](int run, double, double& one, double& two) {
    if (run == 2) std::swap(one, two);
  };
  EXPECT_EQ(codesOf(what), (Codes{"run.swapped 2", "run.swapped 2"}));
}

TEST(RunChecks, NoticeHalfRunsAndMissingTargets) {
  Case what;
  what.keep = [](int run, double x) { return run != 6 || x > 150.0; };
  EXPECT_EQ(codesOf(what), Codes{"run.half 6"});
  what.keep = [](int run, double x) { return run != 1 || (x != 40.0 && x != 200.0); };
  const std::vector<RunFault> faults = checkRuns(measurementOf(what), stage());
  ASSERT_EQ(codesOf(faults), Codes{"run.half 1"});
  EXPECT_NE(faults[0].text.find("2 of the 21"), std::string::npos) << faults[0].text;
}

TEST(RunChecks, NoticeCopiesAndStandstill) {
  Case what;
  what.change = [](int run, double x, double& one, double& two) {
    if (run != 1 && run != 3) return;
    one = curve(x) + 1e-4 * std::sin(x);
    two = std::cos(x / 60.0) * 5e-3;
  };
  EXPECT_EQ(codesOf(what), Codes{"run.duplicate 3"});
  what.change = [](int run, double x, double& one, double&) {
    if (run == 2 && x <= 200.0) one = 3.1e-3;
  };
  const std::vector<RunFault> faults = checkRuns(measurementOf(what), stage());
  ASSERT_EQ(codesOf(faults), Codes{"channel.frozen 2"});
  EXPECT_EQ(faults[0].first_row, 32u);
  EXPECT_EQ(faults[0].last_row, 42u);
}

TEST(RunChecks, NoticeADeadSensor) {
  Measurement measurement = measurementOf(Case{});
  std::vector<std::optional<double>> good;
  std::vector<std::optional<double>> dead;
  std::vector<std::optional<double>> time;
  for (std::size_t i = 0; i < measurement.samples.size(); ++i) {
    good.emplace_back(20.0 + 0.01 * static_cast<double>(i));
    dead.emplace_back(20.0 + 0.01 * static_cast<double>(std::min<std::size_t>(i, 69)));
    time.emplace_back(10.0 * static_cast<double>(i));
  }
  addColumn(measurement, "temp_screw_C", good);
  addColumn(measurement, "temp_bed_C", dead);
  addColumn(measurement, "t_s", time);
  const std::vector<RunFault> faults = checkRuns(measurement, stage());
  ASSERT_EQ(codesOf(faults), Codes{"sensor.frozen"});
  EXPECT_NE(faults[0].text.find("temp_bed_C"), std::string::npos);
  EXPECT_NE(faults[0].text.find("t = 690 s"), std::string::npos) << faults[0].text;
  EXPECT_EQ(faults[0].first_row, 70u);
}

TEST(RunChecks, TheModelDecidesWhereRunsCannot) {
  Case what;
  what.runs = 1;
  what.change = [](int, double x, double& one, double&) { one = -50e-6 * x + 1e-5 * std::sin(x); };
  const Measurement measurement = measurementOf(what);
  EXPECT_EQ(codesOf(checkRuns(measurement, stage())), Codes{});
  const ErrorModel model =
      modelOf("linear-stage",
              R"({"effect": "scale", "joint": "X", "parameters": {"k": {"value": 50, "unit": "um/m"}}})");
  const Result<Prediction> prediction = predict(model, measurement);
  ASSERT_TRUE(prediction);
  EXPECT_EQ(codesOf(checkRuns(measurement, stage(), &*prediction)), Codes{"run.sign 1"});
}

}  // namespace
}  // namespace nineline::measurement
