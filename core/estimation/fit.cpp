#include "core/estimation/fit.h"

#include <Eigen/Eigenvalues>

namespace nineline::estimation {

std::size_t Fit::outliers() const { return static_cast<std::size_t>((weights.array() <= 0.0).count()); }

namespace {

constexpr int kNoiseSteps = 12;
constexpr double kSettled = 1e-2;         // relative change of noise levels
constexpr double kSettledWeights = 0.02;  // change of any reading's weight
constexpr double kSmallStep = 1e-12;      // mm, rad: a prediction that changes less has settled
// By the noise; the next step would be 1e-4 of it. Levels that are estimated may shrink towards 0 with it.
constexpr double kSmallStepSigmas = 1e-2;
constexpr double kSmallStepEstimated = 1e-5;

class Fitter {
 public:
  Fitter(Linearisation& linearisation, const Eigen::SparseMatrix<double>& map, const Precision& prior,
         const FitOptions& options, Progress& progress)
      : linearisation_(linearisation),
        readings_(linearisation.readings()),
        map_(map),
        prior_(prior),
        options_(options),
        progress_(progress) {
    fit_.parameters = VectorXd::Zero(map.cols());
    fit_.noise = usualNoise(readings_);
    if (!options.estimate_noise) std::fill(fit_.noise.ratio.begin(), fit_.noise.ratio.end(), 0.0);
    fit_.weights = VectorXd::Ones(static_cast<Index>(readings_.rows()));
  }

  Result<Fit> run() {
    if (Result<void> done = linearisation_.at(map_ * fit_.parameters, true, progress_); !done) {
      return done.error();
    }
    if (Result<void> done = firstSolution(); !done) return done.error();
    for (fit_.linearisations = 1; fit_.linearisations < options_.linearisations;) {
      if (Result<void> done = refine(); !done) return done.error();
      if (hasSettled()) return finished();
    }
    return noAnswer(
        "estimation.convergence",
        "The fit does not settle: the errors are too large, or the readings contradict each other.");
  }

 private:
  [[nodiscard]] bool adapts() const { return options_.estimate_noise || options_.robust.enabled; }

  void sumUp() { sums_ = normalSums(linearisation_, fit_.weights).reduced(map_); }

  /// Without `with_covariance` the covariance stays that of the last solution that had one.
  Result<void> solveOnce(bool with_covariance) {
    Result<MixedSolution> solution =
        solve(readings_, sums_, fit_.noise, prior_, fit_.parameters, with_covariance);
    if (!solution) return solution.error();
    if (!with_covariance) solution->covariance = std::move(solution_.covariance);
    solution_ = std::move(*solution);
    change_ = linearisation_.times(map_ * solution_.step);
    fit_.rest = restOf(linearisation_, change_, solution_);
    return {};
  }

  /// Solves and adapts the noise levels to what remains, until both agree.
  Result<void> settleNoise(int steps) {
    for (int step = 0; step < steps; ++step) {
      if (Result<void> done = solveOnce(adapts()); !done) return done;
      if (!options_.estimate_noise) return {};
      const NoiseLevels before = fit_.noise;
      fit_.noise = updatedNoise(readings_, sums_, before, solution_, fit_.rest, fit_.weights);
      double change = 0.0;
      for (std::size_t c = 0; c < before.scale.size(); ++c) {
        change = std::max(change, std::abs(fit_.noise.scale[c] / before.scale[c] - 1.0));
        change = std::max(change, std::abs(fit_.noise.ratio[c] - before.ratio[c]) / (0.1 + before.ratio[c]));
      }
      if (change < kSettled) break;
    }
    return solveOnce(false);
  }

  Result<void> firstSolution() {
    sumUp();
    if (!options_.robust.enabled) return settleNoise(kNoiseSteps);
    if (Result<void> done = settleNoise(3); !done) return done;
    if (Result<void> done = reweight(); !done) return done;
    return leaveOut();
  }

  /// Readings left over by the fit, by class.
  [[nodiscard]] std::vector<double> freedom() const {
    std::vector<double> share;
    const Index p = sums_.size();
    for (std::size_t c = 0; c < sums_.matrix.size(); ++c) {
      const double taken = solution_.covariance.topLeftCorner(p, p).cwiseProduct(sums_.matrix[c]).sum() /
                           (fit_.noise.scale[c] * fit_.noise.scale[c]);
      share.push_back(1.0 - taken / std::max(1.0, sums_.count[c]));
    }
    return share;
  }

