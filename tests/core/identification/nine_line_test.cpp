#include "core/identification/nine_line.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/identification/nine_line_solver.h"
#include "core/kinematics/chain.h"
#include "core/kinematics/machine_file.h"
#include "tests/support/random_machines.h"

namespace nineline::identification {
namespace {

using kinematics::Joint;
using kinematics::JointDisplacements;
using kinematics::JointType;
using kinematics::Machine;
using kinematics::SmallMotion;
using test_support::Random;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

constexpr double kNanometre = 1e-9;  // of the requirement: 1e-9 mm
constexpr double kAngle = 1e-12;     // rad

LineData dataOf(const LineSetup& setup, const std::vector<double>& positions) {
  LineData data;
  data.positions = positions;
  data.readings.assign(setup.readings.size(), std::vector<double>(positions.size()));
  return data;
}

/// What lasers and straightness optics read on a machine whose joint errs: actual minus ideal place of each
/// target in the bed, from the chain itself.
LineData simulate(const Machine& machine, int joint, const LineSetup& setup,
                  const std::vector<double>& positions, const std::vector<SmallMotion>& errors) {
  LineData data = dataOf(setup, positions);
  const auto at = static_cast<std::size_t>(joint);
  for (std::size_t p = 0; p < positions.size(); ++p) {
    kinematics::JointPositions q{};
    q[at] = positions[p];
    JointDisplacements displaced{};
    displaced[at].moved = errors[p];
    const Eigen::Isometry3d actual = kinematics::bodyPoses(machine, q, displaced)[at];
    const Eigen::Isometry3d ideal = kinematics::bodyPoses(machine, q)[at];
    for (std::size_t k = 0; k < setup.readings.size(); ++k) {
      const Vector3d target = setup.readings[k].target;
      data.readings[k][p] = setup.readings[k].direction.dot(actual * target - ideal * target);
    }
  }
  return data;
}

void expectErrors(const LineErrors& found, const SmallMotion& planted, double length, double angle) {
  for (std::size_t row = 0; row < 3; ++row) {
    ASSERT_TRUE(found.value[row] && found.value[row + 3]);
    EXPECT_NEAR(*found.value[row], planted.translation(static_cast<Eigen::Index>(row)), length);
    EXPECT_NEAR(*found.value[row + 3], planted.rotation(static_cast<Eigen::Index>(row)), angle);
  }
}

/// Noiseless readings from the exact kinematics, every linear axis of every built-in machine, errors up to
/// 20 um and 100 urad, the pattern far from the reference point.
TEST(NineLine, FindsEveryErrorOfAnExactSimulation) {
  Random random(17);
  int axes = 0;
  double worst_length = 0.0, worst_angle = 0.0;
  for (const Machine& machine : kinematics::builtInMachines()) {
    for (int joint = 0; joint < machine.jointCount(); ++joint) {
      if (machine.joint(joint).type != JointType::Linear) continue;
      ++axes;
      int along = 0;
      machine.joint(joint).direction.cwiseAbs().maxCoeff(&along);
      for (const LineSet set : {LineSet::Minimal, LineSet::Full}) {
        const LineSetup setup =
            makeNineLineSetup(machine.joint(joint).axis, {along, random.vector(150.0), 300.0, 240.0, set});
        std::vector<double> positions;
        std::vector<SmallMotion> planted;
        for (int p = 0; p < 11; ++p) {
          positions.push_back(-50.0 + 30.0 * p);
          planted.push_back({random.vector(0.02), random.vector(1e-4)});
        }
        const LineData data = simulate(machine, joint, setup, positions, planted);
        const Result<LineReport> found = identifyLines(setup, data);
        ASSERT_TRUE(found) << found.error().text;
        EXPECT_EQ(found->rank, found->unknowns);
        for (std::size_t p = 0; p < positions.size(); ++p) {
          expectErrors(found->positions[p], planted[p], kNanometre, kAngle);
          for (Eigen::Index row = 0; row < 3; ++row) {
            const auto at = static_cast<std::size_t>(row);
            worst_length = std::max(worst_length,
                                    std::abs(*found->positions[p].value[at] - planted[p].translation(row)));
            worst_angle = std::max(worst_angle,
                                   std::abs(*found->positions[p].value[at + 3] - planted[p].rotation(row)));
          }
        }
      }
    }
  }
  EXPECT_GE(axes, 15);
  std::printf("%d axes, worst %.2e mm, %.2e rad\n", axes, worst_length, worst_angle);
}

/// What the first-order form leaves is the square of the angles times the lever.
TEST(NineLine, FirstOrderLeavesTheSquareOfTheAngles) {
  const Machine machine = kinematics::loadMachine("linear-stage").value();
  const LineSetup setup =
      makeNineLineSetup(machine.joint(0).axis, {0, {300, 200, 100}, 300.0, 300.0, LineSet::Full});
  const std::vector<SmallMotion> planted{{{0.01, -0.02, 0.01}, {1e-4, -2e-4, 1.5e-4}}};
  const LineData data = simulate(machine, 0, setup, {100.0}, planted);
  const LineReport first = identifyLines(setup, data, LineMethod::FirstOrder).value();
  const double left = std::abs(*first.positions[0].value[0] - planted[0].translation.x());
  EXPECT_GT(left, 1e-7);
  EXPECT_LT(left, 2.0 * planted[0].rotation.squaredNorm() * 400.0);
  expectErrors(identifyLines(setup, data).value().positions[0], planted[0], kNanometre, kAngle);
}

/// An axis that carries another machine's errors at the datum: only what changes from there is seen.
TEST(NineLine, TakesErrorsFromTheDatum) {
  const LineSetup setup = makeNineLineSetup({'X', 0}, {0, {10, 20, 30}, 300.0, 300.0, LineSet::Full});
  LineData data = dataOf(setup, {0.0, 100.0});
  const SmallMotion planted{{1e-3, 2e-3, -1e-3}, {1e-5, 2e-5, -3e-5}};
  const std::vector<double> readings = predictLines(setup, planted.translation, planted.rotation);
  for (std::size_t k = 0; k < readings.size(); ++k) {
    data.readings[k][0] = 0.1 * static_cast<double>(k);  // wherever the instrument's zero was
    data.readings[k][1] = 0.1 * static_cast<double>(k) + readings[k];
  }
  data.datum = 0;
  const LineReport found = identifyLines(setup, data).value();
  expectErrors(found.positions[1], planted, 1e-12, 1e-14);
  // a zero that was itself read adds its own variance: √2 of the sigma without a datum
  data.datum.reset();
  data.readings.assign(9, std::vector<double>(2, 0.0));
  const LineReport plain = identifyLines(setup, data).value();
  EXPECT_NEAR(*found.positions[1].sigma[3] / *plain.positions[1].sigma[3], std::sqrt(2.0), 0.2);
}

TEST(NineLine, GradientsAgreeWithDifferences) {
  Random random(4);
  for (const LineMethod method : {LineMethod::Exact, LineMethod::FirstOrder}) {
    for (int trial = 0; trial < 20; ++trial) {
      const LineReading reading{random.vector(300.0), random.unitVector(), 1e-3, 1, -1};
      SixErrors errors;
      errors << random.vector(0.1), random.vector(0.3);
      const Eigen::Matrix<double, 1, 6> gradient = readingGradient(reading, errors, method);
      for (Eigen::Index row = 0; row < 6; ++row) {
        const double step = 1e-5;
        SixErrors above = errors, below = errors;
        above(row) += step, below(row) -= step;
        const double difference =
            (predictReading(reading, above, method) - predictReading(reading, below, method)) / (2.0 * step);
        EXPECT_NEAR(gradient(row), difference, 1e-6);
      }
    }
  }
}

/// Standard uncertainties of theory.md, 2.1 for L = 300, 0.5 um and 1 um.
TEST(NineLine, HasTheUncertaintiesOfTheTheory) {
  const double root2 = std::sqrt(2.0);
  for (int along = 0; along < 3; ++along) {
    const auto a = static_cast<std::size_t>(along), b = static_cast<std::size_t>((along + 1) % 3);
    const LineSetup six = makeNineLineSetup({static_cast<char>('X' + along), 0},
                                            {along, Vector3d::Zero(), 300.0, 300.0, LineSet::Minimal});
    const LineSetup nine = makeNineLineSetup({static_cast<char>('X' + along), 0},
                                             {along, Vector3d::Zero(), 300.0, 300.0, LineSet::Full});
    const LineReport of_six = identifyLines(six, dataOf(six, {0.0})).value();
    const LineReport of_nine = identifyLines(nine, dataOf(nine, {0.0})).value();
    EXPECT_NEAR(*of_six.positions[0].sigma[a], 0.5e-3, 1e-12);
    EXPECT_NEAR(*of_six.positions[0].sigma[b], 1e-3, 1e-12);
    EXPECT_NEAR(*of_six.positions[0].sigma[3 + b], root2 * 0.5e-3 / 300.0, 1e-14);
    EXPECT_NEAR(*of_six.positions[0].sigma[3 + a], root2 * 1e-3 / 300.0, 1e-14);
    EXPECT_NEAR(*of_nine.positions[0].sigma[b], std::sqrt(5.0 / 12.0) * 1e-3, 1e-12);
    EXPECT_NEAR(*of_nine.positions[0].sigma[3 + a], std::sqrt(3.0) / 2.0 * 1e-3 / 300.0, 1e-14);
    EXPECT_EQ(of_nine.positions[0].freedom, 3);
  }
}

TEST(NineLine, NamesWhatTheLinesDoNotTell) {
  // three displacement lines alone: positioning, pitch and yaw
  LineSetup lengths = makeNineLineSetup({'Y', 0}, {1, Vector3d::Zero(), 300.0, 300.0, LineSet::Full});
  std::erase_if(lengths.readings, [](const LineReading& one) { return one.direction.y() == 0.0; });
  const LineReport found = identifyLines(lengths, dataOf(lengths, {0.0, 50.0})).value();
  EXPECT_THAT(found.unobservable, UnorderedElementsAre("EXY", "EZY", "EBY"));
  EXPECT_EQ(found.rank, 6);
  EXPECT_TRUE(found.positions[1].value[1] && found.positions[1].value[3] && found.positions[1].value[5]);
  EXPECT_FALSE(found.positions[1].value[0] || found.positions[1].value[4]);
  // lines in one plane leave the same angle open twice over
  LineSetup flat = makeNineLineSetup({'X', 0}, {0, Vector3d::Zero(), 300.0, 300.0, LineSet::Full});
  std::erase_if(flat.readings, [](const LineReading& one) { return one.line == 3; });
  EXPECT_THAT(identifyLines(flat, dataOf(flat, {0.0})).value().unobservable, ElementsAre("EBX"));
}

/// Straightness references of unknown inclination: what they hide is named and given without slope; the rest
/// is found; planted inclinations do not harm it.
TEST(NineLine, NamesSlopesThatReferencesHide) {
  Random random(8);
  for (const auto& [inclination, hidden] :
       {std::pair{StraightnessInclination::EachLine, std::vector<std::string>{"EYX", "EZX", "EAX"}},
        std::pair{StraightnessInclination::EachDirection, std::vector<std::string>{"EYX", "EZX"}}}) {
    for (const LineSet set : {LineSet::Minimal, LineSet::Full}) {
      const LineSetup setup = makeNineLineSetup({'X', 0}, {0, {5, 10, -20}, 300.0, 200.0, set, inclination});
      LineData data = dataOf(setup, {});
      std::vector<SmallMotion> planted;
      for (int p = 0; p < 11; ++p) {
        const double q = 30.0 * p, u = q / 300.0, bow = u * (1.0 - u);
        data.positions.push_back(q);
        planted.push_back({{1e-5 * q, 4e-3 * bow, -3e-3 * bow}, {2e-5 * bow, 1e-5 * u, -3e-5 * u * u}});
        const bool roll_has_slope = inclination == StraightnessInclination::EachDirection;
        if (roll_has_slope) planted.back().rotation.x() += 4e-5 * u;
      }
      for (std::size_t k = 0; k < setup.readings.size(); ++k) {
        const double tilt = setup.readings[k].reference < 0 ? 0.0 : 1e-5 * (1 + setup.readings[k].reference);
        for (std::size_t p = 0; p < planted.size(); ++p) {
          data.readings[k].push_back(predictLines(setup, planted[p].translation, planted[p].rotation)[k] +
                                     tilt * data.positions[p]);
        }
      }
      data.datum = 0;
      const Result<LineReport> found = identifyLines(setup, data);
      ASSERT_TRUE(found) << found.error().text;
      EXPECT_EQ(found->slope_unobservable, hidden);
      EXPECT_EQ(found->unknowns - found->rank, static_cast<int>(hidden.size()));
      for (const LineErrors& here : found->positions) {
        const double u = here.position / 300.0;
        EXPECT_NEAR(*here.value[0], 1e-5 * here.position, 1e-9);
        // a hidden roll slope turns the other errors at second order: 1e-5 rad · 1e-5 rad, times the lever
        const double angle = hidden.size() == 3 ? 1e-10 : 1e-12;
        EXPECT_NEAR(*here.value[4], 1e-5 * u, angle);
        EXPECT_NEAR(*here.value[5], -3e-5 * u * u, angle);
      }
      // the bow comes back less its own mean slope through the datum, Σ q bow / Σ q²
      double qb = 0.0, qq = 0.0;
      for (int p = 0; p < 11; ++p) qb += p * (p / 10.0) * (1.0 - p / 10.0), qq += p * p;
      for (std::size_t p = 0; p < 11; ++p) {
        const double u = static_cast<double>(p) / 10.0;
        EXPECT_NEAR(*found->positions[p].value[1], 4e-3 * (u * (1.0 - u) - qb / qq * static_cast<double>(p)),
                    hidden.size() == 3 ? 1e-8 : 1e-9);
      }
    }
  }
}

TEST(NineLine, RefusesWhatItCannotSolve) {
  const LineSetup setup = makeNineLineSetup({'X', 0}, {});
  LineData data = dataOf(setup, {0.0, 1.0});
  data.readings[4][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(identifyLines(setup, data).error().text.find("Reading 5 at position 2"), std::string::npos);
  data.readings.pop_back();
  EXPECT_FALSE(identifyLines(setup, data));
  EXPECT_FALSE(identifyLines({}, {}));
  LineData beyond = dataOf(setup, {0.0});
  beyond.datum = 1;
  EXPECT_FALSE(identifyLines(setup, beyond));
  // inclinations over lines that leave more open than slopes
  LineSetup poor = makeNineLineSetup(
      {'X', 0}, {0, Vector3d::Zero(), 300, 300, LineSet::Full, StraightnessInclination::EachLine});
  std::erase_if(poor.readings, [](const LineReading& one) { return one.line != 1; });
  EXPECT_EQ(identifyLines(poor, dataOf(poor, {0.0, 1.0, 2.0})).error().code, "lines.open");
}

TEST(NineLine, NamesErrorsTwice) {
  EXPECT_EQ(motionErrorName({'Z', 0}, 1).iso, "EYZ");
  EXPECT_EQ(motionErrorName({'Z', 0}, 1).paper, "δy(z)");
  EXPECT_EQ(motionErrorName({'X', 0}, 5).iso, "ECX");
  EXPECT_EQ(motionErrorName({'X', 0}, 5).paper, "εz(x)");
}

TEST(ChiSquare, HasTheKnownTails) {
  EXPECT_NEAR(chiSquareTail(16.266236, 3), 1e-3, 1e-9);  // the theory's 16.3
  EXPECT_NEAR(chiSquareTail(3.841459, 1), 0.05, 1e-7);
  EXPECT_NEAR(chiSquareTail(9.487729, 4), 0.05, 1e-7);
  EXPECT_NEAR(chiSquareTail(18.307038, 10), 0.05, 1e-7);
  EXPECT_NEAR(chiSquareTail(24.995790, 15), 0.05, 1e-7);
  EXPECT_EQ(chiSquareTail(0.0, 3), 1.0);
}

}  // namespace
}  // namespace nineline::identification
