#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace nineline::discovery {

/// Samples run down the rows, so that a filter in time works on whole rows.
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Eigen::Index;
using Eigen::VectorXd;

/// One uninterrupted stretch of one reading: consecutive samples that share one unknown offset.
struct NoiseRun {
  int group = 0;  ///< samples of one group share one noise level: one instrument
  Index first = 0;
  Index count = 0;
};

/// How the samples hang together. Everything here is in units of the declared repeatability of each sample.
struct NoiseLayout {
  std::vector<NoiseRun> runs;  ///< in order, without gaps
  VectorXd place;              ///< instant of a sample in its run, in typical sample spacings
  int groups = 0;
};

/// Covariance of one run, up to its level s²: (1 − w) [(1 − f) 1 + f exp(−|Δ|/ℓ)] + w 1 1ᵀ. The declared
/// repeatability contains the offset from run to run, so that s² stays near 1 whatever its share w.
struct NoiseShape {
  double correlated = 0.0;  ///< f
  double length = 1.0;      ///< ℓ, sample spacings
  double offset = 0.0;      ///< w
  double log_prior = 0.0;   ///< nats
};

/// The grid from which the likelihood chooses.
[[nodiscard]] const std::vector<NoiseShape>& noiseShapes();

/// Noise of every group: shape by its index in the grid, and level s².
struct Noise {
  std::vector<std::size_t> shape;
  std::vector<double> level;
};

/// Whitening by the innovations of the state-space form of the covariance (one state for the correlated part,
/// one for the offset): exact, linear, and proportional to samples × columns.
class NoiseModel {
 public:
  explicit NoiseModel(NoiseLayout layout);

  [[nodiscard]] const NoiseLayout& layout() const { return layout_; }
  [[nodiscard]] Index sampleCount() const { return layout_.place.size(); }
  /// Marks outliers: their variance is multiplied, so that they no longer count.
  void setOutliers(const std::vector<bool>& outliers);
  [[nodiscard]] const std::vector<bool>& outliers() const { return outliers_; }

  /// White noise with the declared repeatability and a small share of run offset: the start.
  [[nodiscard]] Noise declared() const;
  struct Estimate {
    Noise noise;
    double log_likelihood = 0.0;  ///< log-priors included
  };
  /// Noise of largest likelihood for a residual; `optimistic` allows neither long correlation nor large
  /// offsets, so that slow effects are offered before the noise can swallow them.
  [[nodiscard]] Estimate estimate(const VectorXd& residual, bool optimistic = false) const;
  /// Log-likelihood, log-priors included, at a given noise.
  [[nodiscard]] double logLikelihood(const VectorXd& residual, const Noise& noise) const;

  [[nodiscard]] RowMatrix whiten(const Noise& noise, RowMatrix columns) const;
  [[nodiscard]] VectorXd whiten(const Noise& noise, const VectorXd& column) const;
  /// Whitens columns that belong to one run of the layout alone, in place.
  void whitenRunAlone(const NoiseRun& run, std::size_t shape, double level, RowMatrix& rows) const;
  /// Each sample's residual against the prediction from all others of its run, in its standard deviations.
  [[nodiscard]] VectorXd leaveOneOut(const Noise& noise, const VectorXd& residual) const;

 private:
  /// Steps of the filter of one run at one shape.
  struct Filter {
    VectorXd decay;          // of the correlated state, to the next sample
    VectorXd gain;           // of the correlated state
    VectorXd offset_gain;    // of the offset state
    VectorXd inverse_sigma;  // of the innovation
    double log_determinant = 0.0;
  };
  [[nodiscard]] Filter makeFilter(const NoiseRun& run, const NoiseShape& shape) const;
  [[nodiscard]] const Filter& filter(std::size_t run, std::size_t shape) const;
  void whitenRun(const NoiseRun& run, const Filter& filter, double level, Eigen::Ref<RowMatrix> rows) const;
  [[nodiscard]] double sumOfSquares(const NoiseRun& run, const Filter& filter,
                                    const VectorXd& residual) const;
  [[nodiscard]] std::pair<double, double> groupLikelihood(int group, std::size_t shape,
                                                          const VectorXd& residual) const;
  void prepare();

  NoiseLayout layout_;
  std::vector<bool> outliers_;
  std::vector<std::vector<Filter>> filters_;  // [run][shape]
  std::vector<Index> counts_;                 // samples of a group that are no outliers
};

}  // namespace nineline::discovery
