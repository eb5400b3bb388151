#include "core/discovery/gates.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>

namespace nineline::discovery {

namespace {

using Eigen::MatrixXd;

constexpr Index kBlock = 14;
constexpr int kFolds = 5;

double huber(double z) {
  const double a = std::abs(z);
  return a < 3.0 ? a * a : 6.0 * a - 9.0;
}

/// Coefficients of one member among those of its set.
VectorXd ownCoefficients(const Dictionary& dictionary, const OptionSet& set, std::size_t option,
                         const VectorXd& all) {
  Index at = 0;
  for (const std::size_t member : set) {
    const Index k = dictionary.whitenedColumns(member).cols();
    if (member == option) return all.segment(at, k);
    at += k;
  }
  return {};
}

}  // namespace

Gates::Gates(const NoiseModel& model, const FixedPart& fixed, const VectorXd& residual,
             const GateOptions& options)
    : model_(&model), fixed_(&fixed), residual_(residual), options_(options) {
  int block = 0;
  const std::vector<NoiseRun>& runs = model.layout().runs;
  has_zero_.assign(static_cast<std::size_t>(model.layout().groups), false);
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const Index count = std::max<Index>(1, (runs[r].count + kBlock / 2) / kBlock);
    for (Index i = 0; i < runs[r].count; ++i) {
      runs_.push_back(static_cast<int>(r));
      groups_.push_back(runs[r].group);
      blocks_.push_back(block + static_cast<int>(i * count / runs[r].count));
    }
    block += static_cast<int>(count);
    for (Index c = 0; c < fixed.columns.cols(); ++c) {
      if (fixed.precision[c] == 0.0 && fixed.columns(runs[r].first, c) != 0.0) {
        has_zero_[static_cast<std::size_t>(runs[r].group)] = true;
      }
    }
  }
}

VectorXd Gates::contribution(const Dictionary& dictionary, const OptionSet& set, std::size_t option) {
  const VectorXd own = ownCoefficients(dictionary, set, option, dictionary.fit(set).coefficients);
  return dictionary.bank().options[option].raw * own;
}

double Gates::bestRms(const Dictionary& dictionary, const OptionSet& set, std::size_t option) const {
  const VectorXd part = contribution(dictionary, set, option);
  const auto groups = static_cast<Index>(has_zero_.size());
  VectorXd sum = VectorXd::Zero(groups), squares = sum, count = sum;
  for (Index i = 0; i < part.size(); ++i) {
    const Index g = groups_[static_cast<std::size_t>(i)];
    sum[g] += part[i], squares[g] += part[i] * part[i], count[g] += 1.0;
  }
  double best = 0.0;
  for (Index g = 0; g < groups; ++g) {
    if (count[g] == 0.0) continue;
    const double mean = has_zero_[static_cast<std::size_t>(g)] ? sum[g] / count[g] : 0.0;
    best = std::max(best, squares[g] / count[g] - mean * mean);
  }
  return std::sqrt(best);
}

std::vector<int> Gates::unitsFor(const Dictionary& dictionary, std::size_t option, std::size_t fewest) const {
  std::map<int, double> energy;
  const RowMatrix& raw = dictionary.bank().options[option].raw;
  double most = 0.0;
  for (Index i = 0; i < raw.rows(); ++i)
    energy[runs_[static_cast<std::size_t>(i)]] += raw.row(i).squaredNorm();
  for (const auto& [run, e] : energy) most = std::max(most, e);
  const auto active = std::count_if(energy.begin(), energy.end(),
                                    [most](const auto& entry) { return entry.second > 0.05 * most; });
  return static_cast<std::size_t>(active) >= fewest ? runs_ : blocks_;
}

std::vector<int> Gates::foldsOf(const std::vector<int>& units) const {
  // Units of one group are dealt out in turn, each group beginning at another fold.
  std::map<int, int> fold_of_unit;
  std::map<int, int> next;
  std::vector<int> folds;
  for (std::size_t i = 0; i < units.size(); ++i) {
    const auto found = fold_of_unit.find(units[i]);
    if (found == fold_of_unit.end()) {
      int& turn = next.try_emplace(groups_[i], groups_[i] * 2).first->second;
      fold_of_unit[units[i]] = turn++ % kFolds;
    }
    folds.push_back(fold_of_unit[units[i]]);
  }
  return folds;
}

