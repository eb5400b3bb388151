// The vectors A5 and C5 of ../shared/vectors: corrected commands, errors before and after.
#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/compensation/point_solver.h"
#include "core/errors/table_effects.h"
#include "tests/core/compensation/published_case.h"
#include "tests/support/vector_table.h"

namespace nineline::compensation {
namespace {

using Eigen::Vector3d;
using errors::Component;
using errors::ErrorTable;
using errors::Interpolation;
using kinematics::RotationModel;
using test_support::axisErrors;
using test_support::GrinderGeometry;
using test_support::GrinderPlace;
using test_support::PublishedCase;
using test_support::publishedCommand;
using test_support::readVectors;
using test_support::VectorRow;

constexpr double kIterated = 1e-9;  // mm; README of the vectors, iterative solutions
constexpr double kAngle = 1e-11;    // rad
constexpr double kArcRadius = 24.0;

class CompensationVectors : public testing::Test {
 protected:
  void SetUp() override {
    if (!test_support::haveVectors())
      GTEST_SKIP() << test_support::vectorFolder() << " is not there: vectors not compared";
  }
};

GrinderPlace solved(const ErrorModel& model, const GrinderPlace& command) {
  PointSolver solver(model, {});
  const Result<JointPositions> q = solver.solve({command.joints(), {}, 7U, {}}, command.joints());
  EXPECT_TRUE(q) << q.error().text;
  return {(*q)[2], (*q)[0], (*q)[1]};
}

Vector3d touchedPoint(const ErrorModel& model, const GrinderPlace& place) {
  MachineState state;
  state.q = place.joints();
  return model.actualPose(state).tip;
}

struct Synthetic {
  GrinderGeometry geometry;
  std::map<std::string, double> constants;
};

Synthetic readSynthetic() {
  Synthetic g1;
  for (const VectorRow& row : readVectors("A2_g1_geometry.csv"))
    g1.constants[row.text("name")] = row.number("value");
  const auto vector = [&](const std::string& stem) {
    return Vector3d(g1.constants.at(stem + "_x"), g1.constants.at(stem + "_y"), g1.constants.at(stem + "_z"));
  };
  g1.geometry = {vector("q2"), vector("q4"), vector("t")};
  return g1;
}

ErrorTable tableOf(const std::vector<VectorRow>& rows, char axis, int row, Interpolation interpolation) {
  static constexpr std::array kNames = {"EX", "EY", "EZ", "EA", "EB", "EC"};
  const std::string column =
      std::string(kNames[static_cast<std::size_t>(row)]) + axis + (row < 3 ? "_mm" : "_rad");
  std::vector<double> values;
  for (const VectorRow& one : rows) values.push_back(one.number(column));
  const std::string position = axis == 'C' ? "pos_deg" : "pos_mm";
  ErrorTable::Grid grid{rows[0].number(position), rows[1].number(position) - rows[0].number(position),
                        interpolation, std::nullopt};
  if (axis == 'C') grid = {radFromDeg(grid.start), radFromDeg(grid.spacing), interpolation, kTurn};
  return ErrorTable::make(grid, std::move(values)).value();
}

ErrorModel syntheticModel(const Synthetic& g1, Interpolation interpolation) {
  std::vector<errors::EffectPtr> effects;
  const kinematics::Machine machine = test_support::grinderWith(g1.geometry);
  for (const char axis : {'X', 'Z', 'C'}) {
    const std::vector<VectorRow> rows = readVectors(std::string("A2_g1_errors_") + axis + ".csv");
    for (int row = 0; row < 6; ++row) {
      effects.push_back(
          std::make_shared<errors::TableEffect>(machine.find({axis, 0}), Component{{axis, 0}, row, false},
                                                tableOf(rows, axis, row, interpolation), false));
    }
  }
  for (const char* name : {"A0C", "B0C", "B0X"}) {
    const Component component = *errors::parseComponent(name);
    effects.push_back(std::make_shared<errors::LocationEffect>(machine.find(component.axis), component,
                                                               g1.constants.at(name), std::nullopt));
  }
  return ErrorModel::make(machine, std::move(effects)).value();
}

TEST_F(CompensationVectors, A5CorrectedCommandsOfTheSyntheticGrinder) {
  const Synthetic g1 = readSynthetic();
  const std::map<std::string, ErrorModel> exact = {{"linear", syntheticModel(g1, Interpolation::Linear)},
                                                   {"cubic", syntheticModel(g1, Interpolation::Cubic)}};
  const std::vector<VectorRow> rows = readVectors("A5_compensate.csv");
  ASSERT_FALSE(rows.empty());
  int first_order = 0;
  for (const VectorRow& row : rows) {
    SCOPED_TRACE(row.text("id"));
    const ErrorModel& machine = exact.at(row.text("interp"));
    const bool linear = row.text("mode") == "linear";
    first_order += linear ? 1 : 0;
    const ErrorModel model = linear ? machine.withRotationModel(RotationModel::FirstOrder) : machine;
    const GrinderPlace command{row.number("x_mm"), row.number("z_mm"), row.number("gamma_rad")};
    const Vector3d w = row.vector("w_ideal_");
    const Vector3d touched = touchedPoint(model, command);
    // The vector's norm is taken in the bed. First-order matrices are no rotations, so a length of 0.01 mm
    // differs by up to 1e-4 of itself between the two frames.
    EXPECT_NEAR((touched - w).norm(), row.number("F0_norm_mm"), linear ? 1e-6 : 1e-10);
    const GrinderPlace before = axisErrors(g1.geometry, touched, command);
    EXPECT_NEAR(before.x, row.number("err_x_mm"), 1e-10);
    EXPECT_NEAR(before.z, row.number("err_z_mm"), 1e-10);
    EXPECT_NEAR(before.gamma, row.number("err_gamma_rad"), kAngle);
    const GrinderPlace corrected = solved(model, command);
    EXPECT_NEAR(corrected.x, row.number("xc_mm"), kIterated);
    EXPECT_NEAR(corrected.z, row.number("zc_mm"), kIterated);
    EXPECT_NEAR(corrected.gamma, row.number("gammac_rad"), kAngle);
    EXPECT_NEAR(corrected.x - command.x, row.number("dx_mm"), kIterated);
    EXPECT_NEAR(corrected.z - command.z, row.number("dz_mm"), kIterated);
    EXPECT_NEAR(corrected.gamma - command.gamma, row.number("dgamma_rad"), kAngle);
    EXPECT_NEAR((touchedPoint(machine, corrected) - w).norm(), row.number("residual_in_exact_machine_mm"),
                kIterated);
  }
  EXPECT_GT(first_order, 0);
}

void expectCorrection(const VectorRow& row, const std::string& name, const ErrorModel& model) {
  SCOPED_TRACE(name + " " + row.text("k"));
  const GrinderPlace command{row.number("x_mm"), row.number("z_mm"), row.number("gamma_rad")};
  const GrinderPlace corrected = solved(model, command);
  EXPECT_NEAR(corrected.x, row.number(name + "_xc_mm"), kIterated);
  EXPECT_NEAR(corrected.z, row.number(name + "_zc_mm"), kIterated);
  EXPECT_NEAR(corrected.gamma, row.number(name + "_gammac_rad"), kAngle);
  const GrinderPlace left =
      axisErrors(PublishedCase().geometry(), touchedPoint(PublishedCase().model(), corrected), command);
  EXPECT_NEAR(left.x, row.number(name + "_eX_mm"), kIterated);
  EXPECT_NEAR(left.z, row.number(name + "_eZ_mm"), kIterated);
  EXPECT_NEAR(left.gamma * kArcRadius, row.number(name + "_eC_mm"), kIterated);
}

TEST_F(CompensationVectors, C5PublishedCase) {
  const ErrorModel full = PublishedCase().model();
  const std::vector<VectorRow> rows = readVectors("C5_published_case.csv");
  ASSERT_EQ(rows.size(), 21U);
  for (const VectorRow& row : rows) {
    const GrinderPlace command = publishedCommand(static_cast<int>(row.number("k")));
    EXPECT_NEAR(command.x, row.number("x_mm"), 1e-12);
    EXPECT_NEAR(command.z, row.number("z_mm"), 1e-12);
    EXPECT_NEAR(command.gamma, row.number("gamma_rad"), 1e-12);
    const GrinderPlace before = axisErrors(PublishedCase().geometry(), touchedPoint(full, command), command);
    EXPECT_NEAR(before.x, row.number("eX_mm"), 1e-10);
    EXPECT_NEAR(before.z, row.number("eZ_mm"), 1e-10);
    EXPECT_NEAR(before.gamma * kArcRadius, row.number("eC_arc24_mm"), 1e-10);
    expectCorrection(row, "full", full);
    expectCorrection(row, "first_order", full.withRotationModel(RotationModel::FirstOrder));
    expectCorrection(row, "translations", PublishedCase{.translations_only = true}.model());
  }
}

}  // namespace
}  // namespace nineline::compensation
