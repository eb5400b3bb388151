#include "core/identification/squareness.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "core/kinematics/chain.h"

namespace nineline::identification {
namespace {

using Eigen::Vector3d;
using kinematics::Joint;
using kinematics::JointType;
using kinematics::Machine;

Joint joint(char letter, JointType type, const Vector3d& direction) {
  Joint result;
  result.axis = {letter, 0};
  result.type = type;
  result.direction = direction;
  return result;
}

TEST(SlopeFit, FitsALine) {
  // y = 0.5 + 2 q with residuals +1 −2 +1: slope kept, straightness 3, sigma² = 6/1/2
  const Result<SlopeFit> found = fitSlope({-1.0, 0.0, 1.0}, {-0.5, -1.5, 3.5});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->slope, 2.0, 1e-15);
  EXPECT_NEAR(found->intercept, 0.5, 1e-15);
  EXPECT_NEAR(found->straightness, 3.0, 1e-15);
  EXPECT_NEAR(found->sigma_slope, std::sqrt(3.0), 1e-15);
  EXPECT_FALSE(fitSlope({1.0, 1.0}, {0.0, 1.0}));
  EXPECT_FALSE(fitSlope({1.0}, {0.0}));
  EXPECT_FALSE(fitSlope({0.0, 1.0}, {0.0, NAN}));
}

/// Where the carriages of a machine go whose second axis is turned by a location error and whose axes also
/// run askew on their own: the sum of both is the squareness that the runs show.
TEST(Squareness, HasTheSignOfTheLocationErrorInTheChain) {
  constexpr double kAngle = 8e-5, kSlopeOfReference = 3e-5;
  for (int from = 0; from < 3; ++from) {
    for (int to = 0; to < 3; ++to) {
      if (from == to) continue;
      const char reference = static_cast<char>('X' + from), second = static_cast<char>('X' + to);
      Machine::Description description;
      description.id = "two";
      description.tool_chain = {joint(reference, JointType::Linear, Vector3d::Unit(from)),
                                joint(second, JointType::Linear, Vector3d::Unit(to))};
      const Machine machine = Machine::make(description).value();
      const auto placeOf = [&](double first, double other) {
        kinematics::JointDisplacements displaced{};
        displaced[0].moved.translation = kSlopeOfReference * first * Vector3d::Unit(to);
        displaced[1].located.rotation = kAngle * Vector3d::Unit(3 - from - to);
        kinematics::JointPositions q{};
        q[0] = first, q[1] = other;
        return Vector3d(kinematics::bodyPoses(machine, q, displaced)[1].translation());
      };
      std::vector<double> at, of_reference, of_second;
      for (double q = 0.0; q <= 300.0; q += 50.0) {
        at.push_back(q);
        of_reference.push_back(placeOf(q, 0.0)(to));
        of_second.push_back(placeOf(0.0, q)(from));
      }
      const Result<Squareness> found = squarenessOf(reference, second, fitSlope(at, of_reference).value(),
                                                    fitSlope(at, of_second).value());
      ASSERT_TRUE(found);
      // the reference's own slope turns it towards the second axis: away from it, that much less is left
      const bool is_cyclic = (from + 1) % 3 == to;
      EXPECT_NEAR(found->value, kAngle - (is_cyclic ? 1.0 : -1.0) * kSlopeOfReference, 1e-12);
      EXPECT_EQ(found->component[2], second);
      EXPECT_EQ(found->component[0], static_cast<char>('A' + 3 - from - to));
      EXPECT_NEAR(found->between, kPi / 2 + (is_cyclic ? 1.0 : -1.0) * found->value, 1e-12);
    }
  }
}

TEST(Squareness, RefusesOneAxisTwice) {
  EXPECT_FALSE(squarenessOf('X', 'X', {}, {}));
  EXPECT_FALSE(squarenessOf('X', 'C', {}, {}));
}

/// The grinder's chain: Z carries the spindle C, whose direction is tilted; the mandrel in it is tilted too.
TEST(Parallelism, TakesTheMandrelOut) {
  constexpr double kA0C = 4e-5, kB0C = -7e-5, kMandrelX = 2e-4, kMandrelY = -3e-4;
  Machine::Description description;
  description.id = "spindle";
  description.workpiece_chain = {joint('Z', JointType::Linear, Vector3d::UnitZ()),
                                 joint('C', JointType::Rotary, Vector3d::UnitZ())};
  const Machine machine = Machine::make(description).value();
  kinematics::JointDisplacements displaced{};
  displaced[1].located.rotation = {kA0C, kB0C, 0.0};
  const Vector3d mandrel = kinematics::exponential({kMandrelX, kMandrelY, 0.0}) * Vector3d::UnitZ();
  const auto runOf = [&](double turn, int sensitive) {
    std::vector<double> at, readings;
    for (double z = -300.0; z <= -100.0; z += 50.0) {
      kinematics::JointPositions q{};
      q[0] = z, q[1] = turn;
      const Eigen::Isometry3d pose = kinematics::bodyPoses(machine, q, displaced)[1];
      const Vector3d line = pose.linear() * mandrel;
      const double height = (0.0 - pose.translation().z()) / line.z();  // the indicator stands at z = 0
      at.push_back(z);
      readings.push_back((pose.translation() + height * line)(sensitive));
    }
    return fitSlope(at, readings).value();
  };
  const MandrelSlopes slopes{runOf(0.0, 0), runOf(0.0, 1), runOf(kPi, 0), runOf(kPi, 1)};
  const SpindleParallelism found = parallelismOf(slopes, MovingPart::Mandrel);
  EXPECT_NEAR(found.A0C, kA0C, 1e-11);
  EXPECT_NEAR(found.B0C, kB0C, 1e-11);
  EXPECT_NEAR(found.mandrel_about_x, kMandrelX, 1e-11);
  EXPECT_NEAR(found.mandrel_about_y, kMandrelY, 1e-11);
}

}  // namespace
}  // namespace nineline::identification