HeldOut Gates::heldOut(const Dictionary& dictionary, const OptionSet& set, std::size_t option) const {
  const std::vector<int> units = unitsFor(dictionary, option, 4);
  const std::vector<int> folds = foldsOf(units);
  OptionSet ordered = without(set, option);
  const Index rest_columns = dictionary.whitenedColumns(ordered).cols();
  ordered.push_back(option);
  const MatrixXd design = dictionary.projectedColumns(ordered);
  const VectorXd target = dictionary.projectedTarget();
  VectorXd gain = VectorXd::Zero(target.size());
  for (int fold = 0; fold < kFolds; ++fold) {
    std::vector<Index> train, test;
    for (Index i = 0; i < target.size(); ++i) {
      (folds[static_cast<std::size_t>(i)] == fold ? test : train).push_back(i);
    }
    if (test.empty() || train.empty()) continue;
    const MatrixXd x = design(train, Eigen::all);
    MatrixXd normal = x.transpose() * x;
    normal.diagonal().array() += 1e-9 * normal.diagonal().mean() + 1e-30;
    const VectorXd right = x.transpose() * target(train);
    const VectorXd full = Eigen::LDLT<MatrixXd>(normal).solve(right);
    const Index less = rest_columns;
    VectorXd short_fit(less);
    if (less != 0) {
      short_fit = Eigen::LDLT<MatrixXd>(normal.topLeftCorner(less, less)).solve(right.head(less));
    }
    for (const Index i : test) {
      const double with_it = target[i] - design.row(i).dot(full);
      const double without_it = target[i] - design.row(i).head(less).dot(short_fit);
      gain[i] = huber(without_it) - huber(with_it);
    }
  }
  std::map<int, std::pair<double, double>> by_unit;  // gain, energy of the option
  const MatrixXd own = dictionary.whitenedColumns(option);
  double most = 0.0;
  for (Index i = 0; i < target.size(); ++i) {
    auto& [g, e] = by_unit[units[static_cast<std::size_t>(i)]];
    g += gain[i], e += own.row(i).squaredNorm();
    most = std::max(most, e);
  }
  HeldOut result;
  double squares = 0.0;
  for (const auto& [unit, entry] : by_unit) {
    if (entry.second <= 0.02 * most) continue;
    result.gain += entry.first, squares += entry.first * entry.first, ++result.units;
  }
  const auto n = static_cast<double>(std::max<std::size_t>(result.units, 1));
  result.error = std::sqrt(std::max(squares - result.gain * result.gain / n, 0.0)) + 1e-9;
  return result;
}

double Gates::clusterInflation(const Dictionary& dictionary, const OptionSet& set, std::size_t option) const {
  const std::vector<int> units = unitsFor(dictionary, option, 8);
  const OptionSet rest = without(set, option);
  const VectorXd own = ownCoefficients(dictionary, set, option, dictionary.fit(set).coefficients);
  VectorXd direction = dictionary.projectedColumns({option}) * own;
  // What the rest cannot imitate.
  const MatrixXd design = dictionary.projectedColumns(rest);
  if (design.cols() != 0) {
    MatrixXd normal = design.transpose() * design;
    normal.diagonal().array() += 1e-9 * normal.diagonal().mean() + 1e-30;
    direction -= design * Eigen::LDLT<MatrixXd>(normal).solve(design.transpose() * direction);
  }
  const VectorXd residual = dictionary.whitenedResidual(set);
  std::map<int, double> sums;
  for (Index i = 0; i < residual.size(); ++i) {
    sums[units[static_cast<std::size_t>(i)]] += direction[i] * residual[i];
  }
  double clusters = 0.0;
  for (const auto& [unit, sum] : sums) clusters += sum * sum;
  const double plain = direction.squaredNorm();
  return plain <= 0.0 ? 1.0 : std::max(1.0, clusters / plain);
}

