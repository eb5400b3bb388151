#include "core/identification/nine_line_runs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/kinematics/chain.h"
#include "tests/support/random_machines.h"

namespace nineline::identification {
namespace {

constexpr std::size_t kRuns = 5;
constexpr double kNoise = 0.3e-3;  // mm, of a single reading

struct Campaign {
  LineSetup setup = makeNineLineSetup({'X', 0}, {0, {0, 0, 0}, 300.0, 300.0, LineSet::Full});
  LineRuns runs;
  Vector3d reversal{2e-3, 0.0, 0.0};  // mm: forward minus backward, whole
};

Vector3d deltaAt(double q) { return {1e-5 * q, 1e-3 * std::sin(q / 50.0), 0.0}; }
Vector3d epsilonAt(double q) { return {1e-7 * q, -2e-7 * q, 1e-5 * std::sin(q / 80.0)}; }

Campaign campaign(unsigned seed, double noise) {
  Campaign result;
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> scatter(0.0, 1.0);
  const std::size_t readings = result.setup.readings.size();
  result.runs.forward.resize(readings);
  result.runs.backward.resize(readings);
  for (int p = 0; p < 9; ++p) {
    const double q = 40.0 * p;
    result.runs.positions.push_back(q);
    const std::vector<double> there =
        predictLines(result.setup, deltaAt(q) - deltaAt(0), epsilonAt(q) - epsilonAt(0));
    const std::vector<double> back =
        predictLines(result.setup, deltaAt(q) - deltaAt(0) - result.reversal, epsilonAt(q) - epsilonAt(0));
    for (std::size_t k = 0; k < readings; ++k) {
      std::vector<double> forward, backward;
      for (std::size_t j = 0; j < kRuns; ++j) {
        const double zero = 0.01 * static_cast<double>(j);  // every run has its own
        forward.push_back(zero + there[k] + (p == 0 ? 0.0 : noise * scatter(engine)));
        backward.push_back(zero + back[k] + noise * scatter(engine));
      }
      result.runs.forward[k].push_back(forward);
      result.runs.backward[k].push_back(backward);
    }
  }
  return result;
}

TEST(NineLineRuns, TellsTableFromReversal) {
  const Campaign clean = campaign(1, 0.0);
  const Result<BidirectionalLines> found = identifyLineRuns(clean.setup, clean.runs);
  ASSERT_TRUE(found) << found.error().text;
  for (std::size_t p = 0; p < clean.runs.positions.size(); ++p) {
    const double q = clean.runs.positions[p];
    EXPECT_NEAR(*found->table[p].value[0], deltaAt(q).x() - 1e-3, 1e-9);
    EXPECT_NEAR(*found->reversal[p].value[0], 1e-3, 1e-9);
    EXPECT_NEAR(*found->reversal[p].value[1], 0.0, 1e-9);
    EXPECT_NEAR(*found->table[p].value[5], epsilonAt(q).z(), 1e-12);
  }
  EXPECT_TRUE(found->blunders.empty());
}

/// s/√K and the type B part in quadrature, pooled over the positions.
TEST(NineLineRuns, CombinesScatterAndTypeB) {
  const Campaign noisy = campaign(2, kNoise);
  const LineMeans means = meansOf(noisy.setup, noisy.runs, false);
  for (std::size_t k = 0; k < noisy.setup.readings.size(); ++k) {
    EXPECT_TRUE(means.is_pooled[k]);
    EXPECT_NEAR(means.scatter[k][3], kNoise, 0.45 * kNoise);
    EXPECT_EQ(means.scatter[k][0], 0.0);  // the datum is zero in every run
    EXPECT_NEAR(means.sigma[k][3],
                std::hypot(noisy.setup.readings[k].sigma, means.scatter[k][3] / std::sqrt(5.0)), 1e-15);
  }
}

/// 95 % of errors within 2 sigma over 200 seeded campaigns, type B error included as a fresh draw each time.
TEST(NineLineRuns, StatesUncertaintiesThatCover) {
  int inside = 0, all = 0, blunders = 0, positions = 0;
  for (unsigned seed = 100; seed < 300; ++seed) {
    Campaign noisy = campaign(seed, kNoise);
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> scatter(0.0, 1.0);
    for (std::size_t k = 0; k < noisy.setup.readings.size(); ++k) {
      for (std::size_t p = 1; p < noisy.runs.positions.size(); ++p) {
        const double type_b = noisy.setup.readings[k].sigma * scatter(engine);
        for (double& value : noisy.runs.forward[k][p]) value += type_b;
      }
    }
    const BidirectionalLines found = identifyLineRuns(noisy.setup, noisy.runs).value();
    for (std::size_t p = 1; p < noisy.runs.positions.size(); ++p) {
      const double q = noisy.runs.positions[p];
      Eigen::Matrix<double, 6, 1> truth;
      truth << deltaAt(q) - deltaAt(0), epsilonAt(q) - epsilonAt(0);
      for (std::size_t row = 0; row < 6; ++row, ++all) {
        const LineErrors& here = found.forward.positions[p];
        inside +=
            std::abs(*here.value[row] - truth(static_cast<Eigen::Index>(row))) <= 2.0 * *here.sigma[row];
      }
      blunders += found.forward.positions[p].is_blunder;
      ++positions;
    }
  }
  const double coverage = static_cast<double>(inside) / all;
  EXPECT_GT(coverage, 0.94);
  EXPECT_LT(coverage, 0.97);
  EXPECT_LE(blunders, 8);  // 0.1 % of 1600 expected
  std::printf("coverage %.4f of %d, %d false blunders in %d positions\n", coverage, all, blunders, positions);
}

TEST(NineLineRuns, FlagsABlunder) {
  Campaign noisy = campaign(7, kNoise);
  for (double& value : noisy.runs.forward[2][5]) value += 10e-3;  // one straightness reading, 10 um off
  const BidirectionalLines found = identifyLineRuns(noisy.setup, noisy.runs).value();
  EXPECT_THAT(found.blunders, testing::ElementsAre(5U));
}

/// One position that scatters ten times as much as the others keeps its own s.
TEST(NineLineRuns, DoesNotPoolWhatDiffers) {
  Campaign noisy = campaign(7, kNoise);
  for (std::size_t j = 0; j < kRuns; ++j) noisy.runs.forward[0][4][j] += (j % 2 == 0 ? 1.0 : -1.0) * 3e-3;
  const LineMeans means = meansOf(noisy.setup, noisy.runs, false);
  EXPECT_FALSE(means.is_pooled[0]);
  EXPECT_GT(means.scatter[0][4], 2e-3);
  EXPECT_LT(means.scatter[0][5], 1e-3);
}

TEST(NineLineRuns, RefusesUnequalRuns) {
  Campaign broken = campaign(1, 0.0);
  broken.runs.backward[3][2].pop_back();
  EXPECT_NE(identifyLineRuns(broken.setup, broken.runs).error().text.find("Reading 4 at position 3"),
            std::string::npos);
  broken.runs.backward.clear();
  EXPECT_TRUE(identifyLineRuns(broken.setup, broken.runs));
  broken.runs.datum = 99;
  EXPECT_FALSE(identifyLineRuns(broken.setup, broken.runs));
}

}  // namespace
}  // namespace nineline::identification
