#include "core/measurement/reading_gradients.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "core/kinematics/machine_file.h"
#include "tests/core/measurement/set_ups.h"

namespace nineline::measurement {
namespace {

using errors::Slot;
using kinematics::JointDisplacement;
using kinematics::JointDisplacements;
using test_support::Random;

double& parameter(JointDisplacement& displacement, std::size_t slot, Eigen::Index row) {
  errors::SmallMotion& motion = slot == 0   ? displacement.located
                                : slot == 1 ? displacement.standing
                                            : displacement.moved;
  return row < 3 ? motion.translation[row] : motion.rotation[row - 3];
}

/// Largest difference between the analytic gradient and central differences, relative to the lever arms.
double worstGradient(const Machine& machine, const Measurement& measurement,
                     const JointDisplacements& about) {
  const ReadingFunction reading(machine, measurement.instrument, measurement.channels);
  const std::size_t channels = reading.channelCount();
  std::vector<double> gradient(channels * reading.gradientSize());
  std::vector<double> readings(channels), up(channels), down(channels);
  double worst = 0.0;
  for (const Sample& sample : measurement.samples) {
    reading.readWithGradient(sample.q, about, readings, gradient);
    for (std::size_t n = 0; n < reading.gradientSize(); ++n) {
      const Eigen::Index row = static_cast<Eigen::Index>(n % 6);
      const double step = row < 3 ? 1e-3 : 1e-5;
      JointDisplacements varied = about;
      double& value = parameter(varied[n / kGradientPerJoint], n % kGradientPerJoint / 6, row);
      value += step;
      reading.read(sample.q, varied, up);
      value -= 2.0 * step;
      reading.read(sample.q, varied, down);
      for (std::size_t k = 0; k < channels; ++k) {
        const double difference = (up[k] - down[k]) / (2.0 * step);
        const double scale = 1.0 + std::abs(difference);
        worst = std::max(worst, std::abs(gradient[k * reading.gradientSize() + n] - difference) / scale);
      }
    }
  }
  return worst;
}

TEST(ReadingGradients, EqualCentralDifferencesOnRandomMachines) {
  Random random(301);
  for (int k = 0; k < 40; ++k) {
    const Machine machine = test_support::randomMachine(random, random.whole(1, 6));
    const JointDisplacements about =
        test_support::randomDisplacements(random, machine, k % 2 == 0 ? 1e-4 : 0.1);
    for (const Measurement& measurement : everyInstrument(random, machine)) {
      EXPECT_LT(worstGradient(machine, measurement, about), 2e-7)
          << nameOf(measurement.instrument.kind) << ", machine " << k;
      EXPECT_LT(worstGradient(machine, measurement, {}), 2e-7)
          << nameOf(measurement.instrument.kind) << ", ideal machine " << k;
    }
  }
}

TEST(ReadingGradients, ReadingsEqualTheModelsOwnPoses) {
  // The chain of this module against core/kinematics: deviation and ballbar from actualPose.
  Random random(302);
  for (int k = 0; k < 20; ++k) {
    const Machine machine = test_support::randomMachine(random, random.whole(2, 6));
    const ErrorModel model = test_support::randomModel(random, machine);
    Instrument ballbar;
    ballbar.kind = InstrumentKind::Ballbar;
    ballbar.radius = 30.0;
    MachineState state;
    state.q = test_support::randomPositions(random, machine);
    const Eigen::Vector3d actual = model.actualPose(state).tip;
    const Eigen::Vector3d ideal = model.idealPose(state).tip;
    const Result<Prediction> deviation = predict(
        model,
        measurementAt(Instrument{}, {{Quantity::DevX}, {Quantity::DevY}, {Quantity::DevZ}}, {state.q}));
    const Result<Prediction> radius = predict(model, measurementAt(ballbar, {{Quantity::Radius}}, {state.q}));
    ASSERT_TRUE(deviation && radius);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(deviation->readings[c], (actual - ideal)[c], 1e-11);
    EXPECT_NEAR(radius->readings[0], actual.norm() - 30.0, 1e-11);
  }
}

/// What the bodies of core/kinematics say: an independent way to the bed's instruments.
TEST(ReadingGradients, BodiesEqualThoseOfTheChain) {
  Random random(303);
  for (int k = 0; k < 20; ++k) {
    const Machine machine = test_support::randomMachine(random, random.whole(2, 6));
    const JointDisplacements displacements = test_support::randomDisplacements(random, machine);
    for (const Measurement& measurement : everyInstrument(random, machine)) {
      if (measurement.instrument.kind != InstrumentKind::LaserStraightness) continue;
      const auto joint = static_cast<std::size_t>(machine.find(*measurement.instrument.axis));
      const ReadingFunction reading(machine, measurement.instrument, measurement.channels);
      const kinematics::BodyPoses zero = kinematics::bodyPoses(machine, {});
      const Eigen::Isometry3d W = machine.workpieceJointCount() > 0
                                      ? zero[static_cast<std::size_t>(machine.workpieceJointCount() - 1)]
                                      : Eigen::Isometry3d::Identity();
      const Eigen::Vector3d b = zero[joint].inverse() * (W * measurement.instrument.point);
      for (const Sample& sample : measurement.samples) {
        std::vector<double> value(1);
        reading.read(sample.q, displacements, value);
        const Eigen::Vector3d moved = kinematics::bodyPoses(machine, sample.q, displacements)[joint] * b -
                                      kinematics::bodyPoses(machine, sample.q)[joint] * b;
        EXPECT_NEAR(value[0], moved[measurement.instrument.sensitive], 1e-11);
      }
    }
  }
}

TEST(ReadingGradients, ColumnsAreTheEffectsToFirstOrder) {
  Random random(304);
  for (int k = 0; k < 15; ++k) {
    const Machine machine = test_support::randomMachine(random, random.whole(2, 5));
    const ErrorModel model = test_support::randomModel(random, machine);
    for (const Measurement& measurement : everyInstrument(random, machine)) {
      const std::vector<MachineState> states = statesOf(measurement, machine);
      const ReadingGradients gradients = gradientsOf(machine, measurement);
      Eigen::VectorXd sum = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(gradients.rows()));
      for (const errors::EffectPtr& effect : model.effects()) {
        sum += effectColumn(model, effect, measurement, states, gradients);
      }
      const Result<Prediction> exact = predict(model, measurement);
      ASSERT_TRUE(exact);
      const double zero = measurement.instrument.kind == InstrumentKind::Ballbar ? 1.0 : 0.0;
      if (zero > 0.0) {
        const Result<Prediction> ideal = predict(ErrorModel(machine), measurement);
        sum += ideal->readings;
      }
      // Second order: sums of errors of some 1e-4 rad on arms up to a metre.
      EXPECT_LT((sum - exact->readings).cwiseAbs().maxCoeff(), 3e-5)
          << nameOf(measurement.instrument.kind) << ", machine " << k;
    }
  }
}

TEST(ReadingGradients, ColumnOfATableWithAReferencePoint) {
  const std::string about = R"(, "reference_mm": [0, 0, 200])";
  const ErrorModel model =
      modelOf("generic-3axis", constantUm("EXZ", 5, about) + "," + constantArcsec("EBZ", 10));
  const Measurement measurement = measurementAt(Instrument{}, {{Quantity::DevX}}, {{0, 0, 100}});
  const ReadingGradients gradients = gradientsOf(model.machine(), measurement);
  const auto states = statesOf(measurement, model.machine());
  EXPECT_NEAR(effectColumn(model, model.effects()[1], measurement, states, gradients)[0],
              -200.0 * radFromArcsec(10), 1e-12);
  EXPECT_NEAR(
      effectColumn(ErrorModel(model.machine()), model.effects()[1], measurement, states, gradients)[0], 0.0,
      1e-15);
}

}  // namespace
}  // namespace nineline::measurement
