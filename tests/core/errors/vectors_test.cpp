// The vectors A3, A4, A5 (before the correction) and A6 of ../shared/vectors, to the tolerances of their
// README.
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "core/errors/error_model.h"
#include "core/errors/table_effects.h"
#include "tests/support/vector_table.h"

namespace nineline::errors {
namespace {

using Eigen::Vector3d;
using kinematics::Joint;
using kinematics::JointType;
using kinematics::RotationModel;
using test_support::readVectors;
using test_support::VectorRow;

constexpr double kLength = 1e-10;  // mm
constexpr double kAngle = 1e-12;   // rad
constexpr std::array<const char*, 6> kRows = {"EX", "EY", "EZ", "EA", "EB", "EC"};

class ErrorVectors : public testing::Test {
 protected:
  void SetUp() override {
    if (!test_support::haveVectors())
      GTEST_SKIP() << test_support::vectorFolder() << " is not there: vectors not compared";
  }
};

Joint joint(char letter, JointType type, const Vector3d& direction, const Vector3d& offset) {
  Joint result;
  result.axis = {letter, 0};
  result.type = type;
  result.direction = direction;
  result.offset = offset;
  return result;
}

/// theory.md, 1.4: joints Z, C (workpiece), X (tool).
Machine grinder(const Vector3d& q2, const Vector3d& q4, const Vector3d& t) {
  Machine::Description description;
  description.id = "G1";
  description.workpiece_chain = {joint('Z', JointType::Linear, Vector3d::UnitZ(), Vector3d::Zero()),
                                 joint('C', JointType::Rotary, Vector3d::UnitZ(), q2)};
  description.tool_chain = {joint('X', JointType::Linear, Vector3d::UnitX(), q4)};
  description.tool_tip = t;
  return Machine::make(description).value();
}

ErrorTable tableOf(char axis, int row, Interpolation interpolation) {
  const bool rotary = axis == 'C';
  const std::vector<VectorRow> rows = readVectors(std::string("A2_g1_errors_") + axis + ".csv");
  std::vector<double> values;
  const std::string column =
      std::string(kRows[static_cast<std::size_t>(row)]) + axis + (row < 3 ? "_mm" : "_rad");
  for (const VectorRow& one : rows) values.push_back(one.number(column));
  const std::string position = rotary ? "pos_deg" : "pos_mm";
  ErrorTable::Grid grid{rows[0].number(position), rows[1].number(position) - rows[0].number(position),
                        interpolation, std::nullopt};
  if (rotary) grid = {radFromDeg(grid.start), radFromDeg(grid.spacing), interpolation, kTurn};
  return ErrorTable::make(grid, std::move(values)).value();
}

struct Geometry {
  Vector3d q2, q4, t;
  double A0C, B0C, B0X;
};

Geometry readGeometry() {
  std::map<std::string, double> values;
  for (const VectorRow& row : readVectors("A2_g1_geometry.csv"))
    values[row.text("name")] = row.number("value");
  const auto vector = [&](const std::string& stem) {
    return Vector3d(values.at(stem + "_x"), values.at(stem + "_y"), values.at(stem + "_z"));
  };
  return {vector("q2"), vector("q4"), vector("t"), values.at("A0C"), values.at("B0C"), values.at("B0X")};
}

/// The effects of G1 on those joints that the machine has.
ErrorModel modelOn(const Machine& machine, const Geometry& geometry, Interpolation interpolation) {
  std::vector<EffectPtr> effects;
  for (const char axis : {'X', 'Z', 'C'}) {
    const int index = machine.find({axis, 0});
    if (index < 0) continue;
    for (int row = 0; row < 6; ++row) {
      effects.push_back(std::make_shared<TableEffect>(index, Component{{axis, 0}, row, false},
                                                      tableOf(axis, row, interpolation), false));
    }
  }
  const auto locate = [&](const char* name, double value) {
    const Component component = *parseComponent(name);
    const int index = machine.find(component.axis);
    if (index >= 0)
      effects.push_back(std::make_shared<LocationEffect>(index, component, value, std::nullopt));
  };
  locate("A0C", geometry.A0C);
  locate("B0C", geometry.B0C);
  locate("B0X", geometry.B0X);
  return ErrorModel::make(machine, std::move(effects)).value();
}

Interpolation interpolationOf(const VectorRow& row, const std::string& column) {
  return row.text(column) == "linear" ? Interpolation::Linear : Interpolation::Cubic;
}

TEST_F(ErrorVectors, A3Interpolation) {
  const std::vector<VectorRow> rows = readVectors("A3_interp.csv");
  ASSERT_FALSE(rows.empty());
  for (const VectorRow& row : rows) {
    const char axis = row.text("axis")[0];
    const double position = axis == 'C' ? radFromDeg(row.number("pos")) : row.number("pos");
    for (int k = 0; k < 6; ++k) {
      const std::string column = std::string(kRows[static_cast<std::size_t>(k)]) + (k < 3 ? "_mm" : "_rad");
      EXPECT_NEAR(tableOf(axis, k, interpolationOf(row, "method")).value(position), row.number(column), 1e-15)
          << row.text("id") << " " << column;
    }
  }
}

kinematics::SmallMotion motionOf(const VectorRow& row, const std::string& axis) {
  return {{row.number("EX" + axis), row.number("EY" + axis), row.number("EZ" + axis)},
          {row.number("EA" + axis), row.number("EB" + axis), row.number("EC" + axis)}};
}

TEST_F(ErrorVectors, A4ForwardWithExplicitErrors) {
  const std::vector<VectorRow> rows = readVectors("A4_forward.csv");
  ASSERT_FALSE(rows.empty());
  for (const VectorRow& row : rows) {
    const Machine machine = grinder(row.vector("q2_"), row.vector("q4_"), row.vector("t_"));
    const JointPositions q = {row.number("z_mm"), row.number("gamma_rad"), row.number("x_mm")};
    JointDisplacements d;
    d[0].moved = motionOf(row, "Z");
    (row.text("c_frame") == "fixed" ? d[1].standing : d[1].moved) = motionOf(row, "C");
    d[1].located.rotation = {row.number("A0C"), row.number("B0C"), 0.0};
    d[2].moved = motionOf(row, "X");
    d[2].located.rotation = {0.0, row.number("B0X"), 0.0};
    const auto model = row.text("mode") == "exact" ? RotationModel::Exact : RotationModel::FirstOrder;
    EXPECT_LT((forward(machine, q, d, model).tip - row.vector("wact_")).norm(), kLength) << row.text("id");
  }
}

/// Axis-equivalent error: theory.md, 1.5 eq. 3 for the touched point, minus the command; (x, z, gamma).
Vector3d axisError(const Geometry& g, const Vector3d& w, double x, double z, double gamma) {
  const double r = std::hypot(w.x(), w.y());
  const double polar = std::atan2(w.y(), w.x());
  double theta = std::asin((g.q4.y() + g.t.y() - g.q2.y()) / r);
  double x_found = g.q2.x() + r * std::cos(theta) - g.q4.x() - g.t.x();
  const double x_other = g.q2.x() - r * std::cos(theta) - g.q4.x() - g.t.x();
  if (std::abs(x_other - x) < std::abs(x_found - x)) {
    x_found = x_other;
    theta = kPi - theta;
  }
  const double turn = theta - polar - gamma;
  return {x_found - x, g.q4.z() + g.t.z() - g.q2.z() - w.z() - z, turn - kTurn * std::round(turn / kTurn)};
}

TEST_F(ErrorVectors, A5ErrorsBeforeTheCorrection) {
  const Geometry g = readGeometry();
  const Machine machine = grinder(g.q2, g.q4, g.t);
  for (const VectorRow& row : readVectors("A5_compensate.csv")) {
    const ErrorModel model = modelOn(machine, g, interpolationOf(row, "interp"));
    MachineState state;
    state.q = {row.number("z_mm"), row.number("gamma_rad"), row.number("x_mm")};
    EXPECT_LT((model.idealPose(state).tip - row.vector("w_ideal_")).norm(), kLength) << row.text("id");
    JointDisplacements d;
    model.displacements(state, {}, d);
    const auto mode = row.text("mode") == "exact" ? RotationModel::Exact : RotationModel::FirstOrder;
    const Vector3d error =
        axisError(g, forward(machine, state.q, d, mode).tip, state.q[2], state.q[0], state.q[1]);
    EXPECT_NEAR(error.x(), row.number("err_x_mm"), kLength) << row.text("id");
    EXPECT_NEAR(error.y(), row.number("err_z_mm"), kLength) << row.text("id");
    EXPECT_NEAR(error.z(), row.number("err_gamma_rad"), 1e-11) << row.text("id");
  }
}

TEST_F(ErrorVectors, A6JacobianWithTheSlopesOfTheTables) {
  // F = p_w - p_t in the machine frame: each branch as a machine of its own, with w the tip of the first.
  const Geometry g = readGeometry();
  const std::vector<VectorRow> rows = readVectors("A6_jacobian.csv");
  ASSERT_FALSE(rows.empty());
  for (const VectorRow& row : rows) {
    const double x = row.number("x_mm"), z = row.number("z_mm"), gamma = row.number("gamma_rad");
    const Vector3d w = forward(grinder(g.q2, g.q4, g.t), {z, gamma, x}).tip;
    Machine::Description work = grinder(g.q2, g.q4, w).description();
    Machine::Description wheel = grinder(g.q2, g.q4, g.t).description();
    work.tool_chain = std::move(work.workpiece_chain);
    work.workpiece_chain.clear();
    wheel.workpiece_chain.clear();
    const Interpolation interpolation = interpolationOf(row, "interp");
    kinematics::PoseJacobian of_work, of_wheel;
    MachineState state;
    state.q = {z, gamma};
    (void)modelOn(Machine::make(work).value(), g, interpolation).actualPoseWithJacobian(state, {}, of_work);
    state.q = {x};
    (void)modelOn(Machine::make(wheel).value(), g, interpolation).actualPoseWithJacobian(state, {}, of_wheel);
    for (int k = 0; k < 3; ++k) {
      const std::string at = "J_" + std::to_string(k + 1);
      EXPECT_NEAR(-of_wheel(k, 0), row.number(at + "1"), kAngle) << row.text("id");
      EXPECT_NEAR(of_work(k, 0), row.number(at + "2"), kAngle) << row.text("id");
      EXPECT_NEAR(of_work(k, 1), row.number(at + "3"), kLength) << row.text("id");
    }
  }
}

}  // namespace
}  // namespace nineline::errors
