#include "core/estimation/fit.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "core/base/units.h"
#include "core/estimation/ceres_fit.h"
#include "tests/core/estimation/sample_problem.h"

namespace nineline::estimation {
namespace {

double normal(test_support::Random& random) {
  const double u = 1.0 - random.between(0.0, 1.0);
  return std::sqrt(-2.0 * std::log(u)) * std::cos(random.between(0.0, kTurn));
}

void addNoise(test_support::Random& random, double share, double offset_share, SampleProblem& problem) {
  for (Measurement& file : problem.files) {
    const std::size_t channels = file.channels.size();
    std::vector<double> offsets(channels);
    std::vector<double> zeros(channels);
    for (double& zero : zeros) zero = file.instrument.hasZero() ? random.between(-1.0, 1.0) : 0.0;
    for (std::size_t i = 0; i < file.samples.size(); ++i) {
      const bool starts = i == 0 || file.run(i) != file.run(i - 1);
      for (std::size_t k = 0; k < channels; ++k) {
        if (starts) offsets[k] = offset_share * normal(random);
        const double sigma = file.channels[k].isAngular() ? *file.angular_repeatability : *file.repeatability;
        *file.readings[i * channels + k] += share * sigma * (normal(random) + offsets[k] + 10.0 * zeros[k]);
      }
    }
  }
}

Precision weakPrior(const SampleProblem& problem) {
  return 1e2 * MatrixXd::Identity(problem.map.cols(), problem.map.cols());
}

FitOptions plain() {
  FitOptions options;
  options.robust.enabled = false;
  options.estimate_noise = false;
  return options;
}

Result<Fit> fitOf(const SampleProblem& problem, const FitOptions& options) {
  const ReadingSet readings = ReadingSet::make(problem.machine, problem.files).value();
  Linearisation linearisation(problem.unknowns, readings);
  NoProgress progress;
  return fit(linearisation, problem.map, weakPrior(problem), options, progress);
}

TEST(Fit, AgreesWithCeresOnTheSameProblem) {
  SampleProblem problem(11, 1, 40);
  problem.files.resize(1);  // deviation: no zero, which the plain problem below does not have
  test_support::Random random(5);
  addNoise(random, 1.0, 0.0, problem);
  const Result<Fit> own = fitOf(problem, plain());
  ASSERT_TRUE(own) << own.error().message();
  const ReadingSet readings = ReadingSet::make(problem.machine, problem.files).value();
  Linearisation linearisation(problem.unknowns, readings);
  const Index n = problem.map.cols();
  const auto rows = static_cast<Index>(readings.rows());
  const ResidualFunction function = [&](const VectorXd& x, VectorXd& residuals, MatrixXd* jacobian) {
    NoProgress progress;
    (void)linearisation.at(problem.map * (1e-5 * x), jacobian != nullptr, progress).has_value();
    residuals.resize(rows + n);
    residuals.head(rows) = linearisation.residual() / 1e-3;
    residuals.tail(n) = 10.0 * 1e-5 * x;
    if (jacobian == nullptr) return;
    jacobian->setZero(rows + n, n);
    for (Index row = 0; row < rows; ++row) {
      const VectorXd of_row = problem.map.transpose() * linearisation.row(static_cast<std::size_t>(row));
      jacobian->row(row) = -1e-5 / 1e-3 * of_row;
    }
    jacobian->bottomRows(n) = 10.0 * 1e-5 * MatrixXd::Identity(n, n);
  };
  const Result<CeresFit> ceres = fitWithCeres(function, rows + n, VectorXd::Zero(n));
  ASSERT_TRUE(ceres) << ceres.error().message();
  const VectorXd sigmas = own->covariance.diagonal().cwiseSqrt();
  EXPECT_LT((own->parameters - 1e-5 * ceres->x).cwiseQuotient(sigmas).cwiseAbs().maxCoeff(), 1e-4);
}

TEST(Fit, FindsExactReadingsAgain) {
  const SampleProblem problem(3, 2, 60);
  const Result<Fit> found = fitOf(problem, FitOptions{});
  ASSERT_TRUE(found) << found.error().message();
  EXPECT_LT(found->rest.cwiseAbs().maxCoeff(), 1e-11);
  EXPECT_EQ(found->outliers(), 0U);
}

TEST(Fit, CovarianceIsThatOfManyNoisyCampaigns) {
  constexpr int kCampaigns = 150;
  const SampleProblem exact(4, 3, 20);
  const VectorXd truth = fitOf(exact, plain()).value().parameters;
  test_support::Random random(9);
  VectorXd square = VectorXd::Zero(truth.size());
  for (int i = 0; i < kCampaigns; ++i) {
    SampleProblem noisy = exact;
    addNoise(random, 1.0, 0.7, noisy);
    FitOptions options;
    options.robust.enabled = false;
    const Result<Fit> found = fitOf(noisy, options);
    ASSERT_TRUE(found);
    square += (found->parameters - truth).cwiseAbs2().cwiseQuotient(found->covariance.diagonal());
  }
  // The mean over parameters and campaigns is 1; single parameters scatter by sqrt(2 / campaigns).
  EXPECT_NEAR(square.mean() / kCampaigns, 1.0, 0.12);
  EXPECT_LT(square.maxCoeff() / kCampaigns, 1.6);
  EXPECT_GT(square.minCoeff() / kCampaigns, 0.55);
}

TEST(Fit, EstimatesWhiteNoiseAndRunOffsets) {
  SampleProblem problem(6, 25, 30);
  test_support::Random random(2);
  addNoise(random, 2.0, 1.0, problem);
  FitOptions options;
  options.robust.enabled = false;
  const Result<Fit> found = fitOf(problem, options);
  ASSERT_TRUE(found);
  for (const double scale : found->noise.scale) EXPECT_NEAR(scale, 2.0, 0.15);
  for (const double ratio : found->noise.ratio) EXPECT_NEAR(ratio, 1.0, 0.5);
}

TEST(Fit, LeavesOutliersOutAndNothingElse) {
  SampleProblem problem(8, 2, 80);
  test_support::Random random(3);
  addNoise(random, 1.0, 0.0, problem);
  const Result<Fit> clean = fitOf(problem, FitOptions{});
  ASSERT_TRUE(clean);
  *problem.files[0].readings[17] += 0.03;
  *problem.files[2].readings[44] -= 0.05;
  const Result<Fit> found = fitOf(problem, FitOptions{});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->outliers(), clean->outliers() + 2);
  EXPECT_EQ(found->weights[17], 0.0);
  const VectorXd sigmas = clean->covariance.diagonal().cwiseSqrt();
  EXPECT_LT((found->parameters - clean->parameters).cwiseQuotient(sigmas).cwiseAbs().maxCoeff(), 1.0);
}

TEST(CeresFit, SolvesACurveFit) {
  const ResidualFunction function = [](const VectorXd& x, VectorXd& r, MatrixXd* jacobian) {
    r.resize(2);
    r << 10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0];  // Rosenbrock's valley
    if (jacobian == nullptr) return;
    jacobian->resize(2, 2);
    *jacobian << -20.0 * x[0], 10.0, -1.0, 0.0;
  };
  const Result<CeresFit> found = fitWithCeres(function, 2, Eigen::Vector2d(-1.2, 1.0));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->x[0], 1.0, 1e-9);
  EXPECT_NEAR(found->x[1], 1.0, 1e-9);
}

}  // namespace
}  // namespace nineline::estimation
