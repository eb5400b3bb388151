#include "core/estimation/design.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "core/estimation/observability.h"

namespace nineline::estimation {

namespace {

/// Information in plausible units, with the plausible sizes as knowledge of their own.
MatrixXd withPlausible(const MatrixXd& information, const VectorXd& plausible) {
  MatrixXd scaled = plausible.asDiagonal() * information * plausible.asDiagonal();
  scaled.diagonal().array() += 1.0;
  return scaled;
}

struct Size {
  double log_determinant = 0.0;
  double variance = 0.0;
};

Size sizeOf(const MatrixXd& matrix) {
  const Eigen::LLT<MatrixXd> factor(matrix);
  const MatrixXd lower = factor.matrixL();
  Size size;
  size.log_determinant = 2.0 * lower.diagonal().array().log().sum();
  size.variance = factor.solve(MatrixXd::Identity(matrix.rows(), matrix.cols())).trace();
  return size;
}

}  // namespace

std::vector<SetupGain> chooseSetups(const MatrixXd& known, std::span<const MatrixXd> setups,
                                    const VectorXd& plausible, Criterion criterion, std::size_t count) {
  MatrixXd matrix = withPlausible(known, plausible);
  Size size = sizeOf(matrix);
  std::vector<SetupGain> chosen;
  while (chosen.size() < count) {
    std::optional<SetupGain> best;
    Size best_size;
    for (std::size_t s = 0; s < setups.size(); ++s) {
      const MatrixXd more = plausible.asDiagonal() * setups[s] * plausible.asDiagonal();
      const Size with = sizeOf(matrix + more);
      const SetupGain gain{s, with.log_determinant - size.log_determinant, size.variance - with.variance};
      const bool better =
          !best || (criterion == Criterion::D ? gain.d_gain > best->d_gain : gain.a_gain > best->a_gain);
      if (better) best = gain, best_size = with;
    }
    if (!best) break;
    matrix += plausible.asDiagonal() * setups[best->setup] * plausible.asDiagonal();
    size = best_size;
    chosen.push_back(*best);
  }
  return chosen;
}

PlanQuality qualityOf(const MatrixXd& information, const VectorXd& plausible) {
  PlanQuality quality;
  quality.asked = plausible.size();
  if (quality.asked == 0) return quality;
  const MatrixXd matrix = withPlausible(information, plausible);
  const MatrixXd covariance =
      Eigen::LLT<MatrixXd>(matrix).solve(MatrixXd::Identity(matrix.rows(), matrix.cols()));
  quality.sigma = plausible.cwiseProduct(covariance.diagonal().cwiseSqrt());
  quality.quality = 1.0 - covariance.diagonal().mean();
  const VectorXd unit = information.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const MatrixXd scaled = unit.asDiagonal() * information * unit.asDiagonal();
  const VectorXd values =
      Eigen::SelfAdjointEigenSolver<MatrixXd>(scaled, Eigen::EigenvaluesOnly).eigenvalues();
  const double largest = values.maxCoeff();
  double smallest = largest;
  for (const double value : values) {
    if (value <= kRankTolerance * largest) continue;
    smallest = std::min(smallest, value);
    ++quality.told;
  }
  quality.condition_number = largest > 0.0 ? std::sqrt(largest / smallest) : 0.0;
  return quality;
}

}  // namespace nineline::estimation
