#include "core/measurement/states.h"

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/kinematics/machine_file.h"
#include "tests/core/measurement/set_ups.h"

namespace nineline::measurement {
namespace {

const Machine& grinder() { return *kinematics::findBuiltInMachine("b2-k3032"); }

Measurement along(const std::vector<double>& z) {
  std::vector<JointPositions> positions;
  for (const double one : z) positions.push_back({one, 0.0, 0.0});
  return measurementAt(Instrument{}, {{Quantity::DevZ}}, positions);
}

std::vector<int> approachOfZ(const Measurement& measurement) {
  std::vector<int> senses;
  for (const MachineState& state : statesOf(measurement, grinder())) senses.push_back(state.approach[0]);
  return senses;
}

TEST(States, ApproachFollowsFromTheOrderOfPositions) {
  EXPECT_EQ(approachOfZ(along({0, 10, 20, 20, 10, 0})), (std::vector<int>{1, 1, 1, 1, -1, -1}));
  EXPECT_EQ(approachOfZ(along({5, 5, 5})), (std::vector<int>{0, 0, 0}));
  Measurement runs = along({0, 10, 20, 20, 10, 0});
  addColumn(runs, "run", {1, 1, 1, 2, 2, 2});
  EXPECT_EQ(approachOfZ(runs), (std::vector<int>{1, 1, 1, -1, -1, -1})) << "the first motion of the run";
}

TEST(States, ApproachColumnWinsWhereItHasAValue) {
  Measurement measurement = along({0, 10, 20, 10});
  addColumn(measurement, "approach_Z_1", {-1, std::nullopt, -1, 1});
  EXPECT_EQ(approachOfZ(measurement), (std::vector<int>{-1, 1, -1, 1}));
}

TEST(States, SpeedAndAccelerationComeFromPositionsAndTime) {
  // z = 3 t² + 2 t + 1: exact for a parabola, at the ends too.
  Measurement measurement = along({1, 6, 17, 86});
  addColumn(measurement, "t_s", {0, 1, 2, 5});
  const auto states = statesOf(measurement, grinder());
  const std::vector<double> t = {0, 1, 2, 5};
  for (std::size_t i = 0; i < 4; ++i) {
    ASSERT_TRUE(states[i].velocity && states[i].acceleration);
    EXPECT_NEAR((*states[i].velocity)[0], 6.0 * t[i] + 2.0, 1e-12);
    EXPECT_NEAR((*states[i].acceleration)[0], 6.0, 1e-12);
    EXPECT_EQ((*states[i].velocity)[2], 0.0) << "X stands still";
  }
}

TEST(States, SpeedColumnsWinAndZeroMeansStopped) {
  Measurement measurement = along({0, 10, 40});
  addColumn(measurement, "t_s", {0, 1, 2});
  addColumn(measurement, "v_Z_mm_min", {0, 600, std::nullopt});
  const auto states = statesOf(measurement, grinder());
  EXPECT_EQ((*states[0].velocity)[0], 0.0);
  EXPECT_EQ((*states[0].acceleration)[0], 0.0);
  EXPECT_DOUBLE_EQ((*states[1].velocity)[0], 10.0);
  EXPECT_DOUBLE_EQ((*states[1].acceleration)[0], 20.0);
  EXPECT_DOUBLE_EQ((*states[2].velocity)[0], 40.0);
}

TEST(States, UnknownIsAbsent) {
  const auto states = statesOf(along({0, 10, 20}), grinder());
  EXPECT_FALSE(states[1].velocity || states[1].acceleration || states[1].time || states[1].feed);
  Measurement standing_clock = along({0, 10, 20});
  addColumn(standing_clock, "t_s", {1, 1, 1});
  EXPECT_FALSE(statesOf(standing_clock, grinder())[1].velocity);
}

TEST(States, RotarySpeedIsInDegreesAMinute) {
  Measurement measurement = along({0, 10});
  addColumn(measurement, "v_C_deg_min", {360, 0});
  addColumn(measurement, "v_Z_mm_min", {60, 0});
  const auto states = statesOf(measurement, grinder());
  EXPECT_DOUBLE_EQ((*states[0].velocity)[1], kTurn / 60.0);
  EXPECT_DOUBLE_EQ((*states[0].velocity)[0], 1.0);
}

TEST(States, TravelSinceReversalFollowsThePath) {
  const auto states = statesOf(along({0, 10, 30, 25, 5, 6}), grinder());
  const std::vector<double> wanted = {kNoReversal, kNoReversal + 10, kNoReversal + 30, 5, 25, 1};
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_DOUBLE_EQ((*states[i].since_reversal)[0], wanted[i]) << i;
  }
  Measurement turned = along({0, 20, 20, 0});
  addColumn(turned, "approach_Z_1", {1, 1, -1, -1});
  const auto at_turn = statesOf(turned, grinder());
  EXPECT_EQ((*at_turn[2].since_reversal)[0], 0.0);
  EXPECT_EQ((*at_turn[3].since_reversal)[0], 20.0);
}

TEST(States, ConditionsKeepTheirColumnsNames) {
  Measurement measurement = along({0, 10});
  addColumn(measurement, "temp_screw_Z_C", {21.5, std::nullopt});
  addColumn(measurement, "pass_1", {3, 4});
  addColumn(measurement, "feed_mm_min", {600, 600});
  const auto states = statesOf(measurement, grinder());
  EXPECT_EQ(states[0].condition("temp_screw_Z_C"), 21.5);
  EXPECT_FALSE(states[1].condition("temp_screw_Z_C"));
  EXPECT_EQ(states[1].pass, 4.0);
  EXPECT_EQ(states[1].condition("pass_1"), 4.0);
  EXPECT_DOUBLE_EQ(*states[0].feed, 10.0);
}

TEST(States, RowsNameTheirUncertainty) {
  Measurement measurement = along({0, 10});
  measurement.repeatability = 0.4e-3;
  measurement.samples[1].sigma = 2e-3;
  const auto rows = rowsOf(measurement);
  EXPECT_EQ(rows[0].sigma, 0.4e-3);
  EXPECT_EQ(rows[1].sigma, 2e-3);
}

}  // namespace
}  // namespace nineline::measurement
