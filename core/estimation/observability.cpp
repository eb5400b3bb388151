#include "core/estimation/observability.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>

namespace nineline::estimation {

namespace {

// Priors count for little here, so that what they say is not taken for something that the readings tell.
constexpr double kPriorShare = 1e-4;
constexpr double kPartnerShare = 0.25;  // of the strongest partner, below which a chunk is not named

/// The Cholesky factor of the told parameters, which grows chunk by chunk.
class GrowingFactor {
 public:
  explicit GrowingFactor(const MatrixXd& scaled) : scaled_(scaled), factor_(scaled.rows(), scaled.rows()) {}

  /// What the readings say of a chunk with everything told before it unknown.
  [[nodiscard]] MatrixXd remaining(const std::vector<Index>& chunk) {
    const auto size = static_cast<Index>(chunk.size());
    half_ = MatrixXd(used(), size);
    for (Index k = 0; k < size; ++k) {
      for (Index i = 0; i < used(); ++i) {
        half_(i, k) = scaled_(told_[static_cast<std::size_t>(i)], chunk[static_cast<std::size_t>(k)]);
      }
    }
    factor_.topLeftCorner(used(), used()).triangularView<Eigen::Lower>().solveInPlace(half_);
    MatrixXd rest = scaled_(chunk, chunk) - half_.transpose() * half_;
    return 0.5 * (rest + rest.transpose());
  }
  /// Appends the chunk of the last `remaining`.
  void append(const std::vector<Index>& chunk, const MatrixXd& remaining) {
    const auto size = static_cast<Index>(chunk.size());
    const Index at = used();
    factor_.block(at, 0, size, at) = half_.transpose();
    factor_.block(at, at, size, size) = Eigen::LLT<MatrixXd>(remaining).matrixL();
    told_.insert(told_.end(), chunk.begin(), chunk.end());
  }
  /// The told parameters' motion that imitates the chunk of the last `remaining`.
  [[nodiscard]] MatrixXd imitation() const {
    return factor_.topLeftCorner(used(), used()).triangularView<Eigen::Lower>().transpose().solve(half_);
  }
  [[nodiscard]] const std::vector<Index>& told() const { return told_; }

 private:
  [[nodiscard]] Index used() const { return static_cast<Index>(told_.size()); }
  const MatrixXd& scaled_;
  MatrixXd factor_;
  MatrixXd half_;
  std::vector<Index> told_;
};

std::vector<std::size_t> partnersOf(const GrowingFactor& factor, const MatrixXd& scaled,
                                    const std::vector<std::size_t>& chunk_of) {
  const MatrixXd imitation = factor.imitation();
  std::vector<std::pair<double, std::size_t>> strength;
  for (std::size_t i = 0; i < factor.told().size(); ++i) {
    const Index parameter = factor.told()[i];
    const double part = imitation.row(static_cast<Index>(i)).norm() * std::sqrt(scaled(parameter, parameter));
    const std::size_t chunk = chunk_of[static_cast<std::size_t>(parameter)];
    const auto known = std::find_if(strength.begin(), strength.end(),
                                    [chunk](const auto& one) { return one.second == chunk; });
    if (known == strength.end()) {
      strength.emplace_back(part * part, chunk);
    } else {
      known->first += part * part;
    }
  }
  std::sort(strength.begin(), strength.end(), std::greater<>());
  std::vector<std::size_t> partners;
  for (const auto& [square, chunk] : strength) {
    if (square <= 0.0 || square < kPartnerShare * kPartnerShare * strength.front().first) break;
    partners.push_back(chunk);
  }
  return partners;
}

}  // namespace

std::vector<Telling> tellApart(const MatrixXd& information, const VectorXd& plausible,
                               std::span<const ParameterChunk> chunks) {
  const MatrixXd scaled = plausible.asDiagonal() * information * plausible.asDiagonal();
  std::vector<std::size_t> chunk_of(static_cast<std::size_t>(plausible.size()), 0);
  GrowingFactor factor(scaled);
  std::vector<Telling> tellings(chunks.size());
  for (std::size_t c = 0; c < chunks.size(); ++c) {
    const std::vector<Index>& chunk = chunks[c].parameters;
    Telling& telling = tellings[c];
    for (const Index parameter : chunk) chunk_of[static_cast<std::size_t>(parameter)] = c;
    const MatrixXd own = scaled(chunk, chunk);
    const double largest = own.diagonal().maxCoeff();
    telling.has_influence = largest > 1.0;
    if (!telling.has_influence) continue;
    MatrixXd remaining = factor.remaining(chunk);
    const VectorXd values =
        Eigen::SelfAdjointEigenSolver<MatrixXd>(remaining, Eigen::EigenvaluesOnly).eigenvalues();
    telling.directions = (values.array() > std::max(1.0, kRankTolerance * largest)).count();
    telling.told = 2 * telling.directions > static_cast<Index>(chunk.size());
    if (!telling.told) {
      telling.partners = partnersOf(factor, scaled, chunk_of);
      continue;
    }
    if (chunks[c].prior.size() > 0) {
      const VectorXd unit = plausible(chunk);
      remaining += kPriorShare * (unit.asDiagonal() * chunks[c].prior * unit.asDiagonal());
    }
    factor.append(chunk, remaining);
  }
  return tellings;
}

Rank rankOf(const MatrixXd& information, const VectorXd& plausible) {
  const MatrixXd scaled = plausible.asDiagonal() * information * plausible.asDiagonal();
  Rank rank;
  if (scaled.rows() == 0) return rank;
  rank.eigenvalues = Eigen::SelfAdjointEigenSolver<MatrixXd>(scaled, Eigen::EigenvaluesOnly).eigenvalues();
  rank.rank = (rank.eigenvalues.array() > kRankTolerance * rank.eigenvalues.maxCoeff()).count();
  return rank;
}

}  // namespace nineline::estimation
