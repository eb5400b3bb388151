#include "core/errors/parametric_effects.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "core/errors/error_model_file.h"
#include "core/kinematics/machine_file.h"

namespace nineline::errors {
namespace {

/// A model of one effect, written as in a file.
ErrorModel modelOf(const std::string& machine, const std::string& effect) {
  const Result<ErrorModel> model = readErrorModel(
      R"({"format": "nineline-model/1", "machine": ")" + machine + R"(", "effects": [)" + effect + "]}",
      "test");
  if (!model) throw std::runtime_error(model.error().message());
  return *model;
}

MachineState at(const JointPositions& q) {
  MachineState state;
  state.q = q;
  return state;
}

kinematics::SmallMotion motion(const ErrorModel& model, const MachineState& state,
                               std::span<const double> memory = {}) {
  JointDisplacements d;
  model.displacements(state, memory, d);
  for (const kinematics::JointDisplacement& one : d) {
    if (!one.moved.isZero()) return one.moved;
  }
  return {};
}

TEST(Scale, ByHand) {
  const ErrorModel model =
      modelOf("b2-k3032", R"({"effect": "scale", "joint": "X", "parameters": {"k": 20}})");
  EXPECT_NEAR(motion(model, at({0, 0, 300.0})).translation.x(), 0.006, 1e-15);  // 20 um/m over 300 mm
  const ErrorModel turning =
      modelOf("b2-k3032", R"({"effect": "scale", "joint": "C", "parameters": {"k": 20}})");
  EXPECT_NEAR(motion(turning, at({0, 2.0, 0})).rotation.z(), 40e-6, 1e-15);
}

TEST(Scale, OfATableReadsAlongItsPositiveSense) {
  const ErrorModel model =
      modelOf("generic-3axis", R"({"effect": "scale", "joint": "X", "parameters": {"k": 20}})");
  EXPECT_NEAR(model.actualPose(at({0, 300.0, 0})).tip.x(), 300.006, 1e-12);
}

TEST(Cyclic, ByHand) {
  const ErrorModel model = modelOf(
      "b2-k3032",
      R"({"effect": "cyclic", "joint": "Z", "component": "EXZ", "parameters": {"amplitude": {"value": 3, "unit": "um"},
          "period": {"value": 10, "unit": "mm"}, "phase": {"value": 30, "unit": "deg"}}})");
  EXPECT_NEAR(motion(model, at({2.5, 0, 0})).translation.x(), 0.003 * std::cos(kPi / 6), 1e-15);
  EXPECT_NEAR(motion(model, at({0.0, 0, 0})).translation.x(), 0.0015, 1e-15);
  EXPECT_DOUBLE_EQ(model.featureLength(0), 1.25);
}

TEST(Cyclic, ThePeriodIsAPositionOfTheJointWhateverTheComponent) {
  const ErrorModel runout = modelOf(
      "b2-k3032",
      R"({"effect": "cyclic", "joint": "C", "component": "EXC", "parameters": {"amplitude": {"value": 3, "unit": "um"},
          "period": {"value": 360, "unit": "deg"}}})");
  EXPECT_NEAR(motion(runout, at({0, kPi / 2, 0})).translation.x(), 0.003, 1e-15);
  const ErrorModel tilt = modelOf(
      "b2-k3032",
      R"({"effect": "cyclic", "joint": "Z", "component": "EBZ", "parameters": {"amplitude": {"value": 2, "unit": "arcsec"},
          "period": {"value": 40, "unit": "mm"}}})");
  EXPECT_NEAR(motion(tilt, at({10.0, 0, 0})).rotation.y(), radFromArcsec(2.0), 1e-18);
}

TEST(ThermalScrew, ByHand) {
  const ErrorModel model = modelOf(
      "b2-k3032", R"({"effect": "thermal_screw", "joint": "Z", "parameters": {"k": 11.5, "q_fixed": -400}})");
  MachineState state = at({100.0, 0, 0});
  EXPECT_EQ(model.missingConditions(state), std::vector<std::string>{"temp_screw_Z_C"});
  EXPECT_TRUE(motion(model, state).isZero());
  state.conditions = {{"temp_screw_Z_C", 24.0}};
  EXPECT_TRUE(model.missingConditions(state).empty());
  EXPECT_NEAR(motion(model, state).translation.z(), 11.5e-6 * 4.0 * 500.0, 1e-15);
  const ErrorModel named = modelOf(
      "b2-k3032",
      R"({"effect": "thermal_screw", "joint": "Z", "parameters": {"k": 11.5}, "sensor": "nut"}, {"effect": "thermal_screw",
          "joint": "X", "parameters": {"k": 11.5}, "sensor": "temp_nut_C"})");
  EXPECT_EQ(named.missingConditions(state), std::vector<std::string>{"temp_nut_C"});
}

