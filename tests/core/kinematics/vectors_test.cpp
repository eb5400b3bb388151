// The vectors A1, D1, D4, D5 and D7 of ../shared/vectors, to the tolerances of their README.
#include <gtest/gtest.h>

#include "core/kinematics/inverse.h"
#include "core/kinematics/machine_file.h"
#include "tests/support/vector_table.h"

namespace nineline::kinematics {
namespace {

using test_support::readVectors;
using test_support::VectorRow;

constexpr double kLength = 1e-10;  // mm
constexpr double kAngle = 1e-12;   // rad

class KinematicsVectors : public testing::Test {
 protected:
  void SetUp() override {
    if (!test_support::haveVectors())
      GTEST_SKIP() << test_support::vectorFolder() << " is not there: vectors not compared";
  }
};

TEST_F(KinematicsVectors, A1Rotations) {
  const std::vector<VectorRow> rows = readVectors("A1_so3.csv");
  ASSERT_FALSE(rows.empty());
  for (const VectorRow& row : rows) {
    const Vector3d e = row.vector("e", "_rad");
    const Matrix3d exact = exponential(e);
    const Matrix3d zyx = rotationAbout(Vector3d::UnitZ(), e.z()) * rotationAbout(Vector3d::UnitY(), e.y()) *
                         rotationAbout(Vector3d::UnitX(), e.x());
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        const std::string at = std::to_string(i + 1) + std::to_string(k + 1);
        EXPECT_NEAR(exact(i, k), row.number("exp_" + at), 1e-15) << row.text("id");
        EXPECT_NEAR(zyx(i, k), row.number("zyx_" + at), 1e-15) << row.text("id");
      }
    }
    EXPECT_LT((logarithm(zyx) - row.vector("log_zyx_")).norm(), kAngle) << row.text("id");
    const Vector3d rest = (exact - Matrix3d::Identity() - skew(e)) * Vector3d(300.0, -200.0, 100.0);
    EXPECT_NEAR(rest.norm(), row.number("exact_minus_linear_at_300_-200_100_mm"), 1e-13 + 1e-15 * rest.norm())
        << row.text("id");
  }
}

/// The joints of a chain written from workpiece to tool, all of them on the tool's side.
Machine chainMachine(const std::string& name) {
  static constexpr std::string_view kLetters = "XYZUV";
  Machine::Description description;
  description.id = name;
  for (const VectorRow& row : readVectors("D4_machines.csv")) {
    if (row.text("machine") != name) continue;
    if (row.text("kind") == "T") {
      description.tool_tip = row.vector("L_", "_mm");
      continue;
    }
    Joint joint;
    joint.axis = {kLetters[description.tool_chain.size()], 0};
    joint.type = row.text("kind") == "R" ? JointType::Rotary : JointType::Linear;
    joint.direction = row.vector("axis_").normalized();
    joint.offset = row.vector("L_", "_mm");
    description.tool_chain.push_back(joint);
  }
  return Machine::make(description).value();
}

void compareJacobian(const VectorRow& row, const Machine& machine, const JointPositions& q) {
  PoseJacobian jacobian;
  const ToolPose pose = forwardWithJacobian(machine, q, jacobian);
  EXPECT_LT((pose.tip - row.vector("Q_")).norm(), kLength) << row.text("id");
  EXPECT_LT((pose.axis - row.vector("K_")).norm(), kAngle) << row.text("id");
  for (int i = 0; i < 5; ++i) {
    const Vector3d turning = jacobian.col(i).tail<3>().cross(pose.axis);
    for (int k = 0; k < 3; ++k) {
      const std::string at = std::to_string(k + 1) + std::to_string(i + 1);
      EXPECT_NEAR(jacobian(k, i), row.number("JQ_" + at), kLength) << row.text("id") << " " << at;
      EXPECT_NEAR(turning[k], row.number("JK_" + at), kAngle) << row.text("id") << " " << at;
    }
  }
}

TEST_F(KinematicsVectors, D1SevenAxisForward) {
  const Machine& machine = *findBuiltInMachine("propeller-c2zxc1b1");
  const std::vector<VectorRow> rows = readVectors("D1_seven_fk.csv");
  ASSERT_FALSE(rows.empty());
  int compared = 0;
  for (const VectorRow& row : rows) {
    Machine::Description description = machine.description();
    description.tool_tip.z() = -row.number("LT_mm");
    description.tool_chain[2].offset.z() = row.number("LC_mm");
    const JointPositions q = {row.number("C2_rad"), row.number("z_mm"), row.number("x_mm"),
                              row.number("C1_rad"), row.number("B1_rad")};
    compareJacobian(row, Machine::make(description).value(), q);
    ++compared;
  }
  EXPECT_EQ(compared, 14);
}

