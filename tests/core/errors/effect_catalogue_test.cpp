#include "core/errors/effect_catalogue.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>

#include "core/base/units.h"
#include "core/errors/parametric_effects.h"
#include "tests/core/errors/sample_effects.h"

namespace nineline::errors {
namespace {

/// The table of contract.md, "Effect names": id, then name and unit of each parameter.
struct ContractRow {
  std::string id;
  std::vector<std::pair<std::string, std::string>> parameters;
};

const std::vector<ContractRow>& contractTable() {
  static const std::vector<ContractRow> kRows = {
      {"table", {}},
      {"location", {}},
      {"scale", {{"k", "um/m"}}},
      {"cyclic", {{"amplitude", "um"}, {"period", "mm"}, {"phase", "deg"}}},
      {"straightness", {{"amplitude", "um"}, {"shape", "1"}}},
      {"angular", {{"amplitude", "arcsec"}, {"shape", "1"}}},
      {"periodic_tilt", {{"amplitude", "arcsec"}, {"period", "mm"}, {"phase", "deg"}}},
      {"eccentricity", {{"amplitude", "um"}, {"phase", "deg"}, {"n", "1"}}},
      {"lobing", {{"amplitude", "um"}, {"phase", "deg"}, {"n", "1"}}},
      {"wobble", {{"amplitude", "arcsec"}, {"phase", "deg"}}},
      {"axial_runout", {{"amplitude", "um"}, {"phase", "deg"}}},
      {"encoder_eccentricity", {{"amplitude", "arcsec"}, {"n", "1"}, {"phase", "deg"}}},
      {"encoder_subdivision", {{"amplitude", "arcsec"}, {"n", "1"}, {"period", "deg"}, {"phase", "deg"}}},
      {"backlash", {{"width", "um"}}},
      {"lateral_play", {{"width", "um"}}},
      {"angular_play", {{"width", "arcsec"}}},
      {"windup", {{"k", "um/m"}}},
      {"lost_motion", {{"kappa", "um/kg"}}},
      {"hysteresis", {{"width", "um"}, {"length", "mm"}}},
      {"reversal_spike", {{"height", "um"}, {"length", "mm"}}},
      {"friction_speed", {}},
      {"servo_lag", {{"tau", "ms"}}},
      {"acceleration", {{"k", "um/(m/s²)"}}},
      {"sync_delay", {{"tau", "ms"}}},
      {"vibration", {{"amplitude", "um"}, {"frequency", "Hz"}}},
      {"thermal_screw", {{"k", "um/m/C"}, {"q_fixed", "mm"}}},
      {"thermal_scale", {{"k", "um/m/C"}, {"q_fixed", "mm"}}},
      {"thermal_head", {{"k", "um/C"}, {"tau", "s"}}},
      {"thermal_ambient", {{"k", "um/C"}, {"tau", "s"}}},
      {"coolant", {{"k", "um/C"}, {"tau", "s"}}},
      {"thermal_tilt", {{"k", "arcsec/C"}}},
      {"thermal_workpiece", {{"k", "um/m/C"}}},
      {"drift", {{"rate", "um/h"}}},
      {"sag", {{"k", "um/m²"}, {"q_ref", "mm"}}},
      {"load_deformation", {{"k", "um/kg"}}},
      {"load_tilt", {{"k", "arcsec/kg"}}},
      {"counterweight", {{"width", "um"}, {"k", "um/(m/min)"}}},
      {"wheel_wear", {{"rate", "um/pass"}, {"passes", "1"}}},
      {"wheel_deflection", {{"k", "um/(m/min)"}}},
      {"spark_out", {{"k", "um/(m/min)"}, {"passes", "1"}}},
      {"workpiece_bending", {{"k", "um/kg"}}},
      {"clamping", {{"amplitude", "um"}, {"length", "mm"}}},
      {"cosine", {{"k", "um/m"}}},
      {"dead_path", {{"k", "mm"}}},
      {"material_temperature", {{"k", "um/m/C"}}},
      {"air_wavelength", {{"k", "1"}}},
      {"probe_lobing", {{"amplitude", "um"}}},
      {"stylus_radius", {{"shift", "um"}}},
      {"datum_shift", {{"shift", "um"}}},
      {"time_shift", {{"tau", "ms"}}},
      {"wrong_arm", {{"k", "mm"}}},
      {"nonparametric", {}}};
  return kRows;
}

/// What decides the units where the sample stands.
UnitChoice choiceOf(const std::string& id) {
  static const std::set<std::string> kAngular = {"angular",
                                                 "periodic_tilt",
                                                 "wobble",
                                                 "angular_play",
                                                 "encoder_eccentricity",
                                                 "encoder_subdivision",
                                                 "thermal_tilt",
                                                 "load_tilt"};
  const bool rotary = id.starts_with("encoder");
  return {.angular = kAngular.contains(id), .rotary = rotary};
}

TEST(EffectCatalogue, HoldsTheContractsTableAndNothingElse) {
  std::vector<std::string> expected;
  std::vector<std::string> found;
  for (const ContractRow& row : contractTable()) expected.push_back(row.id);
  for (const EffectSpec& spec : effectCatalogue()) found.emplace_back(spec.id);
  std::sort(expected.begin(), expected.end());
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, expected);
  EXPECT_EQ(findEffectSpec("magic"), nullptr);
}

TEST(EffectCatalogue, NamesAndUnitsOfParametersAreTheContracts) {
  for (const ContractRow& row : contractTable()) {
    const EffectSpec* spec = findEffectSpec(row.id);
    ASSERT_NE(spec, nullptr) << row.id;
    for (const auto& [name, unit] : row.parameters) {
      const ParameterSpec* parameter = spec->find(name);
      ASSERT_NE(parameter, nullptr) << row.id << " " << name;
      EXPECT_EQ(unitOf(parameter->quantity, choiceOf(row.id)), unit) << row.id << " " << name;
    }
  }
}

TEST(EffectCatalogue, SaysEverythingAboutEachEffect) {
  for (const EffectSpec& spec : effectCatalogue()) {
    SCOPED_TRACE(std::string(spec.id));
    EXPECT_FALSE(spec.title.empty());
    EXPECT_FALSE(spec.formula.empty());
    EXPECT_FALSE(spec.shop_floor.cause.empty() || spec.shop_floor.size.empty() ||
                 spec.shop_floor.remedy.empty());
    EXPECT_LE(spec.action_limit.low, spec.action_limit.high);
    for (const LookAlike& other : spec.lookalikes) {
      EXPECT_NE(findEffectSpec(other.id), nullptr) << other.id;
      EXPECT_NE(other.id, spec.id);
      EXPECT_FALSE(other.separated_by.empty());
    }
    for (const ParameterSpec& one : spec.parameters) {
      for (const Plausible& range : {one.linear, one.arc.value_or(one.linear)}) {
        EXPECT_LE(range.grinder.low, range.grinder.high) << one.name;
        EXPECT_LE(range.mill.low, range.mill.high) << one.name;
        EXPECT_GT(range.mill.high, 0.0) << one.name;
      }
      for (const double start : one.starts) {
        EXPECT_GE(start, one.linear.grinder.low) << one.name;
        EXPECT_LE(start, one.linear.grinder.high) << one.name;
      }
    }
  }
}

TEST(EffectCatalogue, EveryMotionOfTheTableHasASample) {
  std::set<std::string> samples = {"table"};
  for (const SampleEffect& sample : sampleEffects()) samples.insert(sample.id);
  for (const std::string& id : knownEffects()) EXPECT_TRUE(samples.contains(id)) << id;
  EXPECT_EQ(samples.size(), knownEffects().size());
}

TEST(EffectCatalogue, MeasurementErrorsAreNoPartOfAMachinesModel) {
  for (const EffectSpec& spec : effectCatalogue()) {
    if (spec.kind != EffectKind::Measurement) continue;
    const Result<ErrorModel> model =
        readErrorModel(R"({"format": "nineline-model/1", "machine": "b2-k3032", "effects": [{"effect": ")" +
                           std::string(spec.id) + R"(", "joint": "X", "parameters": {}}]})",
                       "test");
    ASSERT_FALSE(model) << spec.id;
    EXPECT_EQ(model.error().code, "model.effect");
  }
}

