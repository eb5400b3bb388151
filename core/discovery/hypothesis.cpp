#include "core/discovery/hypothesis.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace nineline::discovery {

namespace {

using Eigen::MatrixXd;

constexpr Index kFewFixed = 80;    // more than this, and the fixed part is whitened once only
constexpr double kSettled = 0.05;  // nats
constexpr std::size_t kSwaps = 5;
constexpr std::size_t kAdditions = 6;

RowMatrix rawColumns(const OptionBank& bank, const OptionSet& set, Index samples, VectorXd& prior) {
  Index count = 0;
  for (const std::size_t option : set) count += bank.options[option].raw.cols();
  RowMatrix raw(samples, count);
  prior.resize(count);
  Index at = 0;
  for (const std::size_t option : set) {
    const Index k = bank.options[option].raw.cols();
    raw.middleCols(at, k) = bank.options[option].raw;
    const double largest = bank.candidateOf(option).largest;
    prior.segment(at, k).setConstant(1.0 / (largest * largest));
    at += k;
  }
  return raw;
}

}  // namespace

Hypotheses::Hypotheses(const NoiseModel& model, const FixedPart& fixed, const VectorXd& residual)
    : model_(&model), fixed_(&fixed), residual_(residual) {}

Hypotheses::Whitened Hypotheses::whiten(const Noise& noise) const {
  Whitened space{noise, model_->whiten(noise, fixed_->columns), model_->whiten(noise, residual_), {}};
  MatrixXd normal = space.fixed.transpose() * space.fixed;
  normal.diagonal() += fixed_->precision;
  if (normal.rows() == 0) return space;
  normal.diagonal().array() += 1e-10 * normal.diagonal().mean() + 1e-30;
  space.inverse = Eigen::LLT<MatrixXd>(normal).solve(MatrixXd::Identity(normal.rows(), normal.cols()));
  return space;
}

void Hypotheses::fit(const Whitened& space, const RowMatrix& raw, const VectorXd& prior,
                     Verdict& verdict) const {
  const MatrixXd columns = model_->whiten(space.noise, raw);
  const MatrixXd between = space.fixed.transpose() * columns;
  const VectorXd fixed_right = space.fixed.transpose() * space.target;
  if (columns.cols() != 0) {
    MatrixXd normal = columns.transpose() * columns - between.transpose() * (space.inverse * between);
    normal.diagonal() += prior;
    normal.diagonal().array() += 1e-10 * normal.diagonal().mean() + 1e-30;
    const VectorXd right =
        columns.transpose() * space.target - between.transpose() * (space.inverse * fixed_right);
    verdict.coefficients = Eigen::LDLT<MatrixXd>(normal).solve(right);
  } else {
    verdict.coefficients.resize(0);
  }
  verdict.fixed = space.inverse * (fixed_right - between * verdict.coefficients);
  verdict.residual = residual_ - fixed_->columns * verdict.fixed - raw * verdict.coefficients;
}

Hypotheses::Verdict Hypotheses::judge(const Dictionary& dictionary, const OptionSet& set) const {
  VectorXd prior;
  const RowMatrix raw = rawColumns(dictionary.bank(), set, model_->sampleCount(), prior);
  Verdict best;
  double best_value = -std::numeric_limits<double>::infinity();
  const int rounds = fixed_->columns.cols() <= kFewFixed ? 4 : 1;
  for (int round = 0; round < rounds; ++round) {
    Verdict verdict;
    if (round == 0) {  // the dictionary has it all at its own noise
      verdict.coefficients = dictionary.fit(set).coefficients;
      verdict.fixed = dictionary.fixedBeside(set, verdict.coefficients);
      verdict.residual = residual_ - fixed_->columns * verdict.fixed - raw * verdict.coefficients;
    } else {
      fit(whiten(best.noise), raw, prior, verdict);
    }
    NoiseModel::Estimate noise = model_->estimate(verdict.residual);
    const double value = noise.log_likelihood -
                         0.5 * (prior.array() * verdict.coefficients.array().square()).sum() -
                         0.5 * (fixed_->precision.array() * verdict.fixed.array().square()).sum();
    verdict.noise = std::move(noise.noise);
    const bool settled = value < best_value + kSettled;
    if (value > best_value) {
      best_value = value;
      best = std::move(verdict);
    }
    if (settled) break;
  }
  best.score = -2.0 * best_value + dictionary.totalPenalty(set);
  return best;
}

namespace {

bool dropByLikelihood(const Dictionary& dictionary, const Hypotheses& hypotheses, OptionSet& set,
                      double& score, LikelihoodPolish& polish) {
  bool changed = false;
  while (!set.empty()) {
    Evidence least{0, std::numeric_limits<double>::infinity()};
    for (const std::size_t member : set) {
      const double worth = hypotheses.score(dictionary, without(set, member)) - score;
      if (worth < least.worth) least = {member, worth};
    }
    if (least.worth > polish.keep) return changed;
    if (least.worth > 0.0) polish.suspected.push_back(least);
    set = without(set, least.option);
    score += least.worth;
    changed = true;
  }
  return changed;
}

bool swapByLikelihood(Dictionary& dictionary, const Hypotheses& hypotheses, OptionSet& set, double& score) {
  constexpr double kFarBehind = 25.0;
  bool changed = false;
  for (const std::size_t member : OptionSet(set)) {
    const OptionSet rest = without(set, member);
    const VectorXd net = dictionary.netGains(rest);
    const double own = net[static_cast<Index>(member)];
    for (const std::size_t option : bestPerCandidate(dictionary, net, kSwaps)) {
      if (net[static_cast<Index>(option)] < own - kFarBehind) break;
      if (option == member || hasCandidateOf(dictionary, rest, option)) continue;
      OptionSet other = refine(dictionary, with(rest, option));
      const double value = hypotheses.score(dictionary, other);
      if (value >= score - 0.5 || !dictionary.isPlausible(other)) continue;
      set = std::move(other);
      score = value;
      changed = true;
      break;
    }
  }
  return changed;
}

bool addByLikelihood(Dictionary& dictionary, const Hypotheses& hypotheses, OptionSet& set, double& score,
                     double keep) {
  constexpr double kHopeless = -14.0;
  const VectorXd net = dictionary.netGains(set);
  for (const std::size_t option : bestPerCandidate(dictionary, net, kAdditions)) {
    if (net[static_cast<Index>(option)] < kHopeless) break;
    if (hasCandidateOf(dictionary, set, option)) continue;
    OptionSet longer = refine(dictionary, with(set, option));
    const double value = hypotheses.score(dictionary, longer);
    if (value >= score - keep || !dictionary.isPlausible(longer)) continue;
    set = std::move(longer);
    score = value;
    return true;
  }
  return false;
}

}  // namespace

OptionSet polishByLikelihood(Dictionary& dictionary, const Hypotheses& hypotheses, OptionSet set,
                             LikelihoodPolish& polish) {
  constexpr int kMostRounds = 4;
  double score = hypotheses.score(dictionary, set);
  for (int round = 0; round < kMostRounds; ++round) {
    bool changed = dropByLikelihood(dictionary, hypotheses, set, score, polish);
    changed = swapByLikelihood(dictionary, hypotheses, set, score) || changed;
    changed = addByLikelihood(dictionary, hypotheses, set, score, polish.keep) || changed;
    if (!changed) break;
  }
  return set;
}

}  // namespace nineline::discovery
