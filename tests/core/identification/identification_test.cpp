#include "core/identification/identification.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/errors/error_model_file.h"
#include "core/identification/next_measurement.h"
#include "core/kinematics/machine_file.h"
#include "core/measurement/prediction.h"
#include "tests/identification_campaign/campaign.h"

namespace nineline::identification {
namespace {

using identification_campaign::compare;
using identification_campaign::Comparison;
using identification_campaign::kindName;
using identification_campaign::NoisePlan;
using identification_campaign::plantCase;
using identification_campaign::PlantedCase;
using measurement::Channel;
using measurement::InstrumentKind;
using measurement::Quantity;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr double kNineDigits = 1e-9;  // mm, rad

Result<IdentificationReport> identifyQuietly(const Machine& machine, const std::vector<Measurement>& files,
                                             IdentificationOptions options = {}) {
  NoProgress progress;
  return identify(machine, files, options, progress);
}

TEST(Identify, FindsExactReadingsAgainOnEveryMachine) {
  for (int kind = 0; kind < 4; ++kind) {
    const PlantedCase planted = plantCase(100U + static_cast<unsigned>(kind), kind, 1, nullptr);
    IdentificationOptions options;
    options.propose = false;
    const auto report = identifyQuietly(planted.machine, planted.files, options);
    ASSERT_TRUE(report) << kindName(kind) << ": " << report.error().message();
    const Comparison comparison = compare(*report->model, planted.truth);
    EXPECT_THAT(comparison.missing, IsEmpty()) << kindName(kind);
    EXPECT_LT(comparison.largest_length, kNineDigits) << kindName(kind);
    EXPECT_LT(comparison.largest_angle, 1e-12) << kindName(kind);
    EXPECT_LT(report->residual_rms, kNineDigits) << kindName(kind);
    EXPECT_THAT(report->outliers, IsEmpty()) << kindName(kind);
  }
}

TEST(Identify, StatesUncertaintiesThatHold) {
  identification_campaign::Coverage all;
  for (int kind = 0; kind < 4; ++kind) {
    const NoisePlan noise;
    const PlantedCase planted = plantCase(200U + static_cast<unsigned>(kind), kind, 2, &noise);
    IdentificationOptions options;
    options.propose = false;
    const auto report = identifyQuietly(planted.machine, planted.files, options);
    ASSERT_TRUE(report) << report.error().message();
    all.add(compare(*report->model, planted.truth).all);
    EXPECT_GE(report->outliers.size(), planted.outliers * 8 / 10);
    EXPECT_LE(report->outliers.size(), planted.outliers + 3);
  }
  EXPECT_GT(all.values, 400U);
  EXPECT_GT(all.percent(), 92.0);  // 95.4 expected; the values of one machine are correlated
  EXPECT_LT(all.percent(), 98.5);
}

TEST(Identify, TheWrittenModelReproducesTheReadings) {
  const PlantedCase planted = plantCase(300, 0, 1, nullptr);
  const auto report = identifyQuietly(planted.machine, planted.files);
  ASSERT_TRUE(report);
  const auto model = errors::readErrorModel(writeJson(errors::errorModelToJson(*report->model)), "model");
  ASSERT_TRUE(model) << model.error().message();
  for (const Measurement& file : planted.files) {
    const auto prediction = measurement::predict(*model, file);
    ASSERT_TRUE(prediction);
    for (std::size_t row = 0; row < prediction->rows.size(); ++row) {
      EXPECT_NEAR(*prediction->rows[row].value, prediction->shown(row), kNineDigits);
    }
  }
}

// --- what readings cannot tell ---

Measurement lineOf(const Machine& machine, const char* axis, InstrumentKind kind, Quantity quantity,
                   const Eigen::Vector3d& point, int direction = 0) {
  Measurement file;
  file.source = "line";
  file.instrument.kind = kind;
  file.instrument.axis = parseAxisId(axis);
  file.instrument.point = point;
  file.instrument.sensitive = file.instrument.about = direction;
  file.channels = {Channel{quantity}};
  file.commanded.assign(static_cast<std::size_t>(machine.jointCount()), true);
  const int joint = machine.find(*file.instrument.axis);
  for (int i = 0; i < 12; ++i) {
    measurement::Sample sample;
    const double at = machine.isRotary(joint) ? kTurn * i / 12 : -50.0 + 25.0 * i;
    sample.q[static_cast<std::size_t>(joint)] = at;
    file.samples.push_back(sample);
    file.readings.emplace_back(1e-3 * std::sin(0.7 * i) + 1e-3);
  }
  return file;
}

std::vector<std::string> namesOf(const errors::ErrorModel& model) {
  std::vector<std::string> names;
  for (const errors::EffectPtr& effect : model.effects()) names.push_back(effect->component().text());
  return names;
}

const Unobservable* find(const IdentificationReport& report, const std::string& name) {
  for (const Unobservable& one : report.unobservable) {
    if (one.name == name) return &one;
  }
  return nullptr;
}

TEST(Identify, ASingleLineTellsPositioningAndNamesWhatItCannotTell) {
  const Machine machine = *kinematics::findBuiltInMachine("generic-3axis");
  const std::vector<Measurement> files{
      lineOf(machine, "X", InstrumentKind::LaserLinear, Quantity::Length, {0.0, 100.0, 0.0})};
  const auto report = identifyQuietly(machine, files);
  ASSERT_TRUE(report) << report.error().message();
  EXPECT_THAT(namesOf(*report->model), ElementsAre("EXX"));
  const Unobservable* yaw = find(*report, "ECX");
  ASSERT_NE(yaw, nullptr);
  EXPECT_THAT(yaw->partners, ElementsAre("EXX"));
  EXPECT_THAT(yaw->text(), HasSubstr("cannot tell it from EXX"));
  const Unobservable* roll = find(*report, "EAX");
  ASSERT_NE(roll, nullptr);
  EXPECT_THAT(roll->partners, IsEmpty());
  EXPECT_THAT(roll->text(), HasSubstr("no reading depends on it"));
}

TEST(Identify, ProposesTheMeasurementThatTellsTheYaw) {
  const Machine machine = *kinematics::findBuiltInMachine("linear-stage");
  const std::vector<Measurement> files{
      lineOf(machine, "X", InstrumentKind::LaserLinear, Quantity::Length, {0.0, 100.0, 0.0})};
  const auto report = identifyQuietly(machine, files);
  ASSERT_TRUE(report);
  ASSERT_THAT(report->proposals, testing::Not(IsEmpty()));
  std::vector<std::string> told;
  for (const ProposedMeasurement& one : report->proposals) {
    told.insert(told.end(), one.would_tell.begin(), one.would_tell.end());
  }
  EXPECT_THAT(told, Contains("ECX"));
}

TEST(Identify, ThreeLinesTellTheYaw) {
  const Machine machine = *kinematics::findBuiltInMachine("linear-stage");
  const std::vector<Measurement> files{
      lineOf(machine, "X", InstrumentKind::LaserLinear, Quantity::Length, {0.0, 0.0, 0.0}),
      lineOf(machine, "X", InstrumentKind::LaserLinear, Quantity::Length, {0.0, 200.0, 0.0})};
  const auto report = identifyQuietly(machine, files);
  ASSERT_TRUE(report);
  EXPECT_THAT(namesOf(*report->model), ElementsAre("EXX", "ECX"));
}

TEST(Identify, OneDialTellsTheStandingFramesMotionOnly) {
  const Machine machine = *kinematics::findBuiltInMachine("rotary-table");
  const std::vector<Measurement> files{
      lineOf(machine, "C", InstrumentKind::Dial, Quantity::Length, {0.0, 0.0, 50.0}, 0)};
  const auto report = identifyQuietly(machine, files);
  ASSERT_TRUE(report) << report.error().message();
  EXPECT_THAT(namesOf(*report->model), ElementsAre("EXC"));
  EXPECT_THAT(writeJson(errors::errorModelToJson(*report->model)), HasSubstr("\"fixed\""));
  const Unobservable* tilt = find(*report, "EBC");  // the lever of the dial's height makes it look like EXC
  ASSERT_NE(tilt, nullptr);
  EXPECT_THAT(tilt->partners, ElementsAre("EXC"));
}

TEST(Identify, ABallbarTellsOneSquarenessOfTwo) {
  const Machine machine = *kinematics::findBuiltInMachine("generic-3axis");
  Measurement file = lineOf(machine, "X", InstrumentKind::Ballbar, Quantity::Radius, Eigen::Vector3d::Zero());
  file.instrument = {};
  file.instrument.kind = InstrumentKind::Ballbar;
  file.instrument.radius = 100.0;
  file.repeatability = 5e-4;
  file.samples.clear();
  file.readings.clear();
  const auto x = static_cast<std::size_t>(machine.find(*parseAxisId("X")));
  const auto y = static_cast<std::size_t>(machine.find(*parseAxisId("Y")));
  for (int i = 0; i < 360; ++i) {
    measurement::Sample sample;
    sample.q[x] = 100.0 * std::cos(kTurn * i / 360);
    sample.q[y] = 100.0 * std::sin(kTurn * i / 360);
    file.samples.push_back(sample);
    file.readings.emplace_back(2e-3 * std::sin(2.0 * kTurn * i / 360));
  }
  // The circle's centre is where the tool stands at zero.
  file.instrument.centre = kinematics::forward(machine, {}).tip;
  const auto report = identifyQuietly(machine, {file});
  ASSERT_TRUE(report) << report.error().message();
  // Y carries X and the workpiece: turning both turns the circle about its own centre.
  EXPECT_THAT(namesOf(*report->model), Contains("C0X"));
  EXPECT_THAT(namesOf(*report->model), testing::Not(Contains("C0Y")));
  EXPECT_NE(find(*report, "C0Y"), nullptr);
}

TEST(JudgePlan, SaysWhatAPlanTellsBeforeAnyoneMeasures) {
  const Machine machine = *kinematics::findBuiltInMachine("linear-stage");
  std::vector<Measurement> files{
      lineOf(machine, "X", InstrumentKind::LaserLinear, Quantity::Length, {0.0, 0.0, 0.0})};
  for (auto& reading : files[0].readings) reading.reset();
  const auto one = judgePlan(machine, files);
  ASSERT_TRUE(one);
  EXPECT_THAT(one->told, ElementsAre("EXX"));
  files.push_back(
      lineOf(machine, "X", InstrumentKind::LaserAngular, Quantity::Angle, Eigen::Vector3d::Zero(), 2));
  const auto two = judgePlan(machine, files);
  ASSERT_TRUE(two);
  EXPECT_THAT(two->told, ElementsAre("EXX", "ECX"));
  EXPECT_GT(two->quality.quality, one->quality.quality);
  EXPECT_EQ(two->quality.sigma.size(), two->quality.asked);
}

TEST(Identify, RefusesNothing) {
  const Machine machine = *kinematics::findBuiltInMachine("linear-stage");
  EXPECT_EQ(identifyQuietly(machine, {}).error().kind, ErrorKind::BadInput);
  Measurement empty =
      lineOf(machine, "X", InstrumentKind::LaserLinear, Quantity::Length, Eigen::Vector3d::Zero());
  for (auto& reading : empty.readings) reading.reset();
  EXPECT_EQ(identifyQuietly(machine, {empty}).error().code, "identify.empty");
}

}  // namespace
}  // namespace nineline::identification