class EveryEffect : public testing::TestWithParam<SampleEffect> {};

TEST_P(EveryEffect, SurvivesItsFile) {
  const ErrorModel model = modelOf("b2-k3032", GetParam().json);
  ASSERT_EQ(model.effects().size(), 1U);
  EXPECT_EQ(model.effects()[0]->id(), GetParam().id);
  const std::string text = writeJson(errorModelToJson(model));
  const Result<ErrorModel> back = readErrorModel(text, "back");
  ASSERT_TRUE(back) << back.error().message();
  EXPECT_EQ(writeJson(errorModelToJson(*back)), text);
  SmallMotion before;
  SmallMotion after;
  model.effects()[0]->addMotion(richState(), {}, before);
  back->effects()[0]->addMotion(richState(), {}, after);
  EXPECT_EQ(before.translation, after.translation);
  EXPECT_EQ(before.rotation, after.rotation);
  EXPECT_FALSE(before.isZero()) << "the sample shows nothing";
  EXPECT_EQ(model.effects()[0]->isActive(), back->effects()[0]->isActive());
}

TEST_P(EveryEffect, NamesTheConditionsThatItMisses) {
  const ErrorModel model = modelOf("b2-k3032", GetParam().json);
  EXPECT_TRUE(model.missingConditions(richState()).empty());
  MachineState bare;
  bare.q = richState().q;
  bare.approach = richState().approach;
  bare.velocity = richState().velocity;
  bare.acceleration = richState().acceleration;
  bare.since_reversal = richState().since_reversal;
  SmallMotion full;
  SmallMotion poor;
  model.effects()[0]->addMotion(richState(), {}, full);
  model.effects()[0]->addMotion(bare, {}, poor);
  const bool same = full.translation == poor.translation && full.rotation == poor.rotation;
  EXPECT_EQ(model.missingConditions(bare).empty(), same);
}

