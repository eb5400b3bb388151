#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "tests/core/errors/sample_effects.h"

namespace nineline::errors {
namespace {

constexpr double kExact = 1e-15;  // mm, rad

SmallMotion motionOf(const std::string& json, const MachineState& state,
                     const std::string& machine = "b2-k3032") {
  const ErrorModel model = modelOf(machine, json);
  SmallMotion motion;
  model.effects()[0]->addMotion(state, {}, motion);
  return motion;
}

std::string entry(const std::string& id, const std::string& component, const std::string& parameters,
                  const std::string& more = "") {
  return R"({"effect": ")" + id + R"(", "component": ")" + component + R"(", "parameters": {)" + parameters +
         "}" + more + "}";
}

MachineState at(double z, double c, double x) {
  MachineState state = richState();
  state.q = {z, c, x};
  return state;
}

double z(const std::string& json, const MachineState& state) { return motionOf(json, state).translation.z(); }
double x(const std::string& json, const MachineState& state) { return motionOf(json, state).translation.x(); }

TEST(Straightness, ByHand) {
  // Travel of Z: −400…400, so Z = 200 stands at x = 0.5.
  EXPECT_NEAR(x(entry("straightness", "EXZ", R"("amplitude": 12, "shape": 2)"), at(200, 0, 0)),
              0.012 * (0.25 - 1.0 / 3.0), kExact);
  EXPECT_NEAR(x(entry("straightness", "EXZ", R"("amplitude": 12, "shape": "bow")"), at(400, 0, 0)),
              0.012 * 2.0 / 3.0, kExact);
  EXPECT_NEAR(x(entry("straightness", "EXZ", R"("amplitude": 12, "shape": "s")"), at(200, 0, 0)),
              0.012 * (0.125 - 0.3), kExact);
  // Legendre's polynomials at 0.5: P4 = −37/128, P5 = 23/256, P6 = 331/1024.
  EXPECT_NEAR(x(entry("straightness", "EXZ", R"("amplitude": 1, "shape": 4)"), at(200, 0, 0)),
              -0.001 * 37 / 128, kExact);
  EXPECT_NEAR(x(entry("straightness", "EXZ", R"("amplitude": 1, "shape": 5)"), at(200, 0, 0)),
              0.001 * 23 / 256, kExact);
  EXPECT_NEAR(x(entry("straightness", "EXZ", R"("amplitude": 1, "shape": 6)"), at(200, 0, 0)),
              0.001 * 331 / 1024, kExact);
}

TEST(Straightness, OverAPartOfTheTravel) {
  EXPECT_NEAR(
      x(entry("straightness", "EXZ", R"("amplitude": 3)", R"(, "range_mm": [0, 200])"), at(100, 0, 0)),
      -0.001, kExact);
}

TEST(Angular, TipsTheToolThroughItsArm) {
  // A roll of 10 arcsec of the tool slide X at full travel; the tip stands 350 mm + 0 from its frame: the
  // pitch about y moves a point that lies 100 mm below by −100 θ along x.
  EXPECT_NEAR(motionOf(entry("angular", "EBX", R"("amplitude": 10)"), at(0, 0, 350)).rotation.y(),
              radFromArcsec(10.0), kExact);
  EXPECT_NEAR(motionOf(entry("angular", "EBX", R"("amplitude": 10)"), at(0, 0, 50)).rotation.y(),
              -radFromArcsec(5.0), kExact);
}

TEST(Sag, DropsAsTheSquareOfTheReach) {
  EXPECT_NEAR(z(entry("sag", "EZX", R"("k": 100, "q_ref": -50)"), at(0, 0, 350)), -0.1 * 0.16, kExact);
  EXPECT_NEAR(z(entry("sag", "EZX", R"("k": 100, "q_ref": -50, "power": 3)"), at(0, 0, 350)), -0.1 * 0.064,
              kExact);
}

TEST(Rotating, EccentricityTurnsWithTheWork) {
  const SmallMotion motion =
      motionOf(entry("eccentricity", "EXC", R"("amplitude": 8, "phase": 30)"), at(0, kPi / 6, 0));
  EXPECT_NEAR(motion.translation.x(), 0.008 * 0.5, kExact);
  EXPECT_NEAR(motion.translation.y(), 0.008 * std::sqrt(0.75), kExact);
  EXPECT_EQ(motion.translation.z(), 0.0);
  // Contract.md, convention 2: in the moved frame, so a tool held still sees −R(0) (EX, EY) in W.
  const ErrorModel model =
      modelOf("b2-k3032", entry("eccentricity", "EXC", R"("amplitude": 8, "phase": 30)"));
  const MachineState state = at(0, kPi / 6, 0);
  const Eigen::Vector3d seen = model.actualPose(state).tip - model.idealPose(state).tip;
  EXPECT_NEAR(seen.x(), -0.004, 1e-12);
  EXPECT_NEAR(seen.y(), -0.008 * std::sqrt(0.75), 1e-12);
}

TEST(Rotating, PairsFollowTheOwnAxisInOrder) {
  // About x: the pair is y, z.
  const SmallMotion motion =
      motionOf(R"({"effect": "wobble", "joint": "A", "parameters": {"amplitude": 10}})", MachineState{},
               "trunnion-ac");
  EXPECT_EQ(motion.rotation.x(), 0.0);
  EXPECT_NEAR(motion.rotation.y(), radFromArcsec(10.0), kExact);
}

TEST(Rotating, LobesRunoutAndEncoder) {
  const SmallMotion lobes = motionOf(entry("lobing", "EXC", R"("amplitude": 2, "n": 3)"), at(0, kPi / 6, 0));
  EXPECT_NEAR(lobes.translation.x(), 0.0, kExact);
  EXPECT_NEAR(lobes.translation.y(), 0.002, kExact);
  EXPECT_NEAR(z(entry("axial_runout", "EZC", R"("amplitude": 2)"), at(0, kPi / 6, 0)), 0.001, kExact);
  EXPECT_NEAR(
      motionOf(entry("encoder_eccentricity", "ECC", R"("amplitude": 6)"), at(0, kPi / 2, 0)).rotation.z(),
      radFromArcsec(6.0), kExact);
  EXPECT_NEAR(motionOf(entry("encoder_subdivision", "ECC", R"("amplitude": 6, "n": 90)"), at(0, kPi / 180, 0))
                  .rotation.z(),
              radFromArcsec(6.0), kExact);
  EXPECT_NEAR(z(entry("encoder_subdivision", "EZZ", R"("amplitude": 1, "period": 0.02)"), at(100.005, 0, 0)),
              0.001, 1e-12);
}

TEST(Rotating, ClampingFadesAwayFromTheChuck) {
  const std::string chuck =
      entry("clamping", "EXC", R"("amplitude": 4, "length": 30, "q_ref": -100)", R"(, "along": "Z")");
  EXPECT_NEAR(x(chuck, at(-100, 0, 0)), 0.004, kExact);
  EXPECT_NEAR(x(chuck, at(-40, 0, 0)), 0.004 * std::exp(-2.0), kExact);
  EXPECT_NEAR(x(chuck, at(-100, kTurn / 3, 0)), 0.004, kExact);
}

TEST(Reversal, EachTrailsBehindTheMotion) {
  MachineState up = at(100, 0, 200);
  up.approach = {1, 1, 1};
  MachineState down = up;
  down.approach = {-1, -1, -1};
  const std::vector<std::pair<std::string, double>> cases = {
      {entry("backlash", "EXX", R"("width": 4)"), -0.002},
      {entry("windup", "EXX", R"("k": 10)"), -0.001},             // 10 um/m over 0.2 m: 2 um wide
      {entry("lost_motion", "EXX", R"("kappa": 0.05)"), -0.003},  // 120 kg: 6 um wide
      {entry("hysteresis", "EXX", R"("width": 6, "length": 0.5)"), -0.003 * (1.0 - 2.0 * std::exp(-2.0))},
      {entry("reversal_spike", "EXX", R"("height": 7, "length": 2)"), -0.007 * std::exp(-0.5)},
      {entry("friction_speed", "EXX", R"("width": 2, "height": 3, "speed": 4)"),
       -(0.001 + 0.003 * std::exp(-0.25))},
      {entry("servo_lag", "EXX", R"("tau": 0.5)"), -0.001}};  // 2 mm/s
  for (const auto& [json, expected] : cases) {
    up.since_reversal = JointPositions{1.0, 1.0, 1.0};
    down.since_reversal = up.since_reversal;
    up.velocity = JointPositions{0.0, 0.0, 2.0};
    down.velocity = JointPositions{0.0, 0.0, -2.0};
    EXPECT_NEAR(x(json, up), expected, kExact) << json;
    EXPECT_NEAR(x(json, down), -expected, kExact) << json;
  }
  EXPECT_NEAR(motionOf(entry("lateral_play", "EYX", R"("width": 3)"), up).translation.y(), -0.0015, kExact);
  EXPECT_NEAR(motionOf(entry("angular_play", "ECX", R"("width": 5)"), up).rotation.z(), -radFromArcsec(2.5),
              kExact);
}

TEST(Reversal, ASpikeDiesWhereTheMachineStands) {
  MachineState state = at(100, 0, 200);
  const std::string spike = entry("reversal_spike", "EXX", R"("height": 7, "length": 2)");
  state.velocity = JointPositions{};
  EXPECT_EQ(x(spike, state), 0.0);
  state.velocity = JointPositions{3.0, 0.0, 0.0};  // another axis moves: a circle at its quadrant
  EXPECT_NE(x(spike, state), 0.0);
  state.since_reversal.reset();
  EXPECT_EQ(x(spike, state), 0.0);
}

TEST(Dynamic, ByHand) {
  const MachineState state = richState();  // C turns with 1.1 rad/s, Z accelerates with 40 mm/s²
  EXPECT_NEAR(motionOf(entry("sync_delay", "ECC", R"("tau": 2)"), state).rotation.z(), -0.0022, kExact);
  EXPECT_NEAR(z(entry("acceleration", "EZZ", R"("k": 50)"), state), 0.002,
              kExact);  // 50 um/(m/s²), 0.04 m/s²
  EXPECT_NEAR(x(entry("vibration", "EXX", R"("amplitude": 2, "frequency": 0.25, "phase": 30)"), state), 0.001,
              1e-12);  // 250 whole periods
  // 2 mm/s are 0.12 m/min.
  EXPECT_NEAR(x(entry("counterweight", "EXX", R"("width": 2, "k": 5)"), state), -0.001 + 0.0006, kExact);
}

TEST(Thermal, TheScrewGrowsFromItsFixedBearing) {
  EXPECT_NEAR(z(entry("thermal_screw", "EZZ", R"("k": 11, "q_fixed": -400)"), at(100, 0, 0)), 11e-6 * 4 * 500,
              kExact);
  // Stretched up to 23 °C: one degree counts.
  EXPECT_NEAR(z(entry("thermal_screw", "EZZ", R"("k": 11, "q_fixed": -400, "preload": 23)"), at(100, 0, 0)),
              11e-6 * 500, kExact);
  EXPECT_EQ(z(entry("thermal_screw", "EZZ", R"("k": 11, "q_fixed": -400, "preload": 25)"), at(100, 0, 0)),
            0.0);
  // 25 °C at −400, 22 °C at 400: 3.5 K in the middle of the whole screw, 4.25 K of its lower half.
  const std::string gradient = entry("thermal_screw", "EZZ", R"("k": 10, "q_fixed": -400)",
                                     R"(, "sensor": "temp_front_C", "sensor_2": "temp_back_C")");
  EXPECT_NEAR(z(gradient, at(400, 0, 0)), 10e-6 * 3.5 * 800, kExact);
  EXPECT_NEAR(z(gradient, at(0, 0, 0)), 10e-6 * 4.25 * 400, kExact);
}

TEST(Thermal, GrowthTiltAndDrift) {
  const MachineState state = richState();
  EXPECT_NEAR(x(entry("thermal_head", "EXX", R"("k": 3)"), state), 0.033, kExact);  // 31 °C
  EXPECT_NEAR(x(entry("coolant", "EXX", R"("k": 6)"), state), 0.006, kExact);       // a switch counts from 0
  EXPECT_NEAR(motionOf(entry("thermal_tilt", "EBX", R"("k": 2)",
                             R"(, "sensor": "temp_front_C", "sensor_2": "temp_back_C")"),
                       state)
                  .rotation.y(),
              radFromArcsec(6.0), kExact);
  EXPECT_NEAR(x(entry("drift", "EXX", R"("rate": 3.6)"), state), 0.001, kExact);  // 1000 s
}

/// A headstock that grows by 10 um along +Y carries the work up: the tool, which stands still, comes to lie
/// 10 um lower in the work, whatever the angle of C.
TEST(Thermal, AHeadThatRisesLeavesTheToolLow) {
  const ErrorModel model =
      modelOf("b2-k3032", entry("thermal_head", "Y0C", R"("k": 1)", R"(, "sensor": "temp_head_C")"));
  MachineState state = at(0, 0, 100);
  state.conditions = {{"temp_head_C", 30.0}};
  EXPECT_NEAR((model.actualPose(state).tip - model.idealPose(state).tip).y(), -0.010, 1e-12);
  state.q[1] = kPi / 2;
  EXPECT_NEAR((model.actualPose(state).tip - model.idealPose(state).tip).x(), -0.010, 1e-12);
}

/// Backlash of the tool slide X: having come upwards, the tool has not quite arrived.
TEST(Reversal, AToolThatCameUpStandsLow) {
  const ErrorModel model = modelOf("b2-k3032", entry("backlash", "EXX", R"("width": 4)"));
  EXPECT_NEAR(model.actualPose(richState()).tip.x() - model.idealPose(richState()).tip.x(),
              -0.002 * std::cos(0.7), 1e-9);
}

TEST(Load, ByHand) {
  const MachineState state = at(100, 0, 60);
  EXPECT_NEAR(x(entry("load_deformation", "EXX", R"("k": -0.05)"), state), -0.006, kExact);
  EXPECT_NEAR(motionOf(entry("load_tilt", "EBZ", R"("k": 0.03)"), state).rotation.y(), radFromArcsec(3.6),
              kExact);
  const std::string bending = entry("workpiece_bending", "EXZ", R"("k": 0.1)", R"(, "range_mm": [0, 400])");
  EXPECT_NEAR(x(bending, at(200, 0, 0)), 0.012, kExact);
  EXPECT_NEAR(x(bending, at(100, 0, 0)), 0.012 * 16.0 * 9.0 / 256.0, kExact);
  EXPECT_EQ(x(bending, at(-10, 0, 0)), 0.0);
}

TEST(Process, ByHand) {
  const MachineState state = richState();  // pass 3, feed 5 mm/s = 0.3 m/min
  EXPECT_NEAR(x(entry("wheel_wear", "EXX", R"("rate": 0.5)"), state), 0.0015, kExact);
  EXPECT_NEAR(x(entry("wheel_wear", "EXX", R"("rate": 0.5, "passes": 4)"), state),
              0.002 * (1.0 - std::exp(-0.75)), kExact);
  EXPECT_NEAR(x(entry("wheel_deflection", "EXX", R"("k": 10)"), state), 0.003, kExact);
  EXPECT_NEAR(x(entry("spark_out", "EXX", R"("k": 10, "passes": 1.5)"), state), 0.003 * std::exp(-2.0),
              kExact);
  MachineState pressed = state;
  pressed.conditions.emplace_back("force_1", 40.0);
  EXPECT_NEAR(x(entry("wheel_deflection", "EXX", R"("k": {"value": 0.1, "unit": "um/1"})",
                      R"(, "sensor": "force_1")"),
                pressed),
              0.004, kExact);
}

}  // namespace
}  // namespace nineline::errors
