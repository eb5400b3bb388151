// The vectors C* of ../shared/vectors, to the tolerances of their README.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "core/base/text.h"
#include "core/thread_grinding/functional_error.h"
#include "core/thread_grinding/pass_plan.h"
#include "core/thread_grinding/thread_geometry.h"
#include "core/thread_grinding/thread_path.h"
#include "core/thread_grinding/wheel_profile.h"

namespace nineline::thread_grinding {
namespace {

constexpr double kLength = 1e-10;  // mm
constexpr double kAngle = 1e-12;   // rad

using Row = std::map<std::string, std::string>;

double value(const Row& row, const std::string& column) {
  const std::optional<double> number = parseNumber(row.at(column));
  EXPECT_TRUE(number) << column;
  return number.value_or(0.0);
}

int whole(const Row& row, const std::string& column) {
  return static_cast<int>(std::lround(value(row, column)));
}

Hand handOf(const Row& row) { return whole(row, "hand") > 0 ? Hand::Right : Hand::Left; }

std::vector<Row> rowsOf(const std::string& name) {
  std::ifstream file(std::string(NINELINE_SOURCE_DIR) + "/../shared/vectors/" + name);
  std::vector<Row> rows;
  std::string line;
  std::vector<std::string> columns;
  while (std::getline(file, line)) {
    const std::vector<std::string_view> cells = split(line, ',');
    if (columns.empty()) {
      columns.assign(cells.begin(), cells.end());
      continue;
    }
    Row row;
    for (std::size_t i = 0; i < columns.size() && i < cells.size(); ++i)
      row[columns[i]] = std::string(cells[i]);
    rows.push_back(row);
  }
  return rows;
}

class ThreadVectors : public testing::Test {
 protected:
  void SetUp() override {
    const std::filesystem::path folder = std::string(NINELINE_SOURCE_DIR) + "/../shared/vectors";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there: vectors not compared";
  }
};

TEST_F(ThreadVectors, C1Geometry) {
  const std::vector<Row> rows = rowsOf("C1_thread_geometry.csv");
  ASSERT_EQ(rows.size(), 6U);
  for (const Row& row : rows) {
    SCOPED_TRACE(row.at("id"));
    const ThreadGeometry thread =
        threadGeometry(value(row, "d_mm"), value(row, "P_mm"), whole(row, "starts"));
    EXPECT_NEAR(thread.lead, value(row, "lead_mm"), kLength);
    EXPECT_NEAR(thread.triangle_height, value(row, "H_mm"), kLength);
    EXPECT_NEAR(thread.pitch_diameter, value(row, "d2_mm"), kAngle);
    EXPECT_NEAR(thread.internal_minor_diameter, value(row, "d1_mm"), kLength);
    EXPECT_NEAR(thread.root_diameter, value(row, "d3_mm"), kLength);
    EXPECT_NEAR(thread.external_depth, value(row, "h3_mm"), kLength);
    EXPECT_NEAR(thread.root_radius, value(row, "R_root_mm"), kLength);
    EXPECT_NEAR(thread.helix_angle, value(row, "phi2_rad"), 1e-14);
    EXPECT_NEAR(thread.root_helix_angle, value(row, "phi3_rad"), kAngle);
    EXPECT_NEAR(thread.normal_half_angle, value(row, "alpha_n_rad"), kAngle);
  }
}

TEST_F(ThreadVectors, C2WheelProfile) {
  const std::vector<Row> rows = rowsOf("C2_wheel_profile.csv");
  ASSERT_EQ(rows.size(), 60U);
  for (const Row& row : rows) {
    SCOPED_TRACE(row.at("id"));
    const ThreadGeometry thread =
        threadGeometry(value(row, "d_mm"), value(row, "P_mm"), whole(row, "starts"));
    const Hand hand = handOf(row);
    const double tilt = row.at("tilt") == "at_d2" ? signOf(hand) * thread.helix_angle : 0.0;
    const Result<WheelPoint> point = conjugateWheelPoint(thread, hand, {value(row, "Dw_mm"), tilt},
                                                         whole(row, "side"), value(row, "r_mm"));
    ASSERT_TRUE(point);
    EXPECT_NEAR(point->axial, value(row, "zeta_mm"), 1e-11);
    EXPECT_NEAR(point->radius, value(row, "rho_mm"), kLength);
    EXPECT_NEAR(point->angle, value(row, "theta_rad"), kAngle);
  }
}

TEST_F(ThreadVectors, C2OvercutOfAnUntiltedWheel) {
  const ThreadGeometry thread = threadGeometry(48.0, 1.5, 1);
  const Result<double> tilted = halfWidthAtPitchLine(thread, Hand::Left, {400.0, -thread.helix_angle});
  const Result<double> straight = halfWidthAtPitchLine(thread, Hand::Left, {400.0, 0.0});
  ASSERT_TRUE(tilted && straight);
  EXPECT_NEAR(*straight - *tilted, -1.8583714308668142e-3, 1e-11);
}

TEST_F(ThreadVectors, C3Passes) {
  const std::vector<Row> rows = rowsOf("C3_passes.csv");
  ASSERT_EQ(rows.size(), 5U);
  for (const Row& row : rows) {
    SCOPED_TRACE(row.at("id"));
    PassPlan plan;
    plan.depth = value(row, "depth_mm");
    plan.infeed = value(row, "infeed_mm");
    plan.min_last_ratio = value(row, "min_last_ratio");
    plan.spark_out_passes = whole(row, "spark_out");
    const std::vector<ThreadPass> passes = planPasses(plan);
    ASSERT_EQ(static_cast<int>(passes.size()), whole(row, "count"));
    const std::size_t cutting = passes.size() - static_cast<std::size_t>(plan.spark_out_passes);
    EXPECT_NEAR(passes.front().depth, value(row, "first_mm"), kLength);
    EXPECT_NEAR(cutting > 1 ? passes[cutting - 2].depth : 0.0, value(row, "last_but_one_mm"), kLength);
    EXPECT_NEAR(passes[cutting - 1].depth, value(row, "last_mm"), kLength);
    EXPECT_NEAR(passes.back().depth, value(row, "final_mm"), kLength);
  }
}

TEST_F(ThreadVectors, C4Points) {
  const std::vector<Row> rows = rowsOf("C4_thread_points.csv");
  ASSERT_EQ(rows.size(), 12U);
  for (const Row& row : rows) {
    SCOPED_TRACE(row.at("id"));
    const int starts = whole(row, "starts");
    ThreadPath path;
    path.hand = handOf(row);
    path.lead = starts * value(row, "P_mm");
    path.phase = startPhase(whole(row, "start_index"), starts);
    path.radius = value(row, "radius_at_wz0_mm");
    path.taper = value(row, "taper_radius_per_mm");
    path.z_at_zero = value(row, "K0_mm");
    const ThreadPoint point = pointAt(path, value(row, "wz_mm"));
    EXPECT_NEAR(point.x, value(row, "x_mm"), kLength);
    EXPECT_NEAR(point.z, value(row, "z_mm"), kLength);
    EXPECT_NEAR(point.gamma, value(row, "gamma_rad"), kAngle);
    EXPECT_NEAR(degFromRad(point.gamma), value(row, "gamma_deg"), 1e-9);
  }
}

TEST_F(ThreadVectors, C6FunctionalError) {
  const std::vector<Row> rows = rowsOf("C6_functional_error.csv");
  ASSERT_EQ(rows.size(), 8U);
  for (const Row& row : rows) {
    SCOPED_TRACE(row.at("id"));
    const FunctionalError error =
        functionalError({value(row, "er_mm"), value(row, "et_mm"), value(row, "ea_mm")}, handOf(row),
                        value(row, "lead_mm"), value(row, "radius_mm"));
    EXPECT_NEAR(error.axial_lead, value(row, "axial_lead_error_mm"), kLength);
    EXPECT_NEAR(error.radial, value(row, "radial_error_mm"), kLength);
    EXPECT_NEAR(error.flank_plus, value(row, "flank_plus_normal_mm"), kLength);
    EXPECT_NEAR(error.flank_minus, value(row, "flank_minus_normal_mm"), kLength);
    EXPECT_NEAR(error.pitch_diameter, value(row, "dd2_mm"), kLength);
  }
}

}  // namespace
}  // namespace nineline::thread_grinding
