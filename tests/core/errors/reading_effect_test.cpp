#include "core/errors/reading_effect.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/base/units.h"
#include "core/errors/effect_factory.h"
#include "core/kinematics/machine_file.h"

namespace nineline::errors {
namespace {

const kinematics::Machine& grinder() { return *kinematics::findBuiltInMachine("b2-k3032"); }

ReadingEffect make(const std::string& id, const std::vector<Parameter>& values, ReadingPlacement placement) {
  Result<ReadingEffect> effect = ReadingEffect::make(*findEffectSpec(id), std::move(placement), values);
  if (!effect) throw std::runtime_error(effect.error().text);
  return std::move(*effect);
}

Parameter parameter(const std::string& name, double value) { return {name, "", value, std::nullopt}; }

/// A run on X that started at 100 mm in standard air and stands at 300 mm.
struct LaserRun {
  MachineState start;
  MachineState state;
  ReadingContext context{state, start};
  LaserRun() {
    start.q[2] = 100.0;
    state.q[2] = 300.0;
    state.approach[2] = -1;
    state.time = 500.0;
    start.conditions = {{"temp_air_C", 20.0}, {"press_air_1", 1013.25}, {"temp_mat_C", 20.0}};
    state.conditions = {{"temp_air_C", 22.0}, {"press_air_1", 1003.25}, {"temp_mat_C", 24.0}};
  }
};

const ReadingPlacement kLaser{.instrument = "laser-linear", .joint = 2, .file = "x.csv"};

ReadingPlacement laserWith(const std::string& sensor, const std::string& second = "") {
  ReadingPlacement placement = kLaser;
  placement.sensor = sensor;
  placement.sensor_2 = second;
  return placement;
}

TEST(ReadingEffect, ALaserAskewReadsShort) {
  LaserRun run;
  // 5 mrad: θ²/2 = 12.5 um/m, over 200 mm 2.5 um.
  EXPECT_NEAR(make("cosine", {parameter("k", 12.5)}, kLaser).addition(run.context), -0.0025, 1e-15);
  EXPECT_FALSE(ReadingEffect::make(*findEffectSpec("cosine"), kLaser, std::vector{parameter("k", -1.0)}));
}

TEST(ReadingEffect, AirAndMaterialByHand) {
  LaserRun run;
  // 2 °C and −10 hPa: 1.86 + 2.7 = 4.56 ppm.
  EXPECT_NEAR(make("dead_path", {parameter("k", 500.0)}, laserWith("temp_air_C", "press_air_1"))
                  .addition(run.context),
              500.0 * 4.56e-6, 1e-15);
  EXPECT_NEAR(make("air_wavelength", {parameter("k", 1.0)}, laserWith("temp_air_C", "press_air_1"))
                  .addition(run.context),
              200.0 * 4.56e-6, 1e-15);
  EXPECT_NEAR(
      make("material_temperature", {parameter("k", 10.0)}, laserWith("temp_mat_C")).addition(run.context),
      10e-6 * 4.0 * 200.0, 1e-15);
  run.state.conditions.clear();
  EXPECT_EQ(make("dead_path", {parameter("k", 500.0)}, laserWith("temp_air_C")).addition(run.context), 0.0);
}

TEST(ReadingEffect, ProbeClockAndDatumByHand) {
  LaserRun run;
  run.context.direction = kTurn / 3.0;
  EXPECT_NEAR(make("probe_lobing", {parameter("amplitude", 2.0), parameter("phase", 60.0)}, kLaser)
                  .addition(run.context),
              0.001, 1e-15);
  EXPECT_NEAR(make("stylus_radius", {parameter("shift", 4.0)}, kLaser).addition(run.context), -0.002, 1e-15);
  const ReadingEffect datum =
      make("datum_shift", {parameter("shift", 5.0), parameter("time", 400.0)}, kLaser);
  EXPECT_NEAR(datum.addition(run.context), 0.005, 1e-15);
  run.state.time = 399.0;
  EXPECT_EQ(datum.addition(run.context), 0.0);
  run.context.rate = 0.02;
  EXPECT_NEAR(make("time_shift", {parameter("tau", 50.0)}, kLaser).addition(run.context), 0.001, 1e-15);
}

TEST(ReadingEffect, AWrongArmShowsTheKnownTilt) {
  LaserRun run;
  run.context.rotation = {0.0, 0.0, 1e-5};
  run.context.sensitive = Eigen::Vector3d::UnitX();
  ReadingPlacement placement = kLaser;
  placement.row = 1;  // the beam runs 50 mm further along y than declared: yaw moves it by −50 ε
  EXPECT_NEAR(make("wrong_arm", {parameter("k", 50.0)}, placement).addition(run.context), -5e-4, 1e-15);
}

TEST(ReadingEffect, SurvivesItsEntry) {
  for (const EffectSpec& spec : effectCatalogue()) {
    if (spec.kind != EffectKind::Measurement) continue;
    std::vector<Parameter> values;
    for (const ParameterSpec& one : spec.parameters) values.push_back({std::string(one.name), "", 2.5, 0.5});
    ReadingPlacement placement = laserWith(spec.sensors > 0 ? "temp_air_C" : "");
    placement.row = spec.id == "wrong_arm" ? 2 : 0;
    const ReadingEffect effect = make(std::string(spec.id), values, placement);
    const Json json = effect.toJson(grinder());
    const Result<ReadingEffect> back = ReadingEffect::fromJson(json, "test", grinder());
    ASSERT_TRUE(back) << spec.id << ": " << back.error().message();
    EXPECT_EQ(writeJson(back->toJson(grinder())), writeJson(json));
    LaserRun run;
    EXPECT_EQ(back->addition(run.context), effect.addition(run.context));
  }
}

TEST(ReadingEffect, RefusesMotionsOfTheMachine) {
  const Result<Json> json =
      parseJson(R"({"effect": "backlash", "joint": "X", "parameters": {"width": 4}})", "bad");
  ASSERT_TRUE(json);
  const Result<ReadingEffect> effect = ReadingEffect::fromJson(*json, "bad", grinder());
  ASSERT_FALSE(effect);
  EXPECT_EQ(effect.error().line, 1U);
  EXPECT_NE(effect.error().text.find("'backlash'"), std::string::npos);
}

TEST(ReadingEffect, BasisIsLinear) {
  LaserRun run;
  run.context.direction = 0.4;
  const auto basis = readingBasis(*findEffectSpec("probe_lobing"), kLaser, {});
  ASSERT_TRUE(basis);
  ASSERT_EQ(basis->size(), 2U);
  const FittedParameters fitted =
      parametersOf(*findEffectSpec("probe_lobing"), unitChoice(kLaser), {}, Eigen::Vector2d(3.0, -4.0));
  const ReadingEffect whole = make("probe_lobing", fitted.parameters, kLaser);
  EXPECT_NEAR(whole.addition(run.context),
              3.0 * (*basis)[0].addition(run.context) - 4.0 * (*basis)[1].addition(run.context), 1e-15);
}

TEST(ReadingCandidates, FitTheInstrument) {
  const auto ids = [](const ReadingPlacement& placement, std::vector<std::string> columns) {
    std::set<std::string> found;
    for (const ReadingCandidate& one : readingCandidates(grinder(), placement, {std::move(columns), true})) {
      found.insert(std::string(one.spec->id));
    }
    return found;
  };
  EXPECT_EQ(ids(kLaser, {}), (std::set<std::string>{"cosine", "wrong_arm"}));
  EXPECT_EQ(ids(kLaser, {"t_s", "temp_air_C", "temp_mat_C", "press_air_1"}),
            (std::set<std::string>{"cosine", "wrong_arm", "dead_path", "air_wavelength",
                                   "material_temperature", "datum_shift"}));
  EXPECT_EQ(ids({.instrument = "ballbar", .joint = -1, .file = ""}, {"t_s"}),
            (std::set<std::string>{"probe_lobing", "time_shift", "datum_shift"}));
}

}  // namespace
}  // namespace nineline::errors
