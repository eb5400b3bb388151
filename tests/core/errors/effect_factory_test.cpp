#include "core/errors/effect_factory.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <set>

#include "core/base/units.h"
#include "core/errors/parametric_effects.h"
#include "core/kinematics/machine_file.h"
#include "tests/core/errors/sample_effects.h"

namespace nineline::errors {
namespace {

const Machine& grinder() { return *kinematics::findBuiltInMachine("b2-k3032"); }

Eigen::Matrix<double, 6, 1> motionOf(const Effect& effect) {
  SmallMotion motion;
  effect.addMotion(richState(), {}, motion);
  Eigen::Matrix<double, 6, 1> all;
  all << motion.translation, motion.rotation;
  return all;
}

bool isSearched(const ParameterSpec& rule) {
  return rule.role == Role::NonLinear || rule.role == Role::Choice || rule.role == Role::Given;
}

/// Every effect of the table is the sum of its parts, with the coefficients that its parameters mean.
TEST(LinearBasis, AddsUpToTheEffect) {
  for (const SampleEffect& sample : sampleEffects()) {
    SCOPED_TRACE(sample.id);
    const ErrorModel model = modelOf("b2-k3032", sample.json);
    const auto* effect = dynamic_cast<const ParametricEffect*>(model.effects()[0].get());
    if (effect == nullptr) continue;
    std::vector<Parameter> nonlinear;
    std::vector<double> coefficients;
    for (const Parameter& one : effect->parameters()) {
      const ParameterSpec& rule = *effect->spec().find(one.name);
      if (isSearched(rule)) nonlinear.push_back(one);
      if (rule.role == Role::Linear) coefficients.push_back(one.value);
      if (rule.role != Role::Amplitude) continue;
      double phase = 0.0;
      for (const Parameter& other : effect->parameters()) {
        if (other.name == "phase") phase = radFromDeg(other.value);
      }
      coefficients.push_back(one.value * std::cos(phase));
      coefficients.push_back(one.value * std::sin(phase));
    }
    const auto basis = linearBasis(grinder(), effect->spec(), effect->placement(), nonlinear);
    ASSERT_TRUE(basis) << basis.error().text;
    ASSERT_EQ(basis->size(), coefficients.size());
    Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
    for (std::size_t i = 0; i < coefficients.size(); ++i) sum += coefficients[i] * motionOf(*(*basis)[i]);
    EXPECT_LE((sum - motionOf(*effect)).norm(), 1e-15);

    const Eigen::VectorXd fitted =
        Eigen::Map<Eigen::VectorXd>(coefficients.data(), Eigen::Index(coefficients.size()));
    const FittedParameters back =
        parametersOf(grinder(), effect->spec(), effect->placement(), nonlinear, fitted);
    ASSERT_EQ(back.parameters.size(), effect->parameters().size());
    for (std::size_t i = 0; i < back.parameters.size(); ++i) {
      EXPECT_EQ(back.parameters[i].name, effect->parameters()[i].name);
      EXPECT_EQ(back.parameters[i].unit, effect->parameters()[i].unit);
      EXPECT_NEAR(back.parameters[i].value, effect->parameters()[i].value, 1e-12) << back.parameters[i].name;
    }
    const auto again = makeEffect(grinder(), effect->spec(), effect->placement(), back.parameters);
    ASSERT_TRUE(again) << again.error().text;
    EXPECT_LE((motionOf(**again) - motionOf(*effect)).norm(), 1e-15);
  }
}

TEST(FittedParameters, UncertaintyOfAmplitudeAndPhase) {
  const EffectSpec& spec = *findEffectSpec("cyclic");
  const UnitChoice units;
  const std::vector<Parameter> period = {{"period", "mm", 10.0, 0.01}};
  const Eigen::Vector2d c(3.0, 4.0);
  Eigen::Matrix2d plain;
  plain << 0.09, 0.02, 0.02, 0.04;
  const Eigen::MatrixXd covariance = plain;
  const FittedParameters fitted = parametersOf(spec, units, period, c, &covariance);
  EXPECT_DOUBLE_EQ(fitted.parameters[0].value, 5.0);
  // σ² = (9·0.09 + 2·12·0.02 + 16·0.04)/25
  EXPECT_NEAR(*fitted.parameters[0].sigma, std::sqrt((0.81 + 0.48 + 0.64) / 25.0), 1e-12);
  EXPECT_EQ(fitted.parameters[1].sigma, 0.01);
  EXPECT_NEAR(fitted.parameters[2].value, degFromRad(std::atan2(4.0, 3.0)), 1e-12);
  const double step = 1e-6;
  for (Eigen::Index k = 0; k < 2; ++k) {
    Eigen::Vector2d aside = c;
    aside[k] += step;
    const FittedParameters high = parametersOf(spec, units, period, aside);
    aside[k] -= 2.0 * step;
    const FittedParameters low = parametersOf(spec, units, period, aside);
    for (std::size_t i = 0; i < 3; ++i) {
      const double slope = (high.parameters[i].value - low.parameters[i].value) / (2.0 * step);
      EXPECT_NEAR(fitted.jacobian(Eigen::Index(i), k), slope, 1e-6);
    }
  }
  const FittedParameters none = parametersOf(spec, units, period, Eigen::Vector2d::Zero(), &covariance);
  EXPECT_EQ(none.parameters[0].value, 0.0);
  EXPECT_EQ(none.parameters[2].value, 0.0);
  EXPECT_EQ(none.parameters[2].sigma, 180.0);
}

struct BadEffect {
  std::string id;
  Placement placement;
  std::vector<Parameter> values;
  std::string text;  // part of the message
};

TEST(MakeEffect, RefusesWhatHasNoMeaning) {
  const AxisId x{'X', 0};
  const AxisId c{'C', 0};
  const Placement on_x{.joint = 2, .component = {x, 0, false}};
  const Placement on_c{.joint = 1, .component = {c, 0, false}};
  const std::vector<BadEffect> cases = {
      {"scale", on_x, {}, "'k' of 'scale' is missing"},
      {"scale", on_x, {{"q", "", 1.0, {}}}, "no parameter 'q'"},
      {"scale", on_x, {{"k", "um", 1.0, {}}}, "expected um/m"},
      {"scale", on_x, {{"k", "", NAN, {}}}, "expected a number"},
      {"scale", on_x, {{"k", "", 1.0, -1.0}}, "'sigma'"},
      {"scale", {.joint = 2, .component = {c, 5, false}}, {{"k", "", 1.0, {}}}, "belongs to axis C"},
      {"scale", {.joint = 2, .component = {x, 4, true}}, {{"k", "", 1.0, {}}}, "does not fit"},
      {"wobble", on_x, {{"amplitude", "", 1.0, {}}}, "needs a rotary axis"},
      {"wobble", on_c, {{"amplitude", "", 1.0, {}}}, "is a rotation"},
      {"eccentricity",
       {.joint = 1, .component = {c, 2, false}},
       {{"amplitude", "", 1.0, {}}},
       "across the axis"},
      {"lobing", on_c, {{"amplitude", "", 1.0, {}}, {"n", "", 2.5, {}}}, "whole number"},
      {"lobing", on_c, {{"amplitude", "", 1.0, {}}, {"n", "", 1.0, {}}}, "whole number"},
      {"straightness", on_x, {{"amplitude", "", 1.0, {}}, {"shape", "", 7.0, {}}}, "expected one of 2, 3"},
      {"thermal_head", on_x, {{"k", "", 1.0, {}}}, "needs the column"},
      {"encoder_subdivision", on_x, {{"amplitude", "", 1.0, {}}}, "either 'n' or 'period'"},
      {"encoder_subdivision", on_x, {{"amplitude", "", 1.0, {}}, {"n", "", 9.0, {}}}, "is linear"},
      {"hysteresis", on_x, {{"width", "", 1.0, {}}, {"length", "", 0.0, {}}}, "above 0"},
      {"cosine", on_x, {{"k", "", 1.0, {}}}, "error of a measurement"},
      {"table", on_x, {}, "not made of parameters"},
      {"scale",
       {.joint = 2, .component = {x, 0, false}, .fixed_frame = true},
       {{"k", "", 1.0, {}}},
       "'frame'"},
      {"straightness",
       {.joint = 2, .component = {x, 1, false}, .range = kinematics::Travel{5.0, 5.0}},
       {{"amplitude", "", 1.0, {}}},
       "range"}};
  for (const BadEffect& bad : cases) {
    const Result<EffectPtr> effect =
        makeEffect(grinder(), *findEffectSpec(bad.id), bad.placement, bad.values);
    ASSERT_FALSE(effect) << bad.id << " " << bad.text;
    EXPECT_NE(effect.error().text.find(bad.text), std::string::npos) << effect.error().text;
  }
}

std::set<std::string> named(const std::vector<Candidate>& candidates) {
  std::set<std::string> found;
  for (const Candidate& one : candidates) {
    std::string text = std::string(one.spec->id) + " " + one.placement.component.text();
    if (!one.placement.sensor.empty()) text += " " + one.placement.sensor;
    if (!one.placement.sensor_2.empty()) text += " " + one.placement.sensor_2;
    found.insert(text);
  }
  return found;
}

TEST(Candidates, NeedTheirColumns) {
  const std::set<std::string> bare = named(candidatesFor(grinder(), {{"X_mm", "Z_mm"}, true}));
  EXPECT_TRUE(bare.contains("scale EXX"));
  EXPECT_TRUE(bare.contains("scale EZZ"));
  EXPECT_FALSE(bare.contains("scale ECC"));
  EXPECT_TRUE(bare.contains("straightness EXZ"));
  EXPECT_FALSE(bare.contains("straightness EZZ"));
  EXPECT_TRUE(bare.contains("eccentricity EXC"));
  EXPECT_FALSE(bare.contains("eccentricity EYC"));
  EXPECT_TRUE(bare.contains("location B0C"));
  EXPECT_FALSE(bare.contains("servo_lag EXX"));
  EXPECT_FALSE(bare.contains("drift EXX"));
  EXPECT_FALSE(bare.contains("wheel_wear EXX"));
  const std::set<std::string> rich = named(candidatesFor(
      grinder(),
      {{"t_s", "pass_1", "temp_screw_Z_C", "temp_head_C", "temp_bed_C", "load_kg", "coolant_1"}, true}));
  EXPECT_TRUE(rich.contains("servo_lag EXX"));
  EXPECT_TRUE(rich.contains("drift EXX"));
  EXPECT_TRUE(rich.contains("drift Y0C"));  // the bed's y has no linear joint
  EXPECT_TRUE(rich.contains("wheel_wear EXX"));
  EXPECT_TRUE(rich.contains("thermal_screw EZZ temp_screw_Z_C"));
  EXPECT_FALSE(rich.contains("thermal_screw EXX temp_screw_Z_C"));
  EXPECT_FALSE(rich.contains("thermal_screw EZZ temp_head_C"));
  EXPECT_TRUE(rich.contains("thermal_head EXX temp_head_C"));
  EXPECT_FALSE(rich.contains("thermal_ambient EXX temp_head_C"));
  EXPECT_TRUE(rich.contains("coolant EXX coolant_1"));
  EXPECT_TRUE(rich.contains("thermal_tilt EBX temp_head_C temp_bed_C"));
}

TEST(Candidates, CanAllBeBuiltFromTheirStarts) {
  const AvailableData data{{"t_s", "pass_1", "load_kg", "feed_mm_min", "temp_screw_Z_C", "temp_head_C",
                            "temp_bed_C", "temp_ambient_C", "temp_t7_C", "coolant_1"},
                           false};
  for (const char* id : {"b2-k3032", "generic-3axis", "trunnion-ac", "rotary-table", "linear-stage"}) {
    const Machine& machine = *kinematics::findBuiltInMachine(id);
    const std::vector<Candidate> candidates = candidatesFor(machine, data);
    EXPECT_FALSE(candidates.empty());
    for (const Candidate& one : candidates) {
      std::vector<Parameter> nonlinear;
      for (const SearchRange& range : one.nonlinear) {
        const double start = range.starts.empty() ? range.plausible.high : range.starts.front();
        nonlinear.push_back({range.name, range.unit, start, std::nullopt});
      }
      const auto basis = linearBasis(machine, *one.spec, one.placement, nonlinear);
      ASSERT_TRUE(basis) << id << " " << one.spec->id << ": " << basis.error().text;
      EXPECT_EQ(basis->size(), one.columns) << one.spec->id;
    }
  }
}

TEST(Candidates, StateTravelsInTheJointsUnits) {
  for (const Candidate& one : candidatesFor(grinder(), {{"temp_screw_Z_C"}, true})) {
    if (one.spec->id != "thermal_screw") continue;
    EXPECT_EQ(one.nonlinear[0].name, "q_fixed");
    EXPECT_EQ(one.nonlinear[0].starts, (std::vector<double>{-400.0, 0.0, 400.0}));
    EXPECT_DOUBLE_EQ(one.nonlinear[0].plausible.high, 640.0);
  }
}

}  // namespace
}  // namespace nineline::errors
