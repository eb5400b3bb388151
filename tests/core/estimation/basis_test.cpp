#include "core/estimation/basis.h"

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "tests/support/random_machines.h"

namespace nineline::estimation {
namespace {

using errors::ErrorTable;
using errors::Interpolation;

double sumOf(const BasisValues& values, const VectorXd& coefficients) {
  double sum = 0.0;
  for (std::size_t n = 0; n < values.count; ++n) sum += values.value[n] * coefficients[values.index[n]];
  return sum;
}

void expectTheTablesOwnValues(const ErrorTable::Grid& grid, Index nodes, unsigned seed) {
  test_support::Random random(seed);
  std::vector<double> values;
  for (Index i = 0; i < nodes; ++i) values.push_back(random.between(-1.0, 1.0));
  const ErrorTable table = ErrorTable::make(grid, values).value();
  const TableBasis basis(0, grid, nodes);
  const VectorXd y = Eigen::Map<const VectorXd>(values.data(), nodes);
  VectorXd coefficients(2 * nodes);
  coefficients << y, basis.curvatures() * y;
  for (int k = 0; k < 200; ++k) {
    const double position = random.between(grid.start - 3.0, table.end() + 3.0);
    EXPECT_NEAR(sumOf(basis.atPosition(position), coefficients), table.value(position), 1e-13) << nodes;
    EXPECT_NEAR(basis.cardinal(position).dot(y), table.value(position), 1e-13) << nodes;
  }
}

TEST(TableBasis, GivesTheTablesOwnValues) {
  for (const Index nodes : {1, 2, 3, 5, 12}) {
    expectTheTablesOwnValues({-2.0, 0.7, Interpolation::Cubic, std::nullopt}, nodes, 1);
    expectTheTablesOwnValues({-2.0, 0.7, Interpolation::Linear, std::nullopt}, nodes, 2);
    const double spacing = kTurn / static_cast<double>(nodes);
    expectTheTablesOwnValues({0.3, spacing, Interpolation::Cubic, kTurn}, nodes, 3);
  }
}

TEST(PowerBasis, GivesThePowersOfThePosition) {
  const PowerBasis basis(1, 10.0, 1, 3);
  MachineState state;
  state.q[1] = 5.0;
  const BasisValues values = basis.at(state);
  ASSERT_EQ(values.count, 3U);
  EXPECT_DOUBLE_EQ(values.value[0], 0.5);
  EXPECT_DOUBLE_EQ(values.value[2], 0.125);
}

TEST(ApproachBasis, IsMinusHalfTheSense) {
  MachineState state;
  state.approach[2] = 1;
  EXPECT_DOUBLE_EQ(ApproachBasis(2).at(state).value[0], -0.5);
  state.approach[2] = 0;
  EXPECT_DOUBLE_EQ(ApproachBasis(2).at(state).value[0], 0.0);
}

}  // namespace
}  // namespace nineline::estimation