/// Central differences of the motion with respect to the joint's own position.
TEST_P(EveryEffect, HasTheSlopeOfItsMotion) {
  const ErrorModel model = modelOf("b2-k3032", GetParam().json);
  const Effect& effect = *model.effects()[0];
  const auto k = static_cast<std::size_t>(effect.joint());
  const double step = effect.joint() == 1 ? 1e-5 : 1e-3;
  for (const double offset : {0.0, -0.31, 0.27}) {
    MachineState state = richState();
    state.q[k] *= 1.0 + offset;
    SmallMotion slope;
    effect.addSlope(state, slope);
    SmallMotion high;
    SmallMotion low;
    MachineState aside = state;
    aside.q[k] = state.q[k] + step;
    effect.addMotion(aside, {}, high);
    aside.q[k] = state.q[k] - step;
    effect.addMotion(aside, {}, low);
    const Eigen::Vector3d translation = (high.translation - low.translation) / (2.0 * step);
    const Eigen::Vector3d rotation = (high.rotation - low.rotation) / (2.0 * step);
    // 1e-6 of the slope, and what the difference of two doubles of this size can show.
    const double size = slope.translation.norm() + slope.rotation.norm();
    const double noise = 2e-16 * (high.translation.norm() + high.rotation.norm()) / step;
    EXPECT_LE((translation - slope.translation).norm(), 1e-6 * size + noise) << offset;
    EXPECT_LE((rotation - slope.rotation).norm(), 1e-6 * size + noise) << offset;
  }
}

