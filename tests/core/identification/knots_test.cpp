#include "core/identification/knots.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "core/base/units.h"
#include "core/identification/table_modes.h"
#include "core/kinematics/machine_file.h"

namespace nineline::identification {
namespace {

using measurement::Channel;
using measurement::InstrumentKind;
using measurement::Quantity;

Measurement stationsOf(const Machine& machine, const char* axis, const std::vector<double>& positions) {
  Measurement file;
  file.instrument.kind = InstrumentKind::Joint;
  file.instrument.axis = parseAxisId(axis);
  const int joint = machine.find(*file.instrument.axis);
  file.channels = {Channel{machine.isRotary(joint) ? Quantity::Angle : Quantity::Length}};
  for (const double position : positions) {
    measurement::Sample sample;
    sample.q[static_cast<std::size_t>(joint)] = position;
    file.samples.push_back(sample);
    file.readings.emplace_back(0.0);
  }
  return file;
}

std::optional<Knots> knotsOf(const char* machine_id, const char* axis, const std::vector<double>& positions) {
  const Machine& machine = *kinematics::findBuiltInMachine(machine_id);
  const std::vector<Measurement> files{stationsOf(machine, axis, positions)};
  const estimation::ReadingSet readings = estimation::ReadingSet::make(machine, files).value();
  return chooseKnots(readings, machine.find(*parseAxisId(axis)), 2);
}

TEST(ChooseKnots, StandAtEquallySpacedTargets) {
  const std::optional<Knots> knots = knotsOf("linear-stage", "X", {100, 0, 25, 50, 75, 75, 50, 25, 0});
  ASSERT_TRUE(knots);
  EXPECT_TRUE(knots->at_targets);
  EXPECT_EQ(knots->count, 5);
  EXPECT_NEAR(knots->grid.start, 0.0, 1e-12);
  EXPECT_NEAR(knots->grid.spacing, 25.0, 1e-12);
}

TEST(ChooseKnots, AreSpreadOverAnIrregularRange) {
  const std::optional<Knots> knots = knotsOf("linear-stage", "X", {0, 3, 10, 47, 90});
  ASSERT_TRUE(knots);
  EXPECT_FALSE(knots->at_targets);
  EXPECT_NEAR(knots->grid.start, 0.0, 1e-12);
  EXPECT_NEAR(knots->grid.start + knots->grid.spacing * static_cast<double>(knots->count - 1), 90.0, 1e-9);
}

TEST(ChooseKnots, CloseATurn) {
  std::vector<double> positions;
  for (int i = 0; i <= 12; ++i) positions.push_back(kTurn * i / 12);  // the turn's end repeats its start
  const std::optional<Knots> knots = knotsOf("rotary-table", "C", positions);
  ASSERT_TRUE(knots);
  EXPECT_TRUE(knots->closed);
  EXPECT_EQ(knots->count, 12);
}

TEST(ChooseKnots, DoNotCloseHalfATurn) {
  const std::optional<Knots> knots = knotsOf("rotary-table", "C", {0.0, 0.5, 1.0, 1.5, 2.0});
  ASSERT_TRUE(knots);
  EXPECT_FALSE(knots->closed);
  EXPECT_EQ(knots->count, 5);
}

TEST(ChooseKnots, AreNoneForAJointThatStands) { EXPECT_FALSE(knotsOf("linear-stage", "X", {5.0, 5.0, 5.0})); }

TEST(TableModes, SpanAllTablesAndKeepTheGauge) {
  const errors::ErrorTable::Grid grid{-50.0, 25.0, errors::Interpolation::Cubic, std::nullopt};
  const estimation::TableBasis basis(0, grid, 9);
  const TableModes modes = tableModes(basis, false, 0.1);
  EXPECT_EQ(modes.shape.cols(), 7);
  EXPECT_EQ(modes.datum, 0.0);
  EXPECT_LT(modes.shape.row(2).cwiseAbs().maxCoeff(), 1e-13);  // the node at 0
  VectorXd centred(9);
  for (Index i = 0; i < 9; ++i) centred[i] = static_cast<double>(i) - 4.0;
  EXPECT_LT((centred.transpose() * modes.shape).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_NEAR(modes.slope[2], 0.0, 1e-13);
  MatrixXd all(9, 9);
  all << modes.constant, modes.slope, modes.shape;
  EXPECT_GT(std::abs(all.determinant()), 1e-6);
}

TEST(TableModes, OfATurnHaveNoFirstHarmonic) {
  const errors::ErrorTable::Grid grid{0.0, kTurn / 12, errors::Interpolation::Cubic, kTurn};
  const estimation::TableBasis basis(0, grid, 12);
  const TableModes modes = tableModes(basis, true, 0.1);
  EXPECT_EQ(modes.shape.cols(), 9);
  EXPECT_LT((modes.cosine.transpose() * modes.shape).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((modes.constant.transpose() * modes.shape).cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace nineline::identification
