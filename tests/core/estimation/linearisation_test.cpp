#include "core/estimation/linearisation.h"

#include <gtest/gtest.h>

#include "core/estimation/normal_sums.h"
#include "tests/core/estimation/sample_problem.h"

namespace nineline::estimation {
namespace {

/// J by rows, dense.
MatrixXd denseOf(const Linearisation& linearisation) {
  const auto rows = static_cast<Index>(linearisation.readings().rows());
  MatrixXd dense(rows, linearisation.unknowns().size());
  for (Index row = 0; row < rows; ++row) dense.row(row) = linearisation.row(static_cast<std::size_t>(row));
  return dense;
}

class LinearisationTest : public testing::Test {
 protected:
  SampleProblem problem{7};
  ReadingSet readings = ReadingSet::make(problem.machine, problem.files).value();
  Linearisation linearisation{problem.unknowns, readings};
  NoProgress progress;
  VectorXd point = problem.map * problem.truth;
};

TEST_F(LinearisationTest, ResidualIsZeroAtTheErrorsThatMadeTheReadings) {
  ASSERT_TRUE(linearisation.at(point, true, progress));
  EXPECT_LT(linearisation.residual().cwiseAbs().maxCoeff(), 1e-12);
}

TEST_F(LinearisationTest, JacobianAgreesWithCentralDifferences) {
  ASSERT_TRUE(linearisation.at(point, true, progress));
  const MatrixXd jacobian = denseOf(linearisation) * problem.map;
  Linearisation moved(problem.unknowns, readings);
  constexpr double kStep = 1e-5;
  for (Index k = 0; k < problem.map.cols(); ++k) {
    VectorXd parameters = problem.truth;
    parameters[k] += kStep;
    ASSERT_TRUE(moved.at(problem.map * parameters, false, progress));
    const VectorXd above = moved.residual();
    parameters[k] -= 2.0 * kStep;
    ASSERT_TRUE(moved.at(problem.map * parameters, false, progress));
    const VectorXd difference = (moved.residual() - above) / (2.0 * kStep);
    const double largest = std::max(1.0, jacobian.col(k).cwiseAbs().maxCoeff());
    EXPECT_LT((difference - jacobian.col(k)).cwiseAbs().maxCoeff() / largest, 1e-7) << k;
  }
}

TEST_F(LinearisationTest, ProductsAndSumsAreThoseOfTheDenseJacobian) {
  ASSERT_TRUE(linearisation.at(0.5 * point, true, progress));
  const MatrixXd dense = denseOf(linearisation);
  EXPECT_LT((linearisation.times(point) - dense * point).cwiseAbs().maxCoeff(), 1e-12);
  VectorXd weights = VectorXd::Ones(dense.rows());
  weights[3] = 0.0;
  weights[5] = 0.25;
  const NormalSums sums = normalSums(linearisation, weights);
  MatrixXd matrix = MatrixXd::Zero(dense.cols(), dense.cols());
  VectorXd right = VectorXd::Zero(dense.cols());
  for (Index row = 0; row < dense.rows(); ++row) {
    const double sigma = readings.readings()[static_cast<std::size_t>(row)].sigma;
    const double weight = weights[row] / (sigma * sigma);
    matrix += weight * dense.row(row).transpose() * dense.row(row);
    right += weight * linearisation.residual()[row] * dense.row(row).transpose();
  }
  MatrixXd sum = MatrixXd::Zero(dense.cols(), dense.cols());
  VectorXd sum_right = VectorXd::Zero(dense.cols());
  for (std::size_t c = 0; c < sums.matrix.size(); ++c) sum += sums.matrix[c], sum_right += sums.right[c];
  EXPECT_LT((sum - matrix).cwiseAbs().maxCoeff(), 1e-12 * matrix.cwiseAbs().maxCoeff());
  EXPECT_LT((sum_right - right).cwiseAbs().maxCoeff(), 1e-12 * right.cwiseAbs().maxCoeff());
  NormalSums updated = sums;
  updateRight(linearisation, weights, updated);
  for (std::size_t c = 0; c < sums.right.size(); ++c) {
    EXPECT_LT((updated.right[c] - sums.right[c]).cwiseAbs().maxCoeff(),
              1e-12 * (1.0 + sums.right[c].cwiseAbs().maxCoeff()));
  }
}

TEST(ReadingSet, RefusesAnInstrumentThatDoesNotFit) {
  SampleProblem problem(1);
  problem.files[2].instrument.axis = AxisId{'Y', 0};
  const Result<ReadingSet> readings = ReadingSet::make(problem.machine, problem.files);
  ASSERT_FALSE(readings);
  EXPECT_EQ(readings.error().kind, ErrorKind::BadInput);
}

TEST(ReadingSet, GivesEveryRunAndChannelAnOffsetAndEveryFileAZero) {
  SampleProblem problem(1, 3, 4);
  problem.files[0].readings[0].reset();
  const Result<ReadingSet> readings = ReadingSet::make(problem.machine, problem.files);
  ASSERT_TRUE(readings);
  EXPECT_EQ(readings->rows(), 12U * 5U - 1U);
  EXPECT_EQ(readings->groups().size(), 3U * 5U);
  EXPECT_EQ(readings->zeroCount(), 2);
}

}  // namespace
}  // namespace nineline::estimation