TEST_F(KinematicsVectors, D4GenericForward) {
  for (const VectorRow& row : readVectors("D4_generic_fk.csv")) {
    JointPositions q{};
    for (std::size_t i = 0; i < 5; ++i) q[i] = row.number("q" + std::to_string(i + 1));
    compareJacobian(row, chainMachine(row.text("machine")), q);
  }
}

TEST_F(KinematicsVectors, D5BothSolutionsAreReachedFromNearStarts) {
  const std::vector<VectorRow> rows = readVectors("D5_generic_ik.csv");
  ASSERT_EQ(rows.size(), 48U);
  for (std::size_t number = 0; number < rows.size(); ++number) {
    const VectorRow& row = rows[number];
    const Machine machine = chainMachine(row.text("machine"));
    PoseTarget target;
    target.tip = row.vector("Q_");
    target.axis = row.vector("K_").normalized();
    target.rotation = PoseTarget::Rotation::Axis;
    JointPositions wanted{}, start{};
    const bool singular = number / 2 % 6 == 5;
    for (std::size_t i = 0; i < 5; ++i) {
      wanted[i] = row.number("q" + std::to_string(i + 1));
      const bool rotary = machine.isRotary(static_cast<int>(i));
      start[i] = wanted[i] + (rotary ? (singular ? 1e-7 : 0.02) : 3.0);
    }
    const Result<JointPositions> q = inverse(machine, target, start);
    ASSERT_TRUE(q) << row.text("id") << ": " << q.error().message();
    for (std::size_t i = 0; i < 5; ++i) {
      const bool rotary = machine.isRotary(static_cast<int>(i));
      // 1e-8 rad near the singular pose turns a point at 200 mm by 2e-6 mm.
      const double tolerance = rotary ? (singular ? 1e-8 : 1e-10) : (singular ? 2e-6 : 1e-7);
      EXPECT_NEAR((*q)[i], wanted[i], tolerance) << row.text("id") << " q" << i + 1;
    }
  }
}

Machine sixAxisMachine() {
  Machine::Description description;
  const auto add = [&](AxisId axis, JointType type, const Vector3d& direction, double offset) {
    Joint joint;
    joint.axis = axis;
    joint.type = type;
    joint.direction = direction;
    joint.offset.z() = offset;
    description.tool_chain.push_back(joint);
  };
  add({'C', 2}, JointType::Rotary, Vector3d::UnitZ(), 0.0);
  add({'X', 0}, JointType::Linear, Vector3d::UnitX(), 0.0);
  add({'Y', 0}, JointType::Linear, Vector3d::UnitY(), 0.0);
  add({'Z', 0}, JointType::Linear, Vector3d::UnitZ(), 0.0);
  add({'C', 1}, JointType::Rotary, Vector3d::UnitZ(), 300.0);
  add({'B', 1}, JointType::Rotary, Vector3d::UnitY(), 0.0);
  description.tool_tip.z() = -250.0;
  return Machine::make(description).value();
}

TEST_F(KinematicsVectors, D7UndampedRedundantStep) {
  const Machine machine = sixAxisMachine();
  int compared = 0;
  for (const VectorRow& row : readVectors("D7_redundant_step.csv")) {
    if (row.number("lambda") != 0.0) continue;  // our step has no damping, it caps the turn instead
    JointPositions q{};
    for (std::size_t i = 0; i < 6; ++i) q[i] = row.number("q" + std::to_string(i + 1));
    PoseJacobian jacobian;
    const ToolPose pose = forwardWithJacobian(machine, q, jacobian);
    PoseTarget target;
    target.tip = row.vector("Q_");
    target.axis = row.vector("K_").normalized();
    target.rotation = PoseTarget::Rotation::Axis;
    const PoseResidual r = residual(target, pose);
    target.axis = pose.axis;  // theory.md, 4.2: the rows are taken across the present axis
    StepOptions options;
    options.rotary_length = std::sqrt(row.number("W1"));
    const JointPositions step = leastSquaresStep(machine, jacobian, r, target, options);
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_NEAR(step[i], row.number("dq" + std::to_string(i + 1)), 1e-10)
          << row.text("id") << " dq" << i + 1;
    ++compared;
  }
  EXPECT_GT(compared, 0);
}

}  // namespace
}  // namespace nineline::kinematics
