#include "core/discovery/dictionary.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>
#include <random>

#include "core/discovery/gates.h"
#include "core/discovery/hypothesis.h"

namespace nineline::discovery {
namespace {

using Eigen::MatrixXd;

constexpr Index kRuns = 12;
constexpr Index kEach = 25;
constexpr Index kSamples = kRuns * kEach;

NoiseLayout layoutOf() {
  NoiseLayout layout;
  layout.groups = 1;
  layout.place.resize(kSamples);
  for (Index run = 0; run < kRuns; ++run) layout.runs.push_back({0, run * kEach, kEach});
  for (Index i = 0; i < kSamples; ++i) layout.place[i] = static_cast<double>(i % kEach);
  return layout;
}

/// Position −1…1 there and back, its sense, and a condition that differs from run to run.
struct Samples {
  VectorXd x{kSamples}, sense{kSamples}, warmth{kSamples};
  Samples() {
    for (Index i = 0; i < kSamples; ++i) {
      const double at = static_cast<double>(i % kEach) / static_cast<double>(kEach - 1);
      x[i] = at < 0.5 ? 4.0 * at - 1.0 : 3.0 - 4.0 * at;
      sense[i] = at < 0.5 ? 1.0 : -1.0;
      warmth[i] = std::sin(1.7 * static_cast<double>(i / kEach));
    }
  }
};

Candidate candidate(const std::string& name, const VectorXd& column) {
  Candidate one;
  one.name = name;
  one.columns = [column](std::span<const double>) -> RowMatrix { return column; };
  return one;
}

OptionBank bankOf(const Samples& s) {
  OptionBank bank;
  bank.add(candidate("scale", s.x));
  bank.add(candidate("backlash", s.sense));
  bank.add(candidate("bow", s.x.cwiseProduct(s.x)));
  bank.add(candidate("growth", s.x.cwiseProduct(s.warmth)));
  bank.add(candidate("windup", s.x.cwiseProduct(s.sense)));
  Candidate wave;
  wave.name = "wave";
  wave.nonlinear = {{"n", 2.5, 6.0, {3.0, 4.0, 5.0}, false}};
  wave.columns = [x = s.x](std::span<const double> shape) {
    RowMatrix columns(kSamples, 2);
    columns.col(0) = (shape[0] * x).array().sin();
    columns.col(1) = (shape[0] * x).array().cos();
    return columns;
  };
  bank.add(wave);
  return bank;
}

FixedPart zeroOf() { return {RowMatrix::Ones(kSamples, 1), VectorXd::Zero(1)}; }

VectorXd noiseOf(std::uint64_t seed, double run_offset = 0.3) {
  std::mt19937_64 draw(seed);
  std::normal_distribution<double> normal;
  VectorXd r(kSamples);
  for (Index run = 0; run < kRuns; ++run) {
    const double offset = run_offset * normal(draw);
    for (Index i = 0; i < kEach; ++i) {
      r[run * kEach + i] = offset + std::sqrt(1.0 - run_offset * run_offset) * normal(draw);
    }
  }
  return r;
}

Noise whiteNoise() { return {{0}, {1.0}}; }

TEST(Dictionary, OneColumnInWhiteNoiseIsWorthItsAnalyticGain) {
  const Samples s;
  OptionBank bank;
  bank.add(candidate("scale", s.x));
  const NoiseModel model(layoutOf());
  const FixedPart none{RowMatrix(kSamples, 0), VectorXd(0)};
  const VectorXd r = 0.7 * s.x + noiseOf(3);
  const Dictionary dictionary(model, whiteNoise(), none, r, bank);
  const double xx = s.x.squaredNorm() + 1e-12, xr = s.x.dot(r);
  EXPECT_NEAR(dictionary.gains({})[0], xr * xr / xx, 1e-9 * xr * xr / xx);
  EXPECT_NEAR(dictionary.fit({0}).coefficients[0], xr / xx, 1e-8);
  EXPECT_NEAR(dictionary.fit({0}).covariance(0, 0), 1.0 / xx, 1e-8 / xx);
  EXPECT_NEAR(dictionary.sumOfSquares({}), r.squaredNorm(), 1e-9 * r.squaredNorm());
}

TEST(Dictionary, AgreesWithAFactorisationOfTheWholeDesign) {
  const Samples s;
  OptionBank bank = bankOf(s);
  const NoiseModel model(layoutOf());
  const FixedPart zero = zeroOf();
  const VectorXd r = 0.7 * s.x + 0.4 * s.sense + noiseOf(4);
  const Noise noise{{21}, {1.2}};
  const Dictionary dictionary(model, noise, zero, r, bank);
  const OptionSet set{0, 1, 6};  // the second wave has two columns
  MatrixXd design(kSamples, 5);
  design << zero.columns, bank.options[0].raw, bank.options[1].raw, bank.options[6].raw;
  const MatrixXd white = model.whiten(noise, RowMatrix(design));
  const VectorXd target = model.whiten(noise, r);
  const VectorXd b = white.householderQr().solve(target);
  EXPECT_LT((b.tail(4) - dictionary.fit(set).coefficients).norm(), 1e-6);
  EXPECT_NEAR(dictionary.sumOfSquares(set), (target - white * b).squaredNorm(), 1e-6);
  EXPECT_LT((dictionary.whitenedResidual(set) - (target - white * b)).norm(), 1e-5);
  const double gain = dictionary.sumOfSquares({0}) - dictionary.sumOfSquares({0, 1});
  EXPECT_NEAR(dictionary.gains({0})[1], gain, 1e-6 * gain);
}

TEST(Search, FindsThePlantedPairAndItsWave) {
  const Samples s;
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
    OptionBank bank = bankOf(s);
    const NoiseModel model(layoutOf());
    const FixedPart zero = zeroOf();
    const VectorXd r = 1.1 * s.sense + 3.0 * (3.37 * s.x).array().sin().matrix() + noiseOf(seed);
    Dictionary dictionary(model, model.declared(), zero, r, bank);
    const OptionSet set = search(dictionary, {});
    ASSERT_EQ(set.size(), 2U) << seed;
    for (const std::size_t member : set) {
      const std::string& name = bank.name(member);
      EXPECT_TRUE(name == "backlash" || name == "wave") << seed << " " << name;
      if (name != "wave") continue;
      EXPECT_NEAR(bank.options[member].shape[0], 3.37, 0.12) << seed;
    }
  }
}

TEST(Search, FindsNothingWhereNothingIs) {
  const Samples s;
  int false_ones = 0;
  for (std::uint64_t seed = 100; seed < 400; ++seed) {
    OptionBank bank = bankOf(s);
    const NoiseModel model(layoutOf());
    const FixedPart zero = zeroOf();
    const VectorXd r = noiseOf(seed);
    Dictionary dictionary(model, model.declared(), zero, r, bank);
    OptionSet set = search(dictionary, {});
    LikelihoodPolish polish;
    set = polishByLikelihood(dictionary, Hypotheses(model, zero, r), set, polish);
    false_ones += set.empty() ? 0 : 1;
  }
  EXPECT_LE(false_ones, 1);  // of 300
}

TEST(Search, DoesNotDependOnTheOrderOfCandidatesOrOnADuplicate) {
  const Samples s;
  const NoiseModel model(layoutOf());
  const FixedPart zero = zeroOf();
  const VectorXd r = 1.2 * s.sense - 0.9 * s.x + noiseOf(9);
  const auto namesFound = [&](OptionBank bank) {
    Dictionary dictionary(model, model.declared(), zero, r, bank);
    std::vector<std::string> names;
    SearchOptions options;
    options.margin = 8.0;  // as the product's passes
    for (const std::size_t member : search(dictionary, options)) names.push_back(bank.name(member));
    std::sort(names.begin(), names.end());
    return names;
  };
  OptionBank turned;
  const OptionBank plain = bankOf(s);
  for (std::size_t c = plain.candidates.size(); c-- > 0;) turned.add(plain.candidates[c]);
  turned.add(candidate("constant", VectorXd::Ones(kSamples)));
  const std::vector<std::string> found = namesFound(bankOf(s));
  EXPECT_EQ(std::count(found.begin(), found.end(), "backlash"), 1);
  EXPECT_EQ(std::count(found.begin(), found.end(), "scale"), 1);
  EXPECT_EQ(namesFound(turned), found);
}

TEST(Hypotheses, RunOffsetsAreNotTakenForAConditionThatFollowsTheRuns) {
  const Samples s;
  OptionBank bank = bankOf(s);
  bank.add(candidate("drift", s.warmth));
  const std::size_t drift = bank.options.size() - 1;
  const NoiseModel model(layoutOf());
  const FixedPart zero = zeroOf();
  const VectorXd r = noiseOf(21, 0.8);
  const Dictionary dictionary(model, model.declared(), zero, r, bank);
  const Hypotheses hypotheses(model, zero, r);
  EXPECT_GT(hypotheses.score(dictionary, {drift}), hypotheses.score(dictionary, {}));
}

TEST(Gates, RefuseWhatOnlyOneRunShows) {
  const Samples s;
  OptionBank bank;
  bank.add(candidate("bow", s.x.cwiseProduct(s.x)));
  const NoiseModel model(layoutOf());
  const FixedPart zero = zeroOf();
  VectorXd r = noiseOf(5);
  const VectorXd bow = s.x.cwiseProduct(s.x);
  r.segment(3 * kEach, kEach) += 14.0 * bow.segment(3 * kEach, kEach);
  const Dictionary dictionary(model, model.declared(), zero, r, bank);
  ASSERT_LT(dictionary.score({0}), dictionary.score({}));
  std::vector<Refusal> refused;
  const Gates gates(model, zero, r, {});
  EXPECT_TRUE(gates.admit(dictionary, {0}, refused).empty());
  ASSERT_EQ(refused.size(), 1U);
}

TEST(Gates, AdmitWhatEveryRunShows) {
  const Samples s;
  OptionBank bank;
  bank.add(candidate("backlash", s.sense));
  const NoiseModel model(layoutOf());
  const FixedPart zero = zeroOf();
  const VectorXd r = 0.8 * s.sense + noiseOf(6);
  const Dictionary dictionary(model, model.declared(), zero, r, bank);
  std::vector<Refusal> refused;
  const Gates gates(model, zero, r, {});
  EXPECT_EQ(gates.admit(dictionary, {0}, refused), OptionSet{0});
  EXPECT_NEAR(gates.bestRms(dictionary, {0}, 0), 0.8, 0.15);
  EXPECT_LT(gates.clusterInflation(dictionary, {0}, 0), 4.0);
}

}  // namespace
}  // namespace nineline::discovery
