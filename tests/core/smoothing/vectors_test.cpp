// The vectors E1 to E9 of ../shared/vectors.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/kinematics/chain.h"
#include "core/smoothing/axis_motion.h"
#include "core/smoothing/certificate.h"
#include "core/smoothing/path_fit.h"
#include "core/smoothing/quintic.h"
#include "core/smoothing/spline_fit.h"
#include "tests/core/smoothing/sample_programs.h"
#include "tests/support/vector_table.h"

namespace nineline::smoothing {
namespace {

using test_support::readVectors;
using test_support::VectorRow;

constexpr double kLength = 1e-10;  // mm
constexpr double kAngle = 1e-12;   // rad

class SmoothingVectors : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!test_support::haveVectors())
      GTEST_SKIP() << test_support::vectorFolder() << " is not there: vectors not compared";
    for (const VectorRow& row : readVectors("E3_impeller_cl.csv")) {
      tips_.push_back(row.vector("p_"));
      a_.push_back(row.number("A_rad"));
      c_.push_back(row.number("C_rad"));
    }
    lengths_ = chordLengths(tips_);
    for (const double length : lengths_) u_.push_back(length / lengths_.back());
    rows_.resize(static_cast<Eigen::Index>(tips_.size()), 3);
    for (std::size_t j = 0; j < tips_.size(); ++j)
      rows_.row(static_cast<Eigen::Index>(j)) = tips_[j].transpose();
  }

  [[nodiscard]] BSpline fitted() const { return *fitSpline(u_, rows_, averagedKnots(u_, 12)); }

  std::vector<Vector3d> tips_;
  std::vector<double> a_;
  std::vector<double> c_;
  std::vector<double> lengths_;
  std::vector<double> u_;
  PointRows rows_;
};

Machine trunnion(const Vector3d& a0, const Vector3d& c0) {
  Machine::Description description;
  description.id = "trunnion";
  const auto joint = [](char letter, bool rotary, const Vector3d& direction, const Vector3d& offset) {
    kinematics::Joint one;
    one.axis = {letter, 0};
    one.type = rotary ? kinematics::JointType::Rotary : kinematics::JointType::Linear;
    one.direction = direction;
    one.offset = offset;
    return one;
  };
  description.workpiece_chain = {joint('A', true, -Vector3d::UnitX(), a0),
                                 joint('C', true, -Vector3d::UnitZ(), c0 - a0)};
  description.tool_chain = {joint('X', false, Vector3d::UnitX(), Vector3d::Zero()),
                            joint('Y', false, Vector3d::UnitY(), Vector3d::Zero()),
                            joint('Z', false, Vector3d::UnitZ(), Vector3d::Zero())};
  return *Machine::make(description);
}

TEST_F(SmoothingVectors, E1TrunnionBothWays) {
  const std::vector<VectorRow> rows = readVectors("E1_trunnion.csv");
  ASSERT_EQ(rows.size(), 12U);
  for (const VectorRow& row : rows) {
    const Machine machine = trunnion(row.vector("a0_"), row.vector("c0_"));
    const Vector3d tip = row.vector("p_") + row.vector("w0_") - row.vector("c0_");  // W's origin is at c0
    const Vector3d expected = row.vector("P_");
    const nc::AxisValues q{row.number("A_rad"), row.number("C_rad"), expected.x(), expected.y(),
                           expected.z()};
    const kinematics::ToolPose pose = forward(machine, q);
    EXPECT_LT((pose.tip - tip).norm(), kLength) << row.text("id");
    EXPECT_LT((pose.axis - row.vector("K_")).norm(), kAngle) << row.text("id");
    PathSection section;
    section.moving = 0b11111;
    const Result<AxisMotion> motion = AxisMotion::make(machine, section);
    ASSERT_TRUE(motion);
    CurvePoint point(5);
    point << tip, q[0], q[1];
    const Result<nc::AxisValues> values = motion->valuesAt(point, {});
    ASSERT_TRUE(values);
    for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR((*values)[k], q[k], kLength) << row.text("id");
  }
}

