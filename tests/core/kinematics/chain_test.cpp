#include "core/kinematics/chain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/base/units.h"
#include "core/kinematics/machine_file.h"
#include "tests/support/random_machines.h"

namespace nineline::kinematics {
namespace {

using test_support::Random;

constexpr double kRoundOff = 1e-12;  // mm

Matrix3d turn(int axis, double angle) { return rotationAbout(Vector3d::Unit(axis), angle); }

TEST(Forward, GrinderByHand) {
  // Table at z = 100, work turned a quarter: the wheel at x = 30 stands at -z in W, on the work's -y side.
  const Machine& machine = *findBuiltInMachine("b2-k3032");
  const ToolPose pose = forward(machine, {100.0, kPi / 2, 30.0});
  EXPECT_LT((pose.tip - Vector3d(0.0, -30.0, -100.0)).norm(), kRoundOff);
  EXPECT_LT((pose.R_WP - turn(2, -kPi / 2)).norm(), kRoundOff);
  EXPECT_LT((pose.axis - Vector3d::UnitZ()).norm(), kRoundOff);
}

TEST(Forward, ControlCoordinatesOfAMillAreWorkpieceCoordinates) {
  const ToolPose pose = forward(*findBuiltInMachine("generic-3axis"), {7.0, 5.0, -3.0});  // Y X Z
  EXPECT_EQ(pose.tip, Vector3d(5.0, 7.0, -3.0));
}

TEST(Forward, TrunnionAgreesWithItsClosedForm) {
  // theory.md, 5.1 eq. 13 with all centres in the origin: p = Rz(C) Rx(A) P, K = (sA sC, -sA cC, cA).
  Random random(21);
  for (int k = 0; k < 20; ++k) {
    const JointPositions q = randomPositions(random, *findBuiltInMachine("trunnion-ac"));
    const double A = q[0], C = q[1];
    const ToolPose pose = forward(*findBuiltInMachine("trunnion-ac"), q);
    EXPECT_LT((pose.tip - turn(2, C) * turn(0, A) * Vector3d(q[2], q[3], q[4])).norm(), kRoundOff);
    const Vector3d axis(std::sin(A) * std::sin(C), -std::sin(A) * std::cos(C), std::cos(A));
    EXPECT_LT((pose.axis - axis).norm(), kRoundOff);
  }
}

TEST(Forward, PropellerAgreesWithItsClosedForm) {
  // theory.md, 4.7: Q = (x cos C2, x sin C2, z + LC) - LT K with K from C1 + C2 and B1.
  Random random(22);
  const Machine& machine = *findBuiltInMachine("propeller-c2zxc1b1");
  for (int k = 0; k < 20; ++k) {
    const JointPositions q = randomPositions(random, machine);
    const double c2 = q[0], z = q[1], x = q[2], c1 = q[3], b = q[4];
    const Vector3d K(std::sin(b) * std::cos(c1 + c2), std::sin(b) * std::sin(c1 + c2), std::cos(b));
    const Vector3d pivot(x * std::cos(c2), x * std::sin(c2), z + 150.0);
    const ToolPose pose = forward(machine, q);
    EXPECT_LT((pose.axis - K).norm(), kRoundOff);
    EXPECT_LT((pose.tip - (pivot - 420.0 * K)).norm(), 4e-12);
  }
}

TEST(Forward, ZeroDisplacementsChangeNothing) {
  Random random(23);
  for (const Machine& machine : builtInMachines()) {
    const JointPositions q = randomPositions(random, machine);
    EXPECT_EQ(forward(machine, q).tip, forward(machine, q, JointDisplacements{}).tip) << machine.id();
  }
}

TEST(Forward, AxisAlignedJointsTakeAShortCutWithTheSameResult) {
  // The machine turned as a whole by an odd rotation takes the general path.
  Random random(24);
  for (int k = 0; k < 30; ++k) {
    const Machine machine = test_support::randomMachine(random, 6);
    const Matrix3d R = exponential(random.vector(1.0));
    Machine::Description turned = machine.description();
    for (auto* chain : {&turned.workpiece_chain, &turned.tool_chain}) {
      for (Joint& joint : *chain) {
        joint.direction = R * joint.direction;
        joint.offset = R * joint.offset;
      }
    }
    turned.tool_tip = R * turned.tool_tip;
    turned.tool_axis = R * turned.tool_axis;
    const JointPositions q = randomPositions(random, machine);
    const ToolPose straight = forward(machine, q);
    const ToolPose odd = forward(Machine::make(turned).value(), q);
    EXPECT_LT((odd.tip - R * straight.tip).norm(), 1e-11);
    EXPECT_LT((odd.axis - R * straight.axis).norm(), 1e-13);
  }
}

TEST(Forward, ADirectionBesideABedAxisIsNoBedAxis) {
  Machine::Description description;
  Joint joint;
  joint.axis = {'A', 0};
  joint.type = JointType::Rotary;
  joint.direction = {1.0, 1e-9, 0.0};  // of length 1 in double precision
  description.tool_chain = {joint};
  description.tool_tip = {1e6, 0.0, 0.0};
  const ToolPose pose = forward(Machine::make(description).value(), {kPi / 2});
  EXPECT_NEAR(pose.tip.z(), -1e-3, 1e-9);  // (1, ε, 0) × (1e6, 0, 0) = (0, 0, −ε 1e6)
}

TEST(Forward, DisplacementsActInTheirSlotsByHand) {
  Machine::Description description;
  Joint joint;
  joint.axis = {'C', 0};
  joint.type = JointType::Rotary;
  joint.direction = Vector3d::UnitZ();
  joint.offset = {100.0, 0.0, 0.0};
  description.tool_chain = {joint};
  description.tool_tip = {10.0, 0.0, 0.0};
  const Machine machine = Machine::make(description).value();
  const JointPositions q = {kPi / 2};
  JointDisplacements d;
  d[0].moved.translation = {0.01, 0.0, 0.0};  // turns along: becomes +y
  EXPECT_LT((forward(machine, q, d).tip - Vector3d(100.0, 10.01, 0.0)).norm(), kRoundOff);
  d = {};
  d[0].standing.translation = {0.01, 0.0, 0.0};  // stands: stays +x
  EXPECT_LT((forward(machine, q, d).tip - Vector3d(100.01, 10.0, 0.0)).norm(), kRoundOff);
  d = {};
  d[0].located.rotation = {1e-3, 2e-3, 0.0};  // Rx(a) Ry(b), about the joint's origin
  const Vector3d arm = turn(0, 1e-3) * turn(1, 2e-3) * Vector3d(0.0, 10.0, 0.0);
  EXPECT_LT((forward(machine, q, d).tip - Vector3d(100.0, 0.0, 0.0) - arm).norm(), kRoundOff);
  d = {};
  d[0].moved.rotation = {0.0, 0.0, 1e-3};
  const Vector3d linear(100.0 - 10.0 * 1e-3, 10.0, 0.0);
  EXPECT_LT((forward(machine, q, d, RotationModel::FirstOrder).tip - linear).norm(), kRoundOff);
}

/// Pose derivatives by central differences.
PoseJacobian differences(const std::function<ToolPose(const JointPositions&)>& pose, const JointPositions& q,
                         const Machine& machine) {
  PoseJacobian jacobian(6, machine.jointCount());
  for (int i = 0; i < machine.jointCount(); ++i) {
    const double h = machine.isRotary(i) ? 1e-5 : 1e-2;
    JointPositions low = q, high = q;
    low[static_cast<std::size_t>(i)] -= h;
    high[static_cast<std::size_t>(i)] += h;
    const ToolPose a = pose(low), b = pose(high);
    jacobian.col(i).head<3>() = (b.tip - a.tip) / (2.0 * h);
    jacobian.col(i).tail<3>() = logarithm(b.R_WP * a.R_WP.transpose()) / (2.0 * h);
  }
  return jacobian;
}

TEST(Jacobian, AgreesWithCentralDifferencesOnRandomMachines) {
  Random random(25);
  for (int k = 0; k < 50; ++k) {
    const Machine machine = test_support::randomMachine(random, 2 + k % 8);
    const JointPositions q = randomPositions(random, machine);
    PoseJacobian jacobian;
    const ToolPose pose = forwardWithJacobian(machine, q, jacobian);
    EXPECT_EQ(pose.tip, forward(machine, q).tip);
    const PoseJacobian expected =
        differences([&](const JointPositions& at) { return forward(machine, at); }, q, machine);
    EXPECT_LT((jacobian - expected).cwiseAbs().maxCoeff(), 2e-6) << "machine " << k;
  }
}

TEST(Jacobian, OfTheDisplacedToolAgreesWithCentralDifferences) {
  Random random(26);
  for (int k = 0; k < 20; ++k) {
    const Machine machine = test_support::randomMachine(random, 2 + k % 8);
    const JointPositions q = randomPositions(random, machine);
    const JointDisplacements d = test_support::randomDisplacements(random, machine, 0.1);
    PoseJacobian jacobian;
    (void)forwardWithJacobian(machine, q, d, jacobian);
    const PoseJacobian expected =
        differences([&](const JointPositions& at) { return forward(machine, at, d); }, q, machine);
    EXPECT_LT((jacobian - expected).cwiseAbs().maxCoeff(), 2e-6) << "machine " << k;
  }
}

TEST(BodyPoses, CarryTheToolAndTheWorkpiece) {
  Random random(27);
  for (const Machine& machine : builtInMachines()) {
    const JointPositions q = randomPositions(random, machine);
    const BodyPoses poses = bodyPoses(machine, q);
    const int w = machine.workpieceJointCount() - 1, t = machine.jointCount() - 1;
    Eigen::Isometry3d T_MW = Eigen::Isometry3d::Identity(), T_MP = T_MW;
    if (w >= 0) T_MW = poses[static_cast<std::size_t>(w)];
    if (t > w) T_MP = poses[static_cast<std::size_t>(t)];
    EXPECT_LT((T_MW.inverse() * (T_MP * machine.toolTip()) - forward(machine, q).tip).norm(), 4e-12)
        << machine.id();
  }
}

}  // namespace
}  // namespace nineline::kinematics
