#include "core/measurement/prediction.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "core/kinematics/machine_file.h"
#include "tests/core/measurement/set_ups.h"

namespace nineline::measurement {
namespace {

using Eigen::Vector3d;

constexpr double kPicometre = 1e-9;

Instrument onAxis(InstrumentKind kind, char axis, const Vector3d& point = Vector3d::Zero(),
                  int direction = 0) {
  Instrument instrument;
  instrument.kind = kind;
  instrument.axis = AxisId{axis, 0};
  instrument.point = point;
  instrument.sensitive = instrument.about = direction;
  return instrument;
}

/// The only reading at one position.
double readingAt(const ErrorModel& model, const Instrument& instrument, const JointPositions& q,
                 Quantity quantity = Quantity::Length) {
  const Result<Prediction> prediction = predict(model, measurementAt(instrument, {{quantity}}, {q}));
  if (!prediction) throw std::runtime_error(prediction.error().message());
  return prediction->readings[0];
}

TEST(Prediction, DeviationIsToolRelativeToWork) {
  // Convention 2: +EXX of a table X moves the tool by -x in W; on the tool's side +EXZ by +x.
  const Instrument instrument;
  EXPECT_NEAR(
      readingAt(modelOf("generic-3axis", constantUm("EXX", 5)), instrument, {0, 50, 0}, Quantity::DevX),
      -0.005, kPicometre);
  EXPECT_NEAR(
      readingAt(modelOf("generic-3axis", constantUm("EXZ", 5)), instrument, {0, 50, 0}, Quantity::DevX),
      0.005, kPicometre);
  // A tilt of the head about +y is a rotation of the tool about +y in W, a tilt of the table about -y.
  const double tilt = radFromArcsec(10);
  EXPECT_NEAR(readingAt(modelOf("generic-3axis", constantArcsec("EBZ", 10)), instrument, {}, Quantity::RotY),
              tilt, 1e-13);
  EXPECT_NEAR(readingAt(modelOf("generic-3axis", constantArcsec("EBX", 10)), instrument, {}, Quantity::RotY),
              -tilt, 1e-13);
}

TEST(Prediction, JointReadsItsOwnPositioningAlone) {
  const Instrument z = onAxis(InstrumentKind::Joint, 'Z');
  const std::string others =
      constantUm("EXZ", 9) + "," + constantArcsec("EBZ", 30) + "," + constantUm("EZX", 4);
  EXPECT_NEAR(readingAt(modelOf("b2-k3032", constantUm("EZZ", 7) + "," + others), z, {100, 0, 0}), 0.007,
              kPicometre);
  // A table X that a positive command moves towards -x: +EXX is against the command's sense.
  EXPECT_NEAR(
      readingAt(modelOf("generic-3axis", constantUm("EXX", 7)), onAxis(InstrumentKind::Joint, 'X'), {}),
      -0.007, kPicometre);
  // A reference point moves no positioning into the reading.
  const std::string about = R"(, "reference_mm": [100, 200, 0])";
  EXPECT_NEAR(
      readingAt(modelOf("b2-k3032", constantUm("EZZ", 7, about) + "," + constantArcsec("EAZ", 20, about)), z,
                {100, 0, 0}),
      0.007, kPicometre);
}

TEST(Prediction, JointOfARotaryAxisReadsAnAngle) {
  const std::string ecc =
      R"({"effect": "table", "component": "ECC", "start_deg": 0, "spacing_deg": 90, "values_arcsec": [6, 6, 6, 6]})";
  // C of the trunnion turns about -z: +ECC turns the table against the command's sense.
  EXPECT_NEAR(
      readingAt(modelOf("b2-k3032", ecc), onAxis(InstrumentKind::Joint, 'C'), {0, 1, 0}, Quantity::Angle),
      radFromArcsec(6), 1e-13);
  EXPECT_NEAR(readingAt(modelOf("trunnion-ac", ecc), onAxis(InstrumentKind::Joint, 'C'), {0, 1, 0, 0, 0},
                        Quantity::Angle),
              -radFromArcsec(6), 1e-13);
}

TEST(Prediction, LaserLinearReadsTheBodyAgainstTheBed) {
  // Convention 4: on the workpiece side +EZZ reads +.
  EXPECT_NEAR(readingAt(modelOf("b2-k3032", constantUm("EZZ", 7)), onAxis(InstrumentKind::LaserLinear, 'Z'),
                        {100, 0, 0}),
              0.007, kPicometre);
  // Pitch EAZ = 10 arcsec with the beam 200 mm above the axis: z moves by +EA y = 200 · 4.848e-5 = 9.7 um.
  EXPECT_NEAR(readingAt(modelOf("b2-k3032", constantArcsec("EAZ", 10)),
                        onAxis(InstrumentKind::LaserLinear, 'Z', {0, 200, 0}), {100, 0, 0}),
              200.0 * std::sin(radFromArcsec(10)), kPicometre);
  // Table X with direction -x: its own scale error reads along the direction of motion.
  EXPECT_NEAR(readingAt(modelOf("generic-3axis", constantUm("EXX", 5)),
                        onAxis(InstrumentKind::LaserLinear, 'X'), {0, 100, 0}),
              -0.005, kPicometre);
}

TEST(Prediction, LaserStraightnessAndAngularStandInBedAxes) {
  // Convention 4: yaw ε with the point at y reads −ε y along X.
  const ErrorModel yaw = modelOf("b2-k3032", constantArcsec("ECZ", 10));
  EXPECT_NEAR(readingAt(yaw, onAxis(InstrumentKind::LaserStraightness, 'Z', {0, 200, 0}, 0), {50, 0, 0}),
              -200.0 * std::sin(radFromArcsec(10)), kPicometre);
  EXPECT_NEAR(
      readingAt(yaw, onAxis(InstrumentKind::LaserAngular, 'Z', {0, 200, 0}, 2), {50, 0, 0}, Quantity::Angle),
      radFromArcsec(10), 1e-13);
  // X carried by a Y that is tilted: the errors below the body count, those above it do not.
  const ErrorModel mill = modelOf(
      "generic-3axis", constantUm("EZY", 3) + "," + constantUm("EZX", 4) + "," + constantUm("EZZ", 50));
  EXPECT_NEAR(readingAt(mill, onAxis(InstrumentKind::LaserStraightness, 'X', Vector3d::Zero(), 2), {}), 0.007,
              kPicometre);
  EXPECT_NEAR(readingAt(mill, onAxis(InstrumentKind::LaserStraightness, 'Y', Vector3d::Zero(), 2), {}), 0.003,
              kPicometre);
}

TEST(Prediction, BallbarReadsRadiallyInW) {
  // Scale 50 um/m on X alone, circle of 100 mm in XZ: +5 um at 0°, 0 at 90°.
  const std::string scale =
      R"({"effect": "scale", "joint": "X", "parameters": {"k": {"value": 50, "unit": "um/m"}}})";
  Instrument instrument;
  instrument.kind = InstrumentKind::Ballbar;
  instrument.radius = 100.0;
  instrument.plane = "ZX";
  const ErrorModel model = modelOf("b2-k3032", scale);
  EXPECT_NEAR(readingAt(model, instrument, {0, 0, 100}, Quantity::Radius), 0.005, kPicometre);
  EXPECT_NEAR(readingAt(model, instrument, {100, 0, 0}, Quantity::Radius), 0.0, kPicometre);
  // The command itself may miss the circle: nothing is fitted out.
  EXPECT_NEAR(readingAt(model, instrument, {0, 0, 101}, Quantity::Radius), 1.0 + 101.0 * 50e-6, kPicometre);
}

TEST(Prediction, LeadFollowsTheScrew) {
  // +EZZ = 7 um of the work table moves the tool by -7 um along z in W: lead reads -7 um.
  Instrument instrument;
  instrument.kind = InstrumentKind::Lead;
  instrument.pitch = 10.0;
  instrument.starts = 2;
  EXPECT_NEAR(readingAt(modelOf("b2-k3032", constantUm("EZZ", 7)), instrument, {100, 1, 24}), -0.007,
              kPicometre);
  // ECC = +30 arcsec turns the work on: the tool's φ in W falls behind by it. L = 20 mm right hand:
  // −L/2π · (−30″) = 20/2π · 1.454e-4 = +0.463 um; left hand the opposite.
  const ErrorModel turned = modelOf(
      "b2-k3032",
      R"({"effect": "table", "component": "ECC", "start_deg": 0, "spacing_deg": 90, "values_arcsec": [30, 30, 30, 30]})");
  const double wanted = 20.0 / kTurn * radFromArcsec(30);
  EXPECT_NEAR(wanted, 0.463e-3, 1e-6);
  EXPECT_NEAR(readingAt(turned, instrument, {100, 1, 24}), wanted, kPicometre);
  EXPECT_NEAR(readingAt(turned, instrument, {100, 1, 0}), wanted, kPicometre) << "a tool point on the axis";
  instrument.left_hand = true;
  EXPECT_NEAR(readingAt(turned, instrument, {100, 1, 24}), -wanted, kPicometre);
}

TEST(Prediction, DialShowsHowFarTheMaterialAtTheGaugeMoved) {
  // EXC in the turning frame at 90° lies along the bed's y.
  const std::string exc =
      R"({"effect": "table", "component": "EXC", "start_deg": 0, "spacing_deg": 90, "values_um": [4, 4, 4, 4]})";
  const ErrorModel model = modelOf("b2-k3032", exc);
  EXPECT_NEAR(readingAt(model, onAxis(InstrumentKind::Dial, 'C', {30, 0, 50}, 1), {0, kPi / 2, 0}), 0.004,
              kPicometre);
  EXPECT_NEAR(readingAt(model, onAxis(InstrumentKind::Dial, 'C', {30, 0, 50}, 0), {0, kPi / 2, 0}), 0.0,
              kPicometre);
  // Wobble EAC = 20 arcsec at 0°: the gauge 150 mm along z in the y direction reads −150 · 20″ = −14.5 um.
  const std::string eac =
      R"({"effect": "table", "component": "EAC", "start_deg": 0, "spacing_deg": 90, "values_arcsec": [20, 20, 20, 20]})";
  EXPECT_NEAR(readingAt(modelOf("b2-k3032", eac), onAxis(InstrumentKind::Dial, 'C', {30, 0, 150}, 1), {}),
              -150.0 * std::sin(radFromArcsec(20)), 1e-7);
}

TEST(Prediction, FitsTheUnknownZeroOfAFile) {
  const ErrorModel model = modelOf("b2-k3032", constantUm("EZZ", 7));
  Measurement measurement =
      measurementAt(onAxis(InstrumentKind::LaserLinear, 'Z'), {{Quantity::Length}}, {{0}, {100}, {200}});
  measurement.readings = {0.010, std::nullopt, 0.013};
  measurement.samples[0].sigma = 0.001;
  measurement.samples[2].sigma = 0.002;
  const Result<Prediction> prediction = predict(model, measurement);
  ASSERT_TRUE(prediction);
  // Differences 3 and 6 um with weights 4 : 1.
  EXPECT_NEAR(*prediction->zeros[0], 0.0036, kPicometre);
  EXPECT_NEAR(prediction->shown(1), 0.0106, kPicometre);
  // deviation has no zero.
  Measurement absolute = measurementAt(Instrument{}, {{Quantity::DevZ}}, {{0}});
  absolute.readings = {0.5};
  EXPECT_EQ(*predict(model, absolute)->zeros[0], 0.0);
}

TEST(Prediction, BacklashFollowsTheApproachNotThePath) {
  const ErrorModel model =
      modelOf("linear-stage",
              R"({"effect": "backlash", "joint": "X", "parameters": {"width": {"value": 6, "unit": "um"}}})");
  Measurement measurement =
      measurementAt(onAxis(InstrumentKind::Joint, 'X'), {{Quantity::Length}}, {{0}, {100}, {100}, {0}});
  EXPECT_NEAR(predict(model, measurement)->readings[2], -0.003, kPicometre) << "no motion: as it came";
  addColumn(measurement, "approach_X_1", {1, 1, -1, -1});
  const Eigen::VectorXd readings = predict(model, measurement)->readings;
  EXPECT_NEAR(readings[1], -0.003, kPicometre);
  EXPECT_NEAR(readings[2], 0.003, kPicometre);
}

TEST(Prediction, RefusesWhatItCannotKnow) {
  const ErrorModel model = modelOf("linear-stage",
                                   R"({"effect": "thermal_screw", "joint": "X", "parameters": {"k": 11,
                                       "q_fixed": 0, "sensor": "temp_screw_X_C"}})");
  Measurement measurement =
      measurementAt(onAxis(InstrumentKind::LaserLinear, 'X'), {{Quantity::Length}}, {{0}, {500}});
  const Result<Prediction> without = predict(model, measurement);
  ASSERT_FALSE(without);
  EXPECT_NE(without.error().text.find("temp_screw_X_C"), std::string::npos) << without.error().text;
  addColumn(measurement, "temp_screw_X_C", {24.0, std::nullopt});
  const Result<Prediction> partly = predict(model, measurement);
  ASSERT_TRUE(partly);
  EXPECT_EQ(partly->is_complete, (std::vector<std::uint8_t>{1, 0}));
  EXPECT_EQ(partly->warnings.all().size(), 1u);
  const Result<Prediction> wrong =
      predict(model, measurementAt(onAxis(InstrumentKind::Dial, 'C'), {{Quantity::Length}}, {{0}}));
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().code, "measurement.axis");
}

TEST(Prediction, LeavesOutSamplesWithoutAPosition) {
  Measurement measurement =
      measurementAt(Instrument{}, {{Quantity::DevX}, {Quantity::DevZ}}, {{0}, {1}, {2}});
  measurement.samples[1].has_positions = false;
  const Result<Prediction> prediction = predict(modelOf("b2-k3032", ""), measurement);
  ASSERT_TRUE(prediction);
  ASSERT_EQ(prediction->rows.size(), 4u);
  EXPECT_EQ(prediction->rows[2].sample, 2u);
  EXPECT_EQ(prediction->readings.size(), 4);
}

}  // namespace
}  // namespace nineline::measurement