const char* const kPlay = R"({"effect": "backlash", "joint": "X", "parameters": {"width": 4}})";

TEST(Backlash, AtAnInstantFollowsTheApproach) {
  const ErrorModel model = modelOf("b2-k3032", kPlay);
  MachineState state = at({0, 0, 50.0});
  EXPECT_TRUE(motion(model, state).isZero());  // approach unknown
  state.approach[2] = 1;
  EXPECT_DOUBLE_EQ(motion(model, state).translation.x(), -0.002);
  state.approach[2] = -1;
  EXPECT_DOUBLE_EQ(motion(model, state).translation.x(), 0.002);
  EXPECT_DOUBLE_EQ(model.play(2), 0.004);
  EXPECT_EQ(model.play(0), 0.0);
}

/// Actual X after each commanded X along a path that starts at the first one with the given approach.
std::vector<double> along(const ErrorModel& model, std::int8_t approach,
                          const std::vector<double>& commands) {
  MachineState from = at({0, 0, commands[0]});
  from.approach[2] = approach;
  EffectMemory memory = model.startMemory(from);
  std::vector<double> actual;
  for (const double x : commands) {
    MachineState to = from;
    to.q[2] = x;
    if (x != from.q[2]) to.approach[2] = x > from.q[2] ? std::int8_t{1} : std::int8_t{-1};
    model.advance(from, to, memory);
    actual.push_back(model.actualPose(to, memory).tip.x());
    from = to;
  }
  return actual;
}

void expectNear(const std::vector<double>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-12) << i;
}

TEST(Backlash, IsADeadBandAlongAPath) {
  // Width 0.004, started upwards: the joint trails by 0.002. Reversals inside the band leave it standing.
  const ErrorModel model = modelOf("b2-k3032", kPlay);
  expectNear(along(model, 1, {10.0, 11.0, 10.999, 10.997, 10.996, 10.995, 10.997, 10.999, 11.0}),
             {9.998, 10.998, 10.998, 10.998, 10.998, 10.997, 10.997, 10.997, 10.998});
}

TEST(Backlash, TheFirstMotionFindsThePlayTakenUpWhereTheApproachIsUnknown) {
  const ErrorModel model = modelOf("b2-k3032", kPlay);
  expectNear(along(model, 0, {10.0, 10.001, 10.002, 10.003}), {10.0, 9.999, 10.0, 10.001});
}

TEST(Backlash, ANegativeWidthIsTheMirrorImage) {
  const ErrorModel model =
      modelOf("b2-k3032", R"({"effect": "backlash", "joint": "X", "parameters": {"width": -4}})");
  expectNear(along(model, 1, {10.0, 11.0, 10.999, 10.996, 10.0}), {10.002, 11.002, 11.0, 10.994, 9.998});
  EXPECT_DOUBLE_EQ(model.play(2), 0.004);
}

TEST(Backlash, SeveralEffectsKeepTheirOwnMemory) {
  const ErrorModel model =
      modelOf("b2-k3032",
              std::string(kPlay) + R"(, {"effect": "backlash", "joint": "C", "parameters": {"width": 10}})");
  ASSERT_EQ(model.memorySize(), 2U);
  MachineState from = at({});
  from.approach = {0, -1, 1};
  EffectMemory memory = model.startMemory(from);
  EXPECT_DOUBLE_EQ(memory[0], -0.002);
  EXPECT_DOUBLE_EQ(memory[1], radFromArcsec(5.0));
  MachineState to = from;
  to.q[1] = 1.0;
  model.advance(from, to, memory);
  EXPECT_DOUBLE_EQ(memory[0], -0.002);
  EXPECT_DOUBLE_EQ(memory[1], -radFromArcsec(5.0));
}

}  // namespace
}  // namespace nineline::errors