TEST_F(SmoothingVectors, E2ProgramGivesThePointsOfE3) {
  std::string text = "G90 G54\n";
  for (const VectorRow& row : readVectors("E2_impeller_nc.csv")) {
    text += text.size() < 10 ? "G0" : "G1 F1000";
    for (const char* axis : {"X_mm", "Y_mm", "Z_mm", "A_deg", "C_deg"})
      text += std::string(" ") + axis[0] + row.text(axis);
    text += "\n";
  }
  const testing::ReadPath path =
      testing::readBack(testing::machineNamed("trunnion-ac"), text, testing::impellerSetup());
  ASSERT_EQ(path.tips.size(), tips_.size());
  for (std::size_t j = 0; j < tips_.size(); ++j)
    EXPECT_LT((path.tips[j] - Vector3d(0.0, 0.0, 85.0) - tips_[j]).norm(), kLength) << j;
}

TEST_F(SmoothingVectors, E3ParametersSlopesAndErrors) {
  const std::vector<VectorRow> rows = readVectors("E3_impeller_cl.csv");
  const std::vector<NodeState> a = nodeStates(lengths_, a_);
  const std::vector<NodeState> c = nodeStates(lengths_, c_);
  const BSpline curve = fitted();
  for (std::size_t j = 0; j < rows.size(); ++j) {
    EXPECT_NEAR(lengths_[j], rows[j].number("l_mm"), kLength);
    EXPECT_NEAR(u_[j], rows[j].number("u"), 1e-13);
    EXPECT_NEAR(a[j].slope, rows[j].number("dA_dl"), kAngle);
    EXPECT_NEAR(a[j].bend, rows[j].number("d2A_dl2"), kAngle);
    EXPECT_NEAR(c[j].slope, rows[j].number("dC_dl"), kAngle);
    EXPECT_NEAR(c[j].bend, rows[j].number("d2C_dl2"), kAngle);
    EXPECT_NEAR((curve.at(u_[j]).head<3>() - tips_[j]).norm(), rows[j].number("fit_error_mm"), 1e-9);
  }
}

TEST_F(SmoothingVectors, E4KnotsAndControlPoints) {
  const BSpline curve = fitted();
  const std::vector<VectorRow> knots = readVectors("E4_knots.csv");
  ASSERT_EQ(knots.size(), curve.knots().size());
  for (std::size_t i = 0; i < knots.size(); ++i)
    EXPECT_NEAR(curve.knots()[i], knots[i].number("U"), 1e-13) << i;
  const std::vector<VectorRow> control = readVectors("E4_ctrl.csv");
  ASSERT_EQ(static_cast<Eigen::Index>(control.size()), curve.control().rows());
  for (std::size_t i = 0; i < control.size(); ++i)
    EXPECT_LT(
        (curve.control().row(static_cast<Eigen::Index>(i)).transpose() - control[i].vector("V_")).norm(),
        1e-9);
}

TEST_F(SmoothingVectors, E5CurveAndItsDerivatives) {
  const BSpline curve = fitted();
  for (const VectorRow& row : readVectors("E5_curve_eval.csv")) {
    const double u = row.number("u");
    const std::array<const char*, 4> names{"R_", "dR_", "d2R_", "d3R_"};
    const std::array<double, 4> tolerances{1e-9, 1e-8, 1e-7, 1e-6};  // control points are good to 1e-9
    for (int order = 0; order <= 3; ++order) {
      const auto k = static_cast<std::size_t>(order);
      EXPECT_LT((curve.derivative(u, order) - row.vector(names[k])).norm(), tolerances[k])
          << row.text("id") << " order " << order;
    }
  }
}

TEST_F(SmoothingVectors, E6CertifiedChords) {
  const BSpline curve = fitted();
  double largest = 0.0;
  for (const VectorRow& row : readVectors("E6_chord_bound.csv")) {
    const auto j = static_cast<std::size_t>(row.number("segment")) - 1;
    const DistanceBounds bounds = boundDistance(curve, u_[j], u_[j + 1], tips_[j], tips_[j + 1], -1.0, 1e-11);
    EXPECT_NEAR(bounds.upper, row.number("upper_mm"), 1e-9) << j;
    EXPECT_NEAR(bounds.lower, row.number("lower_mm"), 1e-9) << j;
    largest = std::max(largest, bounds.upper);
  }
  EXPECT_NEAR(largest, 0.010393724279111003, 1e-9);
}

