#include "core/postprocessing/pose_solver.h"

#include <gtest/gtest.h>

#include "core/kinematics/chain.h"
#include "core/kinematics/machine_file.h"
#include "core/postprocessing/branches.h"
#include "tests/support/random_machines.h"

namespace nineline::postprocessing {
namespace {

using kinematics::builtInMachines;
using kinematics::findBuiltInMachine;

TEST(TipAxisChain, IsTheForwardMapOfTheKinematics) {
  test_support::Random random(11);
  for (int round = 0; round < 200; ++round) {
    const Machine machine = test_support::randomMachine(random, random.whole(1, 9));
    const JointPositions q = test_support::randomPositions(random, machine);
    kinematics::PoseJacobian wanted;
    const kinematics::ToolPose pose = kinematics::forwardWithJacobian(machine, q, wanted);
    TipAxisJacobian jacobian;
    const TipAxis found = TipAxisChain(machine).at(q, jacobian);
    EXPECT_LT((found.tip - pose.tip).norm(), 1e-11);
    EXPECT_LT((found.axis - pose.axis).norm(), 1e-14);
    for (int i = 0; i < machine.jointCount(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      EXPECT_LT((jacobian.tip[k] - wanted.col(i).head<3>()).norm(), 1e-11);
      EXPECT_LT((jacobian.turn[k] - wanted.col(i).tail<3>()).norm(), 1e-14);
    }
  }
}

TEST(PoseSolver, FindsThePositionsAgain) {
  test_support::Random random(12);
  for (const char* id : {"trunnion-ac", "head-head-bc", "table-head-bc", "propeller-c2zxc1b1"}) {
    const Machine& machine = *findBuiltInMachine(id);
    const PoseSolver solver(machine);
    for (int round = 0; round < 100; ++round) {
      JointPositions q{};
      for (int i = 0; i < machine.jointCount(); ++i)
        q[static_cast<std::size_t>(i)] =
            machine.isRotary(i) ? random.between(0.2, 1.4) : random.between(100, 300);
      JointPositions start = q;
      for (int i = 0; i < machine.jointCount(); ++i)
        start[static_cast<std::size_t>(i)] += machine.isRotary(i) ? random.between(-0.05, 0.05) : 5.0;
      const Solution solution = solver.solve(solver.chain().at(q), start);
      ASSERT_TRUE(solution.converged) << id;
      EXPECT_LE(solution.iterations, 6) << id;
      for (int i = 0; i < machine.jointCount(); ++i) {
        const auto k = static_cast<std::size_t>(i);
        EXPECT_NEAR(solution.q[k], q[k], machine.isRotary(i) ? 1e-10 : 1e-8) << id;
      }
    }
  }
}

TEST(PoseSolver, ATinyC1IsNotSingular) {  // errata E14
  const PoseSolver solver(*findBuiltInMachine("propeller-c2zxc1b1"));
  for (double c1 = 0.1; c1 > 1e-10; c1 *= 0.1) {
    const JointPositions q = {0.4, 30.0, 900.0, c1, 0.7};
    JointPositions start = q;
    start[0] += 0.01;
    start[3] += 0.02;
    const Solution solution = solver.solve(solver.chain().at(q), start);
    ASSERT_TRUE(solution.converged);
    EXPECT_NEAR(solution.q[3], c1, 1e-12);
  }
}

TEST(PoseSolver, GoesOnThroughSingularPasses) {  // theory.md, 4.6: the inner angle passes a closest value
  const PoseSolver solver(*findBuiltInMachine("trunnion-ac"));
  for (const double closest : {1e-1, 1e-3, 1e-5, 1e-7, 1e-9}) {
    const auto poseAt = [closest](double s) {
      const Vector3d axis(s * 0.3, closest, 1.0);
      return TipAxis{{100.0 * s, 20.0, 5.0}, axis.normalized()};
    };
    TipAxis before = poseAt(-1.0);
    const std::vector<JointPositions> branches = findBranches(solver, before, {});
    ASSERT_EQ(branches.size(), 2U);
    JointPositions q = branches[0];
    for (int i = 1; i <= 200; ++i) {
      const TipAxis target = poseAt(-1.0 + 0.01 * i);
      const Solution solution = solver.follow(before, q, target);
      ASSERT_TRUE(solution.converged) << closest << " at " << i;
      EXPECT_LE(solution.tip_error, 1e-9);
      EXPECT_LE(solution.axis_error, 1e-10);
      q = solution.q;
      before = target;
    }
    EXPECT_LT(std::abs(q[1] - branches[0][1]), 3.5) << "no winding, " << closest;
  }
}

TEST(Branches, ARedundantChainMovesLeast) {
  Machine::Description description = findBuiltInMachine("propeller-c2zxc1b1")->description();
  kinematics::Joint y;
  y.axis = {'Y', 0};
  y.direction = Vector3d::UnitY();
  description.tool_chain.insert(description.tool_chain.begin(), y);
  const PoseSolver solver(Machine::make(description).value());
  ASSERT_TRUE(solver.isRedundant());
  const JointPositions q = {0.1, 20.0, 30.0, 800.0, 0.3, 0.5};
  TipAxis target = solver.chain().at(q);
  target.tip += Vector3d(1.0, -2.0, 0.5);
  const Solution solution = solver.solve(target, q);
  ASSERT_TRUE(solution.converged);
  // The answer is the point of the solution set nearest to the start, to second order: moving along the null
  // direction of the Jacobian must not bring it nearer.
  JointPositions held = q;
  held[0] = solution.q[0] + 0.01;
  PoseSolver other = solver;
  other.hold(1U);
  const Solution neighbour = other.solve(target, held);
  ASSERT_TRUE(neighbour.converged);
  const auto distance = [&](const JointPositions& p) {
    double sum = 0.0;
    for (int i = 0; i < 6; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const double scale = solver.machine().isRotary(i) ? 100.0 : 1.0;
      sum += scale * scale * (p[k] - q[k]) * (p[k] - q[k]);
    }
    return sum;
  };
  EXPECT_LT(distance(solution.q), distance(neighbour.q));
}

TEST(Branches, NothingReachesAnAxisOutsideTheCone) {
  Machine::Description description = findBuiltInMachine("head-head-bc")->description();
  description.tool_chain[4].direction = Vector3d(0, 1, 1).normalized();  // a nutating head reaches 90° only
  const PoseSolver solver(Machine::make(description).value());
  EXPECT_TRUE(findBranches(solver, {{0, 0, 0}, {0.6, 0.0, -0.8}}, {}).empty());
  EXPECT_EQ(findBranches(solver, {{0, 0, 0}, {0.6, 0.0, 0.8}}, {}).size(), 2U);
}

}  // namespace
}  // namespace nineline::postprocessing