const Gates::PlainFixed& Gates::plainFixed() const {
  if (plain_fixed_) return *plain_fixed_;
  PlainFixed fixed{fixed_->columns, {}};
  for (Index i = 0; i < fixed.columns.rows(); ++i) {
    if (model_->outliers()[static_cast<std::size_t>(i)]) fixed.columns.row(i).setZero();
  }
  MatrixXd normal = fixed.columns.transpose() * fixed.columns;
  normal.diagonal() += fixed_->precision;
  normal.diagonal().array() *= 1.0 + 1e-9;
  normal.diagonal().array() += 1e-30;
  fixed.inverse = Eigen::LLT<MatrixXd>(normal).solve(MatrixXd::Identity(normal.rows(), normal.cols()));
  plain_fixed_ = std::move(fixed);
  return *plain_fixed_;
}

bool Gates::agrees(const Dictionary& dictionary, const OptionSet& set, std::size_t option) const {
  const Candidate& candidate = dictionary.bank().candidateOf(option);
  if (candidate.generic) return true;
  const PlainFixed& fixed = plainFixed();
  Index count = 0;
  for (const std::size_t member : set) count += dictionary.bank().options[member].raw.cols();
  RowMatrix design(model_->sampleCount(), count);
  Index at = 0;
  for (const std::size_t member : set) {
    const RowMatrix& raw = dictionary.bank().options[member].raw;
    design.middleCols(at, raw.cols()) = raw;
    at += raw.cols();
  }
  VectorXd target = residual_;
  for (Index i = 0; i < target.size(); ++i) {
    if (model_->outliers()[static_cast<std::size_t>(i)]) design.row(i).setZero(), target[i] = 0.0;
  }
  const MatrixXd between = fixed.columns.transpose() * design;
  const MatrixXd solved = fixed.inverse * between;
  MatrixXd normal = design.transpose() * design - between.transpose() * solved;
  normal.diagonal().array() *= 1.0 + 1e-9;
  normal.diagonal().array() += 1e-30;
  const VectorXd right =
      design.transpose() * target - solved.transpose() * (fixed.columns.transpose() * target);
  const VectorXd plain = Eigen::LDLT<MatrixXd>(normal).solve(right);
  const VectorXd ordinary = ownCoefficients(dictionary, set, option, plain);
  const VectorXd weighted = ownCoefficients(dictionary, set, option, dictionary.fit(set).coefficients);
  const double ratio = ordinary.norm() / std::max(weighted.norm(), 1e-300);
  return ordinary.dot(weighted) > 0.0 && ratio > 0.45 && ratio < 2.2;
}

std::string Gates::failedGate(const Dictionary& dictionary, const OptionSet& set, std::size_t option,
                              double worth) const {
  if (worth <= 0.0) return "evidence";
  if (bestRms(dictionary, set, option) < options_.least_rms) return "size";
  const HeldOut held_out = heldOut(dictionary, set, option);
  if (held_out.gain <= 0.0 || held_out.gain < options_.least_gain_to_error * held_out.error)
    return "held-out";
  const double gain = worth + dictionary.penalty(option);
  const double discounted = gain / clusterInflation(dictionary, set, option);
  if (discounted - dictionary.penalty(option) < options_.least_cluster_worth) return "chance";
  return agrees(dictionary, set, option) ? "" : "agreement";
}

OptionSet Gates::admit(const Dictionary& dictionary, OptionSet set, std::vector<Refusal>& refused) const {
  while (!set.empty()) {
    const double score = dictionary.score(set);
    Refusal weakest{0, "", std::numeric_limits<double>::infinity()};
    for (const std::size_t member : set) {
      const double worth = dictionary.score(without(set, member)) - score;
      if (worth >= weakest.worth) continue;
      const std::string gate = failedGate(dictionary, set, member, worth);
      if (!gate.empty()) weakest = {member, gate, worth};
    }
    if (weakest.gate.empty()) return set;
    refused.push_back(weakest);
    set = without(set, weakest.option);
  }
  return set;
}

}  // namespace nineline::discovery