Eigen::Isometry3d poseOf(const SmallMotion& motion) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = motion.translation;
  const double angle = motion.rotation.norm();
  if (angle > 0.0) pose.linear() = Eigen::AngleAxisd(angle, motion.rotation / angle).toRotationMatrix();
  return pose;
}

Eigen::Isometry3d locatedPose(const SmallMotion& motion) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = motion.translation;
  pose.linear() = (Eigen::AngleAxisd(motion.rotation.x(), Eigen::Vector3d::UnitX()) *
                   Eigen::AngleAxisd(motion.rotation.y(), Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(motion.rotation.z(), Eigen::Vector3d::UnitZ()))
                      .toRotationMatrix();
  return pose;
}

/// Contract.md, conventions 2 and 3, multiplied out: the tool's tip in W.
Eigen::Vector3d tipByHand(const ErrorModel& model, const MachineState& state) {
  const Machine& machine = model.machine();
  JointDisplacements displacements;
  model.displacements(state, {}, displacements);
  std::array<Eigen::Isometry3d, 2> chains{Eigen::Isometry3d::Identity(), Eigen::Isometry3d::Identity()};
  for (int i = 0; i < machine.jointCount(); ++i) {
    const kinematics::Joint& joint = machine.joint(i);
    const double q = state.q[static_cast<std::size_t>(i)];
    const auto& displacement = displacements[static_cast<std::size_t>(i)];
    Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
    if (machine.isRotary(i)) {
      motion.linear() = Eigen::AngleAxisd(q, joint.direction).toRotationMatrix();
    } else {
      motion.translation() = q * joint.direction;
    }
    Eigen::Isometry3d& chain = chains[machine.side(i) == kinematics::Side::Workpiece ? 0 : 1];
    chain = chain * Eigen::Translation3d(joint.offset) * locatedPose(displacement.located) *
            poseOf(displacement.standing) * motion * poseOf(displacement.moved);
  }
  return chains[0].inverse() * (chains[1] * machine.toolTip());
}

TEST_P(EveryEffect, ActsThroughTheExactChain) {
  const ErrorModel model = modelOf("b2-k3032", GetParam().json + R"(,
      {"effect": "angular", "joint": "Z", "component": "EAZ", "parameters": {"amplitude": 20.6, "shape": 1}},
      {"effect": "wobble", "joint": "C", "component": "EAC", "parameters": {"amplitude": 20.6}})");
  EXPECT_LE((model.actualPose(richState()).tip - tipByHand(model, richState())).norm(), kNanometre);
}

INSTANTIATE_TEST_SUITE_P(Samples, EveryEffect, testing::ValuesIn(sampleEffects()),
                         [](const auto& one) { return one.param.id; });

TEST(EffectCatalogue, ProcessEffectsWaitForTheUser) {
  const ErrorModel model = modelOf("b2-k3032", R"(
      {"effect": "scale", "joint": "X", "parameters": {"k": 20}},
      {"effect": "wheel_wear", "joint": "X", "parameters": {"rate": 1}},
      {"effect": "wheel_wear", "joint": "X", "parameters": {"rate": 1}, "active": true},
      {"effect": "scale", "joint": "Z", "parameters": {"k": 5}, "active": false})");
  const ErrorModel active = model.onlyActive();
  ASSERT_EQ(active.effects().size(), 2U);
  EXPECT_EQ(active.effects()[0], model.effects()[0]);
  EXPECT_EQ(active.effects()[1], model.effects()[2]);
  const Result<ErrorModel> back = readErrorModel(writeJson(errorModelToJson(model)), "back");
  ASSERT_TRUE(back) << back.error().message();
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(back->effects()[i]->isActive(), model.effects()[i]->isActive()) << i;
  }
}

}  // namespace
}  // namespace nineline::errors
