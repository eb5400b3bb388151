#include <gtest/gtest.h>

#include <cmath>

#include "core/kinematics/machine_file.h"
#include "core/simulation/command_path.h"
#include "tests/support/random_machines.h"

namespace nineline::simulation {
namespace {

using test_support::Random;

/// The count that the turning asks for, from the true radii at both ends.
double plainCount(const Machine& machine, const JointPositions& start, const JointPositions& end,
                  double chord) {
  double samples = 0.0;
  for (int i = 0; i < machine.jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (!machine.isRotary(i)) continue;
    double radius = 0.0;
    for (const JointPositions& q : {start, end}) {
      kinematics::PoseJacobian jacobian;
      static_cast<void>(forwardWithJacobian(machine, q, jacobian));
      radius = std::max(radius, jacobian.col(i).head<3>().norm());
    }
    samples += std::abs(end[k] - start[k]) * std::sqrt(radius / (8.0 * chord));
  }
  return std::max(std::ceil(samples), 1.0);
}

TEST(SampleFractions, TheShortCutOfSmallTurnsGivesTheCountOfTheTrueRadii) {
  Random random(821);
  int single = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const Machine machine = test_support::randomMachine(random, random.whole(2, 6));
    const ErrorModel ideal(machine);
    const JointPositions start = test_support::randomPositions(random, machine);
    JointPositions end = start;
    const double size = std::pow(10.0, random.between(-5.0, -1.0));
    for (int i = 0; i < machine.jointCount(); ++i)
      end[static_cast<std::size_t>(i)] += random.between(-size, size) * (machine.isRotary(i) ? 1.0 : 100.0);
    nc::Motion motion;
    motion.start = start;
    motion.end = end;
    std::vector<double> fractions;
    sampleFractions(ideal, motion, start, end, {}, 0.002, fractions);
    EXPECT_EQ(static_cast<double>(fractions.size()), plainCount(machine, start, end, 0.002)) << trial;
    EXPECT_EQ(fractions.back(), 1.0);
    if (fractions.size() == 1) ++single;
  }
  EXPECT_GT(single, 1000);
  EXPECT_LT(single, 2900);
}

}  // namespace
}  // namespace nineline::simulation
