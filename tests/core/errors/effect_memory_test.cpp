#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "tests/core/errors/sample_effects.h"

namespace nineline::errors {
namespace {

const char* const kHead =
    R"({"effect": "thermal_head", "joint": "X", "parameters": {"k": 1, "tau": 900}, "sensor": "temp_head_C"})";

MachineState heated(double time, double temperature) {
  MachineState state;
  state.time = time;
  state.conditions = {{"temp_head_C", temperature}};
  return state;
}

double shift(const ErrorModel& model, const MachineState& state, std::span<const double> memory) {
  JointDisplacements displacements;
  model.displacements(state, memory, displacements);
  return displacements[2].moved.translation.x();
}

TEST(Lag, StartsInEquilibrium) {
  const ErrorModel model = modelOf("b2-k3032", kHead);
  const EffectMemory memory = model.startMemory(heated(0, 26));
  EXPECT_DOUBLE_EQ(shift(model, heated(0, 26), memory), 0.006);
}

/// Steps of very unequal length over a temperature that runs linearly between them, against a fourth-order
/// Runge-Kutta integration with small steps.
TEST(Lag, AgreesWithAnIndependentIntegration) {
  const ErrorModel model = modelOf("b2-k3032", kHead);
  const std::vector<std::pair<double, double>> rows = {{0, 20},    {1, 20.5},  {400, 29},
                                                       {401, 29},  {2500, 34}, {2500.5, 31},
                                                       {9000, 27}, {9000, 25}, {20000, 21.5}};
  EffectMemory memory = model.startMemory(heated(rows[0].first, rows[0].second));
  double y = rows[0].second - 20.0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto [t0, u0] = rows[i - 1];
    const auto [t1, u1] = rows[i];
    model.advance(heated(t0, u0), heated(t1, u1), memory);
    const int steps = 20000;
    const double h = (t1 - t0) / steps;
    const auto rate = [&, u_start = u0, u_end = u1](double part, double value) {
      return (u_start - 20.0 + (u_end - u_start) * part - value) / 900.0;
    };
    for (int n = 0; n < steps && h > 0.0; ++n) {
      const double part = static_cast<double>(n) / steps;
      const double half = part + 0.5 / steps;
      const double k1 = rate(part, y);
      const double k2 = rate(half, y + 0.5 * h * k1);
      const double k3 = rate(half, y + 0.5 * h * k2);
      const double k4 = rate(part + 1.0 / steps, y + h * k3);
      y += h * (k1 + 2.0 * k2 + 2.0 * k3 + k4) / 6.0;
    }
    EXPECT_NEAR(memory[0], y, 1e-9) << i;
    EXPECT_NEAR(shift(model, heated(t1, u1), memory), 1e-3 * y, 1e-12) << i;
  }
}

TEST(Lag, OneStepOrManyAreTheSame) {
  const ErrorModel model = modelOf("b2-k3032", kHead);
  EffectMemory once = model.startMemory(heated(0, 20));
  EffectMemory often = once;
  model.advance(heated(0, 20), heated(3600, 38), once);
  for (int n = 0; n < 360; ++n) {
    model.advance(heated(10.0 * n, 20 + 0.05 * n), heated(10.0 * (n + 1), 20 + 0.05 * (n + 1)), often);
  }
  EXPECT_NEAR(once[0], often[0], 1e-11);
}

TEST(Lag, WithoutTimeNothingLags) {
  const ErrorModel model = modelOf("b2-k3032", kHead);
  EffectMemory memory = model.startMemory(heated(0, 20));
  MachineState timeless = heated(0, 26);
  timeless.time.reset();
  model.advance(heated(0, 20), timeless, memory);
  EXPECT_DOUBLE_EQ(memory[0], 6.0);
}

const char* const kHysteresis =
    R"({"effect": "hysteresis", "joint": "X", "parameters": {"width": 6, "length": 5}})";

MachineState slide(double x, std::int8_t approach, double since) {
  MachineState state;
  state.q[2] = x;
  state.approach[2] = approach;
  state.since_reversal = JointPositions{0.0, 0.0, since};
  return state;
}

/// From a complete reversal on, the path gives the contract's formula, in steps of any length.
TEST(Hysteresis, AlongAPathIsTheFormula) {
  const ErrorModel model = modelOf("b2-k3032", kHysteresis);
  MachineState from = slide(100, 1, 1e6);
  EffectMemory memory = model.startMemory(from);
  EXPECT_DOUBLE_EQ(shift(model, from, memory), -0.003);
  for (const double d : {0.1, 0.5, 3.0, 3.5, 20.0, 60.0}) {
    const MachineState to = slide(100 - d, -1, d);
    model.advance(from, to, memory);
    EXPECT_NEAR(shift(model, to, memory), 0.003 * (1.0 - 2.0 * std::exp(-d / 5.0)), 1e-15) << d;
    EXPECT_NEAR(shift(model, to, {}), shift(model, to, memory), 1e-15) << d;
    from = to;
  }
}

TEST(Hysteresis, DoesNotJumpAfterAShortReversal) {
  const ErrorModel model = modelOf("b2-k3032", kHysteresis);
  MachineState from = slide(100, 1, 1e6);
  EffectMemory memory = model.startMemory(from);
  const MachineState back = slide(99, -1, 1.0);
  model.advance(from, back, memory);
  const double before = shift(model, back, memory);
  model.advance(back, slide(99.001, 1, 0.001), memory);
  EXPECT_NEAR(memory[0], before, 0.001 / 5.0 * 0.006);
}

TEST(Hysteresis, TheFirstMotionFindsItComplete) {
  const ErrorModel model = modelOf("b2-k3032", kHysteresis);
  EffectMemory memory = model.startMemory(slide(100, 0, 0));
  EXPECT_EQ(memory[0], 0.0);
  model.advance(slide(100, 0, 0), slide(101, 1, 1), memory);
  EXPECT_DOUBLE_EQ(memory[0], -0.003);
}

TEST(SampledMemory, PlayFollowsTheApproachAndLagsFollowTheTime) {
  const ErrorModel model = modelOf("b2-k3032", std::string(kHead) + R"(,
      {"effect": "backlash", "joint": "X", "parameters": {"width": 4}}, )" +
                                                   kHysteresis);
  ASSERT_EQ(model.memorySize(), 3U);
  MachineState from = heated(0, 20);
  from.approach[2] = 1;
  EffectMemory memory = model.startMemory(from);
  MachineState to = heated(900, 20);
  to.conditions = {{"temp_head_C", 30.0}};
  to.q[2] = -0.0001;  // far less than the play
  to.approach[2] = -1;
  to.since_reversal = JointPositions{0.0, 0.0, 5.0};
  const std::vector<EffectPtr>& effects = model.effects();
  for (std::size_t i = 0; i < 3; ++i) effects[i]->advanceSampled(from, to, std::span(memory).subspan(i, 1));
  EXPECT_NEAR(memory[0], 10.0 * std::exp(-1.0), 1e-12);
  EXPECT_DOUBLE_EQ(memory[1], 0.002);
  EXPECT_NEAR(memory[2], 0.003 * (1.0 - 2.0 * std::exp(-1.0)), 1e-15);
}

}  // namespace
}  // namespace nineline::errors
