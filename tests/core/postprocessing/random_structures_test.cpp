// Machines that nobody built: random chains of five to seven axes, poses inside their travel.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <chrono>
#include <cmath>

#include "core/base/units.h"
#include "core/kinematics/chain.h"
#include "core/postprocessing/branches.h"
#include "core/postprocessing/path_plan.h"
#include "tests/support/random_machines.h"

namespace nineline::postprocessing {
namespace {

using kinematics::Joint;
using kinematics::JointType;
using test_support::Random;

Vector3d randomDirection(Random& random) {
  if (random.whole(0, 2) == 0) return random.unitVector();  // inclined
  return (random.whole(0, 1) == 1 ? 1.0 : -1.0) * Vector3d::Unit(random.whole(0, 2));
}

Joint randomJoint(Random& random, JointType type, int number) {
  static constexpr std::string_view kLetters = "XYZUVWABC";
  Joint joint;
  joint.axis = {kLetters[static_cast<std::size_t>(number)], 0};
  joint.type = type;
  joint.direction = randomDirection(random);
  joint.offset = random.vector(150.0);
  if (type == JointType::Linear) {
    const double reach = random.between(200.0, 800.0);
    joint.travel = kinematics::Travel{-reach, random.between(200.0, 800.0)};
  } else if (random.whole(0, 2) == 0) {
    joint.continuous = true;
  } else {
    joint.travel =
        kinematics::Travel{-radFromDeg(random.between(40.0, 370.0)), radFromDeg(random.between(40.0, 370.0))};
  }
  return joint;
}

JointPositions positionsInside(Random& random, const Machine& machine) {
  JointPositions q{};
  for (int j = 0; j < machine.jointCount(); ++j) {
    const Joint& joint = machine.joint(j);
    const kinematics::Travel travel =
        joint.travel && !joint.continuous ? *joint.travel : kinematics::Travel{-kPi, kPi};
    q[static_cast<std::size_t>(j)] = random.between(travel.low, travel.high);
  }
  return q;
}

/// A chain of 5…7 joints, two to four of them rotary, that can reach tips and axes in five dimensions.
Machine randomStructure(Random& random) {
  for (;;) {
    const int count = random.whole(5, 7);
    const int rotary = random.whole(2, count == 5 ? 3 : 4);
    std::vector<JointType> types(static_cast<std::size_t>(count), JointType::Linear);
    std::fill_n(types.begin(), rotary, JointType::Rotary);
    for (std::size_t k = types.size(); k > 1; --k)
      std::swap(types[k - 1], types[static_cast<std::size_t>(random.whole(0, static_cast<int>(k) - 1))]);
    Machine::Description description;
    description.id = "random";
    for (int j = 0; j < count; ++j) {
      auto& chain = random.whole(0, 1) == 1 ? description.workpiece_chain : description.tool_chain;
      chain.push_back(randomJoint(random, types[static_cast<std::size_t>(j)], j));
    }
    description.tool_tip = random.vector(200.0);
    description.tool_axis = random.whole(0, 1) == 1 ? Vector3d::UnitZ() : random.unitVector();
    const Machine machine = Machine::make(description).value();
    const PoseSolver solver(machine);
    int open = 0;
    for (int n = 0; n < 20; ++n) open += solver.opennessAt(positionsInside(random, machine)) > 0.05 ? 1 : 0;
    if (open >= 12) return machine;
  }
}

struct Tally {
  int poses = 0;
  int missed = 0;
  int near_singular = 0;
  double worst_tip = 0.0;
  double worst_axis = 0.0;
};

void tryPose(const Machine& machine, const PoseSolver& solver, const JointPositions& q, Tally& tally) {
  const kinematics::ToolPose pose = kinematics::forward(machine, q);
  ClPoint point;
  point.tip = pose.tip;
  point.axis = pose.axis;
  NoProgress progress;
  const Result<PathPlan> plan = planPath(solver, {point}, homeOf(machine), {}, progress);
  ++tally.poses;
  tally.near_singular += solver.opennessAt(q) < 0.01 ? 1 : 0;
  if (!plan) {
    ++tally.missed;
    std::string where;
    for (int j = 0; j < machine.jointCount(); ++j)
      where += " " + std::to_string(q[static_cast<std::size_t>(j)]);
    ADD_FAILURE() << machine.jointCount() << " joints: " << plan.error().message() << "\nopenness "
                  << solver.opennessAt(q) << ", from" << where;
    return;
  }
  const kinematics::ToolPose found = kinematics::forward(machine, plan->points[0].q);
  EXPECT_LT(machine.firstOutsideTravel(plan->points[0].q), 0);
  tally.worst_tip = std::max(tally.worst_tip, (found.tip - pose.tip).norm());
  tally.worst_axis = std::max(tally.worst_axis, angleBetween(found.axis, pose.axis));
}

void tryStructures(int structures, int poses, unsigned seed) {
  Random random(seed);
  Tally tally;
  const auto start = std::chrono::steady_clock::now();
  for (int s = 0; s < structures; ++s) {
    const Machine machine = randomStructure(random);
    const PoseSolver solver(machine);
    for (int p = 0; p < poses; ++p) tryPose(machine, solver, positionsInside(random, machine), tally);
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::printf("%d structures, %d poses (%d near singular), %d missed; residual %.1e mm %.1e rad; %.1f s\n",
              structures, tally.poses, tally.near_singular, tally.missed, tally.worst_tip, tally.worst_axis,
              seconds);
  EXPECT_EQ(tally.missed, 0);
  EXPECT_LE(tally.worst_tip, 1e-9);
  EXPECT_LE(tally.worst_axis, 1e-10);
}

TEST(RandomStructures, EveryPoseInsideTheTravelIsSolved) { tryStructures(150, 10, 5); }

// The campaign: --gtest_also_run_disabled_tests --gtest_filter=RandomStructures.*
TEST(RandomStructures, DISABLED_AThousandStructuresOfAHundredPoses) { tryStructures(1000, 100, 2026); }

}  // namespace
}  // namespace nineline::postprocessing
