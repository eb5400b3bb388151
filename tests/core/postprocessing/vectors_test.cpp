// The vectors D2, D3, D5 and D7 of ../shared/vectors, to the tolerances of their README.
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "core/kinematics/machine_file.h"
#include "core/postprocessing/branches.h"
#include "tests/support/vector_table.h"

namespace nineline::postprocessing {
namespace {

using kinematics::Joint;
using kinematics::JointType;
using test_support::readVectors;
using test_support::VectorRow;

constexpr double kLength = 1e-9;  // mm, of iterative solutions
constexpr double kAngle = 1e-10;  // rad

class PostVectors : public testing::Test {
 protected:
  void SetUp() override {
    if (!test_support::haveVectors())
      GTEST_SKIP() << test_support::vectorFolder() << " is not there: vectors not compared";
  }
};

/// Joints in the order of the vectors, C2, z, x, C1, B1, all on the tool's side; no travel.
Machine sevenAxisMachine(double tool_length, double head_length) {
  Machine::Description description;
  const auto add = [&](AxisId axis, JointType type, const Vector3d& direction, double offset) {
    Joint joint;
    joint.axis = axis;
    joint.type = type;
    joint.direction = direction;
    joint.offset.z() = offset;
    description.tool_chain.push_back(joint);
  };
  description.id = "seven";
  add({'C', 2}, JointType::Rotary, Vector3d::UnitZ(), 0.0);
  add({'Z', 0}, JointType::Linear, Vector3d::UnitZ(), 0.0);
  add({'X', 0}, JointType::Linear, Vector3d::UnitX(), 0.0);
  add({'C', 1}, JointType::Rotary, Vector3d::UnitZ(), head_length);
  add({'B', 1}, JointType::Rotary, Vector3d::UnitY(), 0.0);
  description.tool_tip.z() = -tool_length;
  return Machine::make(description).value();
}

TipAxis targetOf(const VectorRow& row) { return {row.vector("Q_"), row.vector("K_").normalized()}; }

JointPositions sevenOf(const VectorRow& row) {
  return {row.number("C2_rad"), row.number("z_mm"), row.number("x_mm"), row.number("C1_rad"),
          row.number("B1_rad")};
}

/// The largest difference, rotary joints to whole turns; mm and rad.
void expectSame(const Machine& machine, const JointPositions& found, const JointPositions& wanted,
                const std::string& what, double length = kLength, double angle = kAngle) {
  for (int i = 0; i < machine.jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double d = found[k] - wanted[k];
    EXPECT_LT(std::abs(machine.isRotary(i) ? std::remainder(d, kTurn) : d),
              machine.isRotary(i) ? angle : length)
        << what << " joint " << i;
  }
}

bool isNear(const Machine& machine, const JointPositions& a, const JointPositions& b) {
  double most = 0.0;
  for (int i = 0; i < machine.jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double d = a[k] - b[k];
    most = std::max(most, machine.isRotary(i) ? std::abs(std::remainder(d, kTurn)) : 1e-3 * std::abs(d));
  }
  return most < 1e-3;
}

TEST_F(PostVectors, D2TheSearchFindsAllFourBranches) {
  const std::vector<VectorRow> rows = readVectors("D2_seven_ik.csv");
  ASSERT_EQ(rows.size(), 56U);
  for (std::size_t first = 0; first < rows.size(); first += 4) {
    const Machine machine = sevenAxisMachine(rows[first].number("LT_mm"), rows[first].number("LC_mm"));
    const auto branches = findBranches(PoseSolver(machine), targetOf(rows[first]), {});
    EXPECT_EQ(branches.size(), 4U) << rows[first].text("id");
    for (std::size_t k = first; k < first + 4; ++k) {
      const JointPositions wanted = sevenOf(rows[k]);
      bool found = false;
      for (const JointPositions& q : branches) {
        if (!isNear(machine, q, wanted)) continue;
        found = true;
        expectSame(machine, q, wanted, rows[k].text("id"), 1e-8, 1e-9);
      }
      EXPECT_TRUE(found) << rows[k].text("id");
    }
  }
}

TEST_F(PostVectors, D3EveryPointInAtMostFourIterations) {
  const std::vector<VectorRow> rows = readVectors("D3_propeller_840.csv");
  ASSERT_EQ(rows.size(), 840U);
  const Machine machine = sevenAxisMachine(420.0, 150.0);
  const PoseSolver solver(machine);
  JointPositions q = sevenOf(rows[0]);
  int most = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const Solution solution = solver.solve(targetOf(rows[i]), q);
    ASSERT_TRUE(solution.converged) << rows[i].text("id");
    most = std::max(most, solution.iterations);
    q = solution.q;
    const JointPositions wanted = sevenOf(rows[i]);
    for (std::size_t k = 0; k < 5; ++k)  // unwound: no whole turns allowed here
      EXPECT_NEAR(q[k], wanted[k], k == 1 || k == 2 ? kLength : 1e-11)
          << rows[i].text("id") << " joint " << k;
  }
  EXPECT_LE(most, 4);
}

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

TEST_F(PostVectors, D5TheSearchFindsBothBranches) {
  const std::vector<VectorRow> rows = readVectors("D5_generic_ik.csv");
  ASSERT_EQ(rows.size(), 48U);
  for (std::size_t number = 0; number < rows.size(); ++number) {
    const VectorRow& row = rows[number];
    const Machine machine = chainMachine(row.text("machine"));
    const bool singular = number / 2 % 6 == 5;
    JointPositions wanted{};
    for (std::size_t k = 0; k < 5; ++k) wanted[k] = row.number("q" + std::to_string(k + 1));
    const auto branches = findBranches(PoseSolver(machine), targetOf(row), {});
    bool found = false;
    for (const JointPositions& q : branches) {
      if (!isNear(machine, q, wanted)) continue;
      found = true;
      // 1e-8 rad near the singular pose turns a point at 200 mm by 2e-6 mm; else the CL's own digits count
      expectSame(machine, q, wanted, row.text("id"), singular ? 2e-6 : 1e-7, singular ? 1e-8 : 1e-10);
    }
    EXPECT_TRUE(found) << row.text("id");
    EXPECT_EQ(branches.size(), 2U) << row.text("id");
  }
}

Machine sixAxisMachine() {
  Machine::Description description = sevenAxisMachine(250.0, 300.0).description();
  Joint y;
  y.axis = {'Y', 0};
  y.direction = Vector3d::UnitY();
  auto& chain = description.tool_chain;
  std::swap(chain[1], chain[2]);  // X before Z
  chain.insert(chain.begin() + 2, y);
  return Machine::make(description).value();
}

TEST_F(PostVectors, D7DampedRedundantStep) {
  const Machine machine = sixAxisMachine();
  const TipAxisChain chain(machine);
  int damped = 0;
  for (const VectorRow& row : readVectors("D7_redundant_step.csv")) {
    JointPositions q{};
    for (std::size_t k = 0; k < 6; ++k) q[k] = row.number("q" + std::to_string(k + 1));
    TipAxisJacobian jacobian;
    const TipAxis pose = chain.at(q, jacobian);
    SolverOptions options;
    options.rotary_length = std::sqrt(row.number("W1"));
    options.rotation_length = 1.0;  // the vectors' rows are mm and rad
    const Increment step = increment(machine, jacobian, pose.axis, residualOf(targetOf(row), pose), 0x3F,
                                     row.number("lambda"), options);
    ASSERT_TRUE(step.solved);
    for (std::size_t k = 0; k < 6; ++k)
      EXPECT_NEAR(step.dq[k], row.number("dq" + std::to_string(k + 1)), 1e-10)
          << row.text("id") << " dq" << k + 1;
    damped += row.number("lambda") > 0.0 ? 1 : 0;
  }
  EXPECT_GT(damped, 0);
}

}  // namespace
}  // namespace nineline::postprocessing
