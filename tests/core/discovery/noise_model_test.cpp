#include "core/discovery/noise_model.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

namespace nineline::discovery {
namespace {

using Eigen::MatrixXd;

NoiseLayout twoRuns() {
  NoiseLayout layout;
  layout.runs = {{0, 0, 7}, {1, 7, 9}};
  layout.groups = 2;
  layout.place.resize(16);
  for (Index i = 0; i < 16; ++i)
    layout.place[i] = i < 7 ? 1.3 * static_cast<double>(i) : static_cast<double>(i - 7);
  return layout;
}

/// The covariance as its formula says, one run.
MatrixXd covariance(const NoiseLayout& layout, const NoiseRun& run, const NoiseShape& shape) {
  MatrixXd c = MatrixXd::Constant(run.count, run.count, shape.offset);
  for (Index i = 0; i < run.count; ++i) {
    for (Index j = 0; j < run.count; ++j) {
      const double apart = std::abs(layout.place[run.first + i] - layout.place[run.first + j]);
      c(i, j) += (1.0 - shape.offset) * shape.correlated * std::exp(-apart / shape.length);
    }
    c(i, i) += (1.0 - shape.offset) * (1.0 - shape.correlated);
  }
  return c;
}

VectorXd someResidual(Index n) {
  std::mt19937_64 draw(7);
  std::normal_distribution<double> normal;
  VectorXd r(n);
  for (double& value : r) value = normal(draw);
  return r;
}

TEST(NoiseModel, WhitensAsTheInverseCholeskyFactorOfTheCovarianceDoes) {
  const NoiseLayout layout = twoRuns();
  const NoiseModel model(layout);
  const VectorXd r = someResidual(16);
  for (std::size_t s = 0; s < noiseShapes().size(); ++s) {
    const Noise noise{{s, s}, {0.7, 1.9}};
    const VectorXd white = model.whiten(noise, r);
    for (const NoiseRun& run : layout.runs) {
      const MatrixXd c =
          noise.level[static_cast<std::size_t>(run.group)] * covariance(layout, run, noiseShapes()[s]);
      const MatrixXd factor = Eigen::LLT<MatrixXd>(c).matrixL();
      const VectorXd direct = factor.triangularView<Eigen::Lower>().solve(r.segment(run.first, run.count));
      EXPECT_LT((direct - white.segment(run.first, run.count)).norm(), 1e-10) << s;
    }
  }
}

TEST(NoiseModel, LikelihoodIsThatOfTheNormalDistribution) {
  const NoiseLayout layout = twoRuns();
  const NoiseModel model(layout);
  const VectorXd r = someResidual(16);
  const Noise noise{{9, 20}, {0.8, 1.3}};
  double direct = 0.0;
  for (const NoiseRun& run : layout.runs) {
    const auto g = static_cast<std::size_t>(run.group);
    const MatrixXd c = noise.level[g] * covariance(layout, run, noiseShapes()[noise.shape[g]]);
    const VectorXd part = r.segment(run.first, run.count);
    const double spread = std::log(noise.level[g]) / 0.6;
    direct += -0.5 * (std::log(c.determinant()) + part.dot(c.inverse() * part)) +
              noiseShapes()[noise.shape[g]].log_prior - 0.5 * spread * spread;
  }
  EXPECT_NEAR(model.logLikelihood(r, noise), direct, 1e-9);
}

TEST(NoiseModel, FindsTheOffsetFromRunToRunAndTheLevel) {
  std::mt19937_64 draw(11);
  std::normal_distribution<double> normal;
  NoiseLayout layout;
  layout.groups = 1;
  layout.place.resize(1200);
  VectorXd r(1200);
  for (Index run = 0; run < 40; ++run) {
    layout.runs.push_back({0, 30 * run, 30});
    const double offset = std::sqrt(0.5) * normal(draw);
    for (Index i = 0; i < 30; ++i) {
      layout.place[30 * run + i] = static_cast<double>(i);
      r[30 * run + i] = 1.4 * (offset + std::sqrt(0.5) * normal(draw));
    }
  }
  const NoiseModel model(layout);
  const Noise found = model.estimate(r).noise;
  EXPECT_NEAR(noiseShapes()[found.shape[0]].offset, 0.5, 0.26);
  EXPECT_EQ(noiseShapes()[found.shape[0]].correlated, 0.0);
  EXPECT_NEAR(std::sqrt(found.level[0]), 1.4, 0.2);
}

TEST(NoiseModel, LeaveOneOutIsTheConditionalResidual) {
  const NoiseLayout layout = twoRuns();
  const NoiseModel model(layout);
  const VectorXd r = someResidual(16);
  const Noise noise{{15, 15}, {1.0, 1.0}};
  const VectorXd z = model.leaveOneOut(noise, r);
  const NoiseRun& run = layout.runs[0];
  const MatrixXd p = covariance(layout, run, noiseShapes()[15]).inverse();
  const VectorXd part = r.segment(run.first, run.count);
  for (Index i = 0; i < run.count; ++i) {
    const double expected = (p * part)[i] / p(i, i) / std::sqrt(std::max(1.0 / p(i, i), 0.3));
    EXPECT_NEAR(z[i], expected, 1e-9);
  }
}

TEST(NoiseModel, AnOutlierNoLongerCounts) {
  NoiseModel model(twoRuns());
  VectorXd r = someResidual(16);
  std::vector<bool> outliers(16, false);
  outliers[4] = true;
  model.setOutliers(outliers);
  const double before = model.estimate(r).log_likelihood;
  r[4] += 8.0;
  EXPECT_NEAR(model.estimate(r).log_likelihood, before, 1.5);
}

}  // namespace
}  // namespace nineline::discovery