TEST_F(SmoothingVectors, E7Quintics) {
  const std::vector<VectorRow> rows = readVectors("E7_quintic.csv");
  ASSERT_FALSE(rows.empty());
  for (const VectorRow& row : rows) {
    const auto n = [&row](const char* name) { return row.number(name); };
    const Quintic q = makeQuintic({n("f0"), n("d0"), n("s0")}, {n("f1"), n("d1"), n("s1")}, n("h_mm"));
    for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(q[k], row.number("a" + std::to_string(k)), 1e-13);
    const std::array<const char*, 4> names{"f", "df", "d2f", "d3f"};
    for (int order = 0; order < 4; ++order)
      EXPECT_NEAR(derivativeAt(q, n("x"), order), n(names[static_cast<std::size_t>(order)]), 1e-12);
  }
}

TEST_F(SmoothingVectors, E8FiveAxesOnTheCurve) {
  const BSpline curve = fitted();
  const std::vector<NodeState> a = nodeStates(lengths_, a_);
  const std::vector<NodeState> c = nodeStates(lengths_, c_);
  PathSection section;
  section.moving = 0b11111;
  const Machine& machine = testing::machineNamed("trunnion-ac");
  const Result<AxisMotion> motion = AxisMotion::make(machine, section);
  ASSERT_TRUE(motion);
  for (const VectorRow& row : readVectors("E8_axes.csv")) {
    const double u = row.number("u");
    const auto above = std::upper_bound(u_.begin(), u_.end() - 1, u);
    const auto j = static_cast<std::size_t>(above - u_.begin()) - 1;
    const double h = lengths_[j + 1] - lengths_[j];
    const double x = u * lengths_.back() - lengths_[j];
    const Quintic qa = makeQuintic(a[j], a[j + 1], h);
    const Quintic qc = makeQuintic(c[j], c[j + 1], h);
    EXPECT_NEAR(derivativeAt(qa, x, 0), row.number("A_rad"), kAngle);
    EXPECT_NEAR(derivativeAt(qc, x, 0), row.number("C_rad"), kAngle);
    EXPECT_NEAR(derivativeAt(qa, x, 1), row.number("dA_dl"), kAngle);
    EXPECT_NEAR(derivativeAt(qc, x, 2), row.number("d2C_dl2"), kAngle);
    CurvePoint point(5);
    point << curve.at(u).head<3>() + Vector3d(0.0, 0.0, 85.0), derivativeAt(qa, x, 0), derivativeAt(qc, x, 0);
    const Result<nc::AxisValues> values = motion->valuesAt(point, {});
    ASSERT_TRUE(values);
    EXPECT_NEAR((*values)[2], row.number("X_mm"), 1e-9);
    EXPECT_NEAR((*values)[3], row.number("Y_mm"), 1e-9);
    EXPECT_NEAR((*values)[4] - 85.0, row.number("Z_mm"), 1e-9);
  }
}

TEST_F(SmoothingVectors, E9SpanPolynomials) {
  const BSpline curve = fitted();
  std::size_t span = kDegree;
  for (const VectorRow& row : readVectors("E9_poly.csv")) {
    const double ua = curve.knots()[span];
    const double ub = curve.knots()[span + 1];
    EXPECT_NEAR(ua, row.number("ua"), 1e-13);
    const BezierPiece b = curve.bezier(span, ua, ub);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const std::string name(1, static_cast<char>('x' + axis));
      const SpanPolynomial p = spanPolynomial({b[0][axis], b[1][axis], b[2][axis], b[3][axis]}, ub - ua);
      EXPECT_NEAR(p.start, row.number(name + "_start"), 1e-9);
      EXPECT_NEAR(p.end, row.number(name + "_end"), 1e-9);
      EXPECT_NEAR(p.a2, row.number(name + "_a2"), 1e-7);
      EXPECT_NEAR(p.a3, row.number(name + "_a3"), 1e-6);
      EXPECT_NEAR(p.k3, row.number(name + "_K3"), 1e-9);
      EXPECT_NEAR(p.k2, row.number(name + "_K2"), 1e-9);
      EXPECT_NEAR(p.k1, row.number(name + "_K1"), 1e-9);
    }
    ++span;
  }
  EXPECT_EQ(span, kDegree + curve.spanCount());
}

}  // namespace
}  // namespace nineline::smoothing
