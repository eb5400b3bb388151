#include "core/errors/nonparametric_effect.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "core/kinematics/machine_file.h"
#include "tests/core/errors/sample_effects.h"

namespace nineline::errors {
namespace {

const Machine& grinder() { return *kinematics::findBuiltInMachine("b2-k3032"); }

const Placement kOnZ{.joint = 0, .component = {AxisId{'Z', 0}, 2, false}};

std::shared_ptr<Effect> smooth(const SmoothForm& form, std::vector<double> coefficients) {
  auto effect = NonparametricEffect::make(grinder(), kOnZ, form, std::move(coefficients));
  if (!effect) throw std::runtime_error(effect.error().text);
  return *effect;
}

double shift(const Effect& effect, const MachineState& state) {
  SmallMotion motion;
  effect.addMotion(state, {}, motion);
  return motion.translation.z();
}

MachineState at(double z) {
  MachineState state = richState();
  state.q[0] = z;
  return state;
}

/// Coefficients at equal distances of a straight line make that line; of a parabola one that is higher by a
/// third of the second difference's half (B-splines smooth).
TEST(Smooth, ReproducesLinesAndParabolas) {
  const SmoothForm form{.covariates = {"Z_mm"}, .start = -100.0, .spacing = 50.0, .intervals = 4};
  std::vector<double> line;
  std::vector<double> parabola;
  for (int k = -1; k <= 5; ++k) {
    const double z = -100.0 + 50.0 * k;
    line.push_back(0.01 * z + 2.0);
    parabola.push_back(1e-3 * z * z);
  }
  const auto straight = smooth(form, line);
  const auto bent = smooth(form, parabola);
  for (const double z : {-100.0, -63.0, 0.0, 12.5, 99.0, 100.0}) {
    EXPECT_NEAR(shift(*straight, at(z)), 1e-3 * (0.01 * z + 2.0), 1e-15) << z;
    EXPECT_NEAR(shift(*bent, at(z)), 1e-3 * 1e-3 * (z * z + 50.0 * 50.0 / 3.0), 1e-14) << z;
  }
}

TEST(Smooth, IsHeldOutsideItsRangeAndSaysSo) {
  const SmoothForm form{.covariates = {"Z_mm"}, .start = -100.0, .spacing = 50.0, .intervals = 4};
  const auto effect = smooth(form, {1, 2, 3, 1, 5, 4, 7});
  EXPECT_TRUE(effect->covers(at(100.0)));
  EXPECT_FALSE(effect->covers(at(100.1)));
  EXPECT_EQ(shift(*effect, at(300.0)), shift(*effect, at(100.0)));
  EXPECT_EQ(shift(*effect, at(-300.0)), shift(*effect, at(-100.0)));
  SmallMotion slope;
  effect->addSlope(at(300.0), slope);
  EXPECT_TRUE(slope.isZero());
  EXPECT_FALSE(effect->isActive());  // compensated only when the user says so
  EXPECT_DOUBLE_EQ(effect->featureLength(), 25.0);
}

TEST(Smooth, TimesTheDirection) {
  const SmoothForm form{
      .covariates = {"Z_mm", "approach_Z_1"}, .start = -100.0, .spacing = 50.0, .intervals = 1};
  const auto effect = smooth(form, {2, 2, 2, 2});
  MachineState state = at(-80.0);
  EXPECT_NEAR(shift(*effect, state), 0.002, 1e-15);
  state.approach[0] = -1;
  EXPECT_NEAR(shift(*effect, state), -0.002, 1e-15);
  EXPECT_TRUE(effect->needs().empty());
}

TEST(Smooth, TimesASecondCovariateWithinItsRange) {
  const SmoothForm form{.covariates = {"Z_mm", "temp_bed_C"},
                        .start = -100.0,
                        .spacing = 50.0,
                        .intervals = 1,
                        .centre = 20.0,
                        .second = Bounds{18.0, 24.0}};
  const auto effect = smooth(form, {2, 2, 2, 2});
  EXPECT_EQ(effect->needs(), std::vector<std::string>{"temp_bed_C"});
  MachineState state = at(-80.0);
  EXPECT_NEAR(shift(*effect, state), 0.005, 1e-15);  // 22.5 °C
  state.conditions = {{"temp_bed_C", 30.0}};
  EXPECT_NEAR(shift(*effect, state), 0.008, 1e-15);
  EXPECT_FALSE(effect->covers(state));
  state.conditions.clear();
  EXPECT_EQ(shift(*effect, state), 0.0);
}

TEST(Smooth, ClosesATurn) {
  const Placement on_c{.joint = 1, .component = {AxisId{'C', 0}, 2, false}};
  const SmoothForm form{
      .covariates = {"C_deg"}, .start = 0.0, .spacing = 60.0, .intervals = 6, .periodic = true};
  const auto effect = NonparametricEffect::make(grinder(), on_c, form, {1, 4, -2, 3, 0, 5});
  ASSERT_TRUE(effect);
  MachineState state = richState();
  for (const double angle : {10.0, 130.0, 359.0}) {
    state.q[1] = radFromDeg(angle);
    const double once = shift(**effect, state);
    state.q[1] = radFromDeg(angle - 720.0);
    EXPECT_NEAR(shift(**effect, state), once, 1e-15);
  }
  EXPECT_TRUE((*effect)->covers(state));
}

TEST(Smooth, BasisAddsUp) {
  const SmoothForm form{.covariates = {"Z_mm"}, .start = -100.0, .spacing = 50.0, .intervals = 4};
  const auto basis = smoothBasis(grinder(), kOnZ, form);
  ASSERT_TRUE(basis);
  ASSERT_EQ(basis->size(), 7U);
  double sum = 0.0;
  for (const EffectPtr& one : *basis) sum += shift(*one, at(31.0));
  EXPECT_NEAR(sum, 0.001, 1e-15);  // a partition of 1 um
}

TEST(Smooth, RefusesBadForms) {
  const std::string head = R"({"effect": "nonparametric", "joint": "Z", "component": "EZZ", )";
  const auto code = [&](const std::string& body) {
    const Result<ErrorModel> model = readErrorModel(
        "{\"format\": \"nineline-model/1\", \"machine\": \"b2-k3032\",\n\"effects\": [" + head + body + "}]}",
        "bad");
    return model ? std::string("read")
                 : model.error().code + (model.error().line == 2 ? "" : " without place");
  };
  const std::string names = R"("covariates": ["Z_mm"], )";
  const std::string grid = R"("start": 0, "spacing": 10, )";
  EXPECT_EQ(code(names + grid + R"("values_um": [1, 2, 3, 4])"), "read");
  EXPECT_EQ(code(grid + R"("values_um": [1, 2, 3, 4])"), "json.missing");
  EXPECT_EQ(code(R"("covariates": [3], )" + grid + R"("values_um": [1, 2, 3, 4])"), "json.type");
  EXPECT_EQ(code(R"("covariates": [], )" + grid + R"("values_um": [1, 2, 3, 4])"), "model.form");
  EXPECT_EQ(code(names + grid + R"("values_um": [1, 2, 3])"), "model.form");
  EXPECT_EQ(code(names + R"("start": 0, "spacing": 0, "values_um": [1, 2, 3, 4])"), "model.form");
  EXPECT_EQ(code(names + grid + R"("values_um": [1, 2, 3, 4], "sigmas_um": [1])"), "model.form");
  EXPECT_EQ(code(names + grid + R"("values_um": [1, 2, 3, 4], "frame": "odd")"), "model.frame");
}

}  // namespace
}  // namespace nineline::errors
