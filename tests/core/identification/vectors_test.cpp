// The vectors B1 to B5 of ../shared/vectors, to the tolerances of their README and acceptance list.
#include <gtest/gtest.h>

#include <array>

#include "core/identification/nine_line.h"
#include "core/identification/rigid_fit.h"
#include "core/identification/rotary_axis.h"
#include "core/identification/squareness.h"
#include "tests/support/vector_table.h"

namespace nineline::identification {
namespace {

using test_support::readVectors;
using test_support::VectorRow;

constexpr double kLength = 1e-12;  // mm
constexpr double kAngle = 1e-13;   // rad

class IdentificationVectors : public testing::Test {
 protected:
  void SetUp() override {
    if (!test_support::haveVectors())
      GTEST_SKIP() << test_support::vectorFolder() << " is not there: vectors not compared";
  }
};

constexpr std::array<const char*, 6> kValues{"d_x_mm", "d_y_mm", "d_z_mm", "e_x_rad", "e_y_rad", "e_z_rad"};
constexpr std::array<const char*, 6> kSigmas{"s_dx_mm",  "s_dy_mm",  "s_dz_mm",
                                             "s_ex_rad", "s_ey_rad", "s_ez_rad"};

NineLinePattern patternOf(const VectorRow& row) {
  NineLinePattern pattern;
  pattern.along = row.text("axis")[0] - 'X';
  const int b = (pattern.along + 1) % 3, c = (pattern.along + 2) % 3;
  pattern.first = row.vector("r1_", "_mm");
  pattern.span_b = (row.vector("r2_", "_mm") - pattern.first)(b);
  pattern.span_c = (row.vector("r3_", "_mm") - pattern.first)(c);
  pattern.set = row.text("set") == "full" ? LineSet::Full : LineSet::Minimal;
  return pattern;
}

TEST_F(IdentificationVectors, B1NineLine) {
  const std::vector<VectorRow> rows = readVectors("B1_nine_line.csv");
  ASSERT_EQ(rows.size(), 36U);
  for (const VectorRow& row : rows) {
    const NineLinePattern pattern = patternOf(row);
    const LineSetup setup = makeNineLineSetup({row.text("axis")[0], 0}, pattern);
    LineData data;
    data.positions = {0.0};
    for (const LineReading& reading : setup.readings) {
      int k = 1;
      while (reading.direction((pattern.along + k - 1) % 3) == 0.0) ++k;
      data.readings.push_back(
          {row.number("read" + std::to_string(reading.line) + "_" + std::to_string(k) + "_mm")});
    }
    const Result<LineReport> found = identifyLines(setup, data, LineMethod::FirstOrder);
    ASSERT_TRUE(found) << found.error().text;
    for (std::size_t i = 0; i < 6; ++i) {
      const double tolerance = i < 3 ? kLength : 1e-14;
      EXPECT_NEAR(*found->positions[0].value[i], row.number(kValues[i]), tolerance) << row.text("id");
      EXPECT_NEAR(*found->positions[0].sigma[i], row.number(kSigmas[i]), 1e-15) << row.text("id");
    }
  }
}

TEST_F(IdentificationVectors, B2Observability) {
  for (const VectorRow& row : readVectors("B2_observability.csv")) {
    NineLinePattern pattern;
    pattern.along = row.text("axis")[0] - 'X';
    pattern.set = row.text("set") == "full" ? LineSet::Full : LineSet::Minimal;
    const std::string slopes = row.text("free_straightness_slopes");
    pattern.inclination = slopes == "each"     ? StraightnessInclination::EachLine
                          : slopes == "common" ? StraightnessInclination::EachDirection
                                               : StraightnessInclination::Known;
    const LineSetup setup = makeNineLineSetup({row.text("axis")[0], 0}, pattern);
    LineData data;
    for (int p = 0; p < 11; ++p) data.positions.push_back(30.0 * p);
    data.readings.assign(setup.readings.size(), std::vector<double>(11, 0.0));
    data.datum = 0;
    const Result<LineReport> found = identifyLines(setup, data);
    ASSERT_TRUE(found) << found.error().text;
    const int unobservable = static_cast<int>(row.number("unobservable"));
    EXPECT_EQ(found->unknowns - found->rank, unobservable) << row.text("id");
    EXPECT_EQ(static_cast<int>(found->slope_unobservable.size()), unobservable) << row.text("id");
    if (slopes == "none") continue;  // solved position by position, the datum included
    EXPECT_EQ(found->unknowns, static_cast<int>(row.number("unknowns"))) << row.text("id");
    EXPECT_EQ(found->rank, static_cast<int>(row.number("rank"))) << row.text("id");
  }
}

TEST_F(IdentificationVectors, B3Squareness) {
  for (const VectorRow& row : readVectors("B3_squareness.csv")) {
    std::vector<double> x, dz, z, dx;
    for (int i = 0; i <= 10; ++i) {
      x.push_back(30.0 * i), dz.push_back(row.number("dz_at_x" + std::to_string(30 * i)));
      z.push_back(50.0 * i), dx.push_back(row.number("dx_at_z" + std::to_string(50 * i)));
    }
    const SlopeFit of_x = fitSlope(x, dz).value(), of_z = fitSlope(z, dx).value();
    EXPECT_NEAR(of_x.slope, row.number("slope_dz_over_x"), kAngle);
    EXPECT_NEAR(of_z.slope, row.number("slope_dx_over_z"), kAngle);
    const Squareness found = squarenessOf('Z', 'X', of_z, of_x).value();
    EXPECT_EQ(found.component, "B0X");
    EXPECT_NEAR(found.first_order, row.number("B0X_linear_rad"), kAngle) << row.text("id");
    EXPECT_NEAR(found.value, row.number("B0X_atan_rad"), kAngle) << row.text("id");
  }
}

TEST_F(IdentificationVectors, B4RotaryAxis) {
  const std::vector<VectorRow> rows = readVectors("B4_rotary.csv");
  ASSERT_FALSE(rows.empty());
  for (const VectorRow& row : rows) {
    const RotaryTargets targets{row.number("h1_mm"), row.number("h2_mm"), row.number("R_mm")};
    const RotaryReadings readings{row.number("rd_axial_mm"), row.number("rd_r1a_mm"),
                                  row.number("rd_r1b_mm"),   row.number("rd_r2a_mm"),
                                  row.number("rd_r2b_mm"),   row.number("rd_dang_rad")};
    const double angle = row.number("angle_rad");
    const RotaryPose exact = exactRotaryPose(targets, readings, angle).value();
    const RotaryPose first = firstOrderRotaryPose(targets, readings, angle).value();
    const SmallMotion turning = turningMotionOf(exact, angle);
    for (int i = 0; i < 3; ++i) {
      const std::string n = std::to_string(i + 1);
      EXPECT_NEAR(exact.d(i), row.number("d" + n), kLength) << row.text("id");
      EXPECT_NEAR(exact.e(i), row.number("e" + n), 1e-12) << row.text("id");
      EXPECT_NEAR(exact.d(i), row.number("true_d" + n), kLength) << row.text("id");
      EXPECT_NEAR(exact.e(i), row.number("true_e" + n), 1e-12) << row.text("id");
      EXPECT_NEAR(first.d(i), row.number("fo_d" + n), 1e-10) << row.text("id");
      EXPECT_NEAR(first.e(i), row.number("fo_e" + n), 1e-12) << row.text("id");
      EXPECT_NEAR(turning.translation(i), row.number("body_d" + n), kLength) << row.text("id");
      EXPECT_NEAR(turning.rotation(i), row.number("body_w" + n), 1e-12) << row.text("id");
    }
  }
}

TEST_F(IdentificationVectors, B5RigidFit) {
  for (const VectorRow& row : readVectors("B5_rigid_fit.csv")) {
    std::vector<Vector3d> targets, observed;
    for (int i = 1; i <= 5; ++i) {
      targets.push_back(row.vector("s" + std::to_string(i) + "_"));
      observed.push_back(row.vector("p" + std::to_string(i) + "_"));
    }
    const RigidFit found = fitRigidMotion(targets, observed).value();
    EXPECT_LT((found.motion.translation - row.vector("d_", "_mm")).norm(), 1e-10) << row.text("id");
    EXPECT_LT((found.motion.rotation - row.vector("w_", "_rad")).norm(), 1e-12) << row.text("id");
    EXPECT_NEAR(found.rms, row.number("rms_mm"), 1e-10) << row.text("id");
  }
}

}  // namespace
}  // namespace nineline::identification