  /// Huber's loss by reweighting, with levels that outliers do not reach.
  Result<void> reweight() {
    const std::vector<double> share = freedom();
    for (int step = 0; step < options_.robust.iterations; ++step) {
      if (progress_.isCancelled()) return cancelled();
      fit_.noise.scale = robustScales(readings_, fit_.rest, share);
      const VectorXd before = fit_.weights;
      fit_.weights = huberWeights(readings_, fit_.noise, fit_.rest, options_.robust.huber);
      if ((fit_.weights - before).cwiseAbs().maxCoeff() < kSettledWeights) break;
      sumUp();
      if (Result<void> done = solveOnce(false); !done) return done;
    }
    fit_.noise.scale = robustScales(readings_, fit_.rest, share);
    return solveOnce(true);
  }

  /// Leaves outliers out and lets the rest count fully, until the set of outliers stands.
  Result<void> leaveOut() {
    for (int step = 0; step < options_.robust.iterations; ++step) {
      VectorXd weights = outlierWeights(linearisation_, sums_, fit_.noise, map_, solution_, fit_.rest,
                                        fit_.weights, options_.robust.outlier);
      if (step > 0 && weights == fit_.weights) return {};
      fit_.weights = std::move(weights);
      sumUp();
      if (Result<void> done = settleNoise(kNoiseSteps); !done) return done;
    }
    return {};
  }

  /// Goes to the solution, predicts exactly there and solves again.
  Result<void> refine() {
    fit_.parameters += solution_.step;
    if (Result<void> done = linearisation_.at(map_ * fit_.parameters, false, progress_); !done) return done;
    ++fit_.linearisations;
    const NormalSums residuals = fullSums();
    for (std::size_t c = 0; c < residuals.right.size(); ++c) {
      sums_.right[c] = map_.transpose() * residuals.right[c];
    }
    sums_.square = residuals.square;
    sums_.group_right = residuals.group_right;
    // The first refinement may show that the noise is smaller than what was not linear.
    return options_.estimate_noise && fit_.linearisations <= 3 ? settleNoise(2) : solveOnce(false);
  }

  [[nodiscard]] NormalSums fullSums() const {
    NormalSums sums;
    const Index n = linearisation_.unknowns().size();
    sums.right.assign(sums_.right.size(), VectorXd::Zero(n));
    sums.square.assign(sums_.square.size(), 0.0);
    sums.group_right = VectorXd::Zero(sums_.group_right.size());
    updateRight(linearisation_, fit_.weights, sums);
    return sums;
  }

  [[nodiscard]] bool hasSettled() {
    fit_.last_step = change_.size() == 0 ? 0.0 : change_.cwiseAbs().maxCoeff();
    double relative = 0.0;
    for (std::size_t row = 0; row < readings_.rows(); ++row) {
      const double sigma = fit_.noise.scale[readings_.noiseOf(row)] * readings_.readings()[row].sigma;
      relative = std::max(relative, std::abs(change_[static_cast<Index>(row)]) / sigma);
    }
    return fit_.last_step < kSmallStep ||
           relative < (options_.estimate_noise ? kSmallStepEstimated : kSmallStepSigmas);
  }

  Result<Fit> finished() {
    fit_.parameters += solution_.step;
    Result<MixedSolution> last = solve(readings_, sums_, fit_.noise, prior_, fit_.parameters, true);
    if (!last) return last.error();
    const Index p = map_.cols();
    fit_.covariance = last->covariance.topLeftCorner(p, p);
    if (options_.estimate_noise) {
      fit_.file_factors =
          fileFactors(linearisation_, sums_, fit_.noise, map_, *last, fit_.rest, fit_.weights);
    }
    fit_.zeros = solution_.zeros;
    fit_.offsets = solution_.offsets;
    fit_.condition_number = conditionNumber(information(readings_, sums_, fit_.noise) + prior_);
    return std::move(fit_);
  }

  [[nodiscard]] static double conditionNumber(const MatrixXd& matrix) {
    if (matrix.rows() == 0) return 1.0;
    const VectorXd unit = matrix.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    const MatrixXd scaled = unit.asDiagonal() * matrix * unit.asDiagonal();
    const VectorXd values =
        Eigen::SelfAdjointEigenSolver<MatrixXd>(scaled, Eigen::EigenvaluesOnly).eigenvalues();
    return std::sqrt(values.maxCoeff() / std::max(values.minCoeff(), 1e-300));
  }

  Linearisation& linearisation_;
  const ReadingSet& readings_;
  const Eigen::SparseMatrix<double>& map_;
  const Precision& prior_;
  const FitOptions& options_;
  Progress& progress_;
  Fit fit_;
  NormalSums sums_;
  MixedSolution solution_;
  VectorXd change_;  // of the predictions by the last step
};

}  // namespace

Result<Fit> fit(Linearisation& linearisation, const Eigen::SparseMatrix<double>& map, const Precision& prior,
                const FitOptions& options, Progress& progress) {
  return Fitter(linearisation, map, prior, options, progress).run();
}

}  // namespace nineline::estimation
