#pragma once

#include <map>
#include <vector>

#include "core/discovery/candidate.h"

namespace nineline::discovery {

/// What is fitted with every hypothesis and never named: parameters that the model already has, and the zeros
/// of the files. `precision` is 1/σ² of each, 0 for a free one.
struct FixedPart {
  RowMatrix columns;
  VectorXd precision;
};

/// Indices of options, in the order in which they were taken.
using OptionSet = std::vector<std::size_t>;

/// All options of all candidates, before any noise model.
struct OptionBank {
  std::vector<Candidate> candidates;
  std::vector<Option> options;

  /// Adds a candidate with an option for every combination of its grid values.
  void add(Candidate candidate);
  /// Adds one option of a candidate that is in the bank; gives its index, or that of an equal one.
  std::size_t addOption(std::size_t candidate, std::vector<double> shape, std::vector<double> step,
                        double prior_grid);
  /// Leaves out options; gives the new index of every old one (their number where it is gone).
  std::vector<std::size_t> keepOnly(const std::vector<bool>& kept);
  [[nodiscard]] const Candidate& candidateOf(std::size_t option) const {
    return candidates[options[option].candidate];
  }
  [[nodiscard]] const std::string& name(std::size_t option) const { return candidateOf(option).name; }
};

/// Whitened options in Gram space: every gain, removal and swap is algebra on inner products, which are
/// formed only for the columns that a hypothesis contains.
class Dictionary {
 public:
  Dictionary(const NoiseModel& model, const Noise& noise, const FixedPart& fixed, const VectorXd& residual,
             OptionBank& bank);

  [[nodiscard]] const OptionBank& bank() const { return *bank_; }
  [[nodiscard]] std::size_t size() const { return ranges_.size(); }
  [[nodiscard]] double penalty(std::size_t option) const { return penalties_[option]; }
  [[nodiscard]] double totalPenalty(const OptionSet& set) const;
  /// Squared length of an option's strongest column, set-up and existing parameters projected out.
  [[nodiscard]] double strength(std::size_t option) const;
  /// False where the largest plausible amplitude would not show.
  [[nodiscard]] bool isTestable(std::size_t option) const { return testable_[option]; }

  /// Residual sum of squares with the set fitted (priors of the coefficients included).
  [[nodiscard]] double sumOfSquares(const OptionSet& set) const;
  /// sumOfSquares + penalties: the smaller, the better.
  [[nodiscard]] double score(const OptionSet& set) const { return sumOfSquares(set) + totalPenalty(set); }
  struct Fit {
    VectorXd coefficients;       ///< of the set's columns, one option after the other
    Eigen::MatrixXd covariance;  ///< of the same
  };
  [[nodiscard]] Fit fit(const OptionSet& set) const;
  /// Coefficients of the fixed part beside coefficients of a set.
  [[nodiscard]] VectorXd fixedBeside(const OptionSet& set, const VectorXd& coefficients) const;
  [[nodiscard]] bool isPlausible(const OptionSet& set) const;

  enum class Which { Named, Generic, Both };
  /// Fall of the sum of squares when each option joins the set; −∞ for options not asked for.
  [[nodiscard]] VectorXd gains(const OptionSet& set, Which which = Which::Named) const;
  /// The same less the options' penalties.
  [[nodiscard]] VectorXd netGains(const OptionSet& set, Which which = Which::Named) const;

  /// What is needed to try other shapes of one option beside a set.
  struct Profile {
    std::size_t like = 0;
    VectorXd residual;            ///< whitened, the set and the fixed part fitted
    Eigen::MatrixXd set_columns;  ///< of the set, the fixed part projected out
    Eigen::MatrixXd set_inverse;  ///< of their Gram matrix
    double kept = 1.0;            ///< share of the option's square that the fixed part leaves
  };
  [[nodiscard]] Profile profile(const OptionSet& set, std::size_t like) const;
  /// Gain of the option at another shape. What the fixed part takes of it is scaled from the option's own.
  [[nodiscard]] double gainAt(const Profile& profile, std::span<const double> shape) const;
  /// Makes a new option beside an existing one of the same candidate; gives its index.
  std::size_t append(std::size_t like, std::vector<double> shape, std::vector<double> step);
  /// Takes over the options that the bank has got since.
  void update();

  /// Whitened residual with the set and the fixed part fitted.
  [[nodiscard]] VectorXd whitenedResidual(const OptionSet& set) const;
  [[nodiscard]] const VectorXd& whitenedTarget() const { return target_; }
  /// Whitened columns of the set, and the whitened target, less what the fixed part makes of them.
  [[nodiscard]] Eigen::MatrixXd projectedColumns(const OptionSet& set) const;
  [[nodiscard]] const VectorXd& projectedTarget() const { return projected_target_; }
  [[nodiscard]] auto whitenedColumns(std::size_t option) const {
    return white_.middleCols(ranges_[option].first, ranges_[option].count);
  }
  /// Columns of the set side by side, whitened.
  [[nodiscard]] Eigen::MatrixXd whitenedColumns(const OptionSet& set) const;
  /// Cosine between what two options can explain (largest canonical correlation), 0…1.
  [[nodiscard]] double likeness(std::size_t a, std::size_t b) const;

 private:
  struct Range {
    Index first = 0;
    Index count = 0;
  };
  /// Cholesky factor of a set's Gram matrix and what it leaves of everything else.
  struct Sweep {
    Eigen::MatrixXd projected;  // L⁻¹ G(set, all)
    VectorXd diagonal;
    VectorXd target;
  };
  void makeRoom(Index columns);
  void appendAll();
  void appendColumns(const RowMatrix& raw, std::size_t option);
  /// Takes over an option whose columns and their projection are in place.
  void enter(std::size_t option, Range range);
  [[nodiscard]] double penaltyOf(std::size_t option) const;
  [[nodiscard]] double effectiveSamples(std::size_t option) const;
  [[nodiscard]] double betweenRunSamples(const RowMatrix& raw, double samples) const;
  [[nodiscard]] std::vector<Index> columnsOf(const OptionSet& set) const;
  [[nodiscard]] const VectorXd& gramRow(Index column) const;
  [[nodiscard]] double gramEntry(Index a, Index b) const;
  [[nodiscard]] const VectorXd& projectedColumn(Index column) const;
  [[nodiscard]] Sweep sweep(const OptionSet& set) const;
  [[nodiscard]] double optionGain(std::size_t option, const Sweep& sweep) const;
  [[nodiscard]] double blockGain(Eigen::MatrixXd block, const VectorXd& target, const VectorXd& own,
                                 int sign) const;
  void gram(const OptionSet& set, Eigen::MatrixXd& matrix, VectorXd& right) const;

  const NoiseModel* model_;
  Noise noise_;
  OptionBank* bank_;
  Eigen::MatrixXd fixed_;  // whitened
  VectorXd precision_;
  Eigen::MatrixXd fixed_factor_;  // lower Cholesky factor of the fixed part's normal matrix
  VectorXd target_;               // whitened residual
  VectorXd projected_target_;
  VectorXd target_fixed_;       // L⁻¹ Jᵀ r
  double target_square_ = 0.0;  // of the residual, fixed part projected out
  Eigen::MatrixXd white_;       // whitened columns
  Eigen::MatrixXd cross_;       // L⁻¹ Jᵀ D
  VectorXd diagonal_;           // Gram diagonal, coefficient priors included
  VectorXd inner_;              // inner products with the residual
  Index used_ = 0;
  std::vector<Range> ranges_;
  std::vector<Eigen::MatrixXd> blocks_;  // Gram blocks of each option
  std::vector<double> penalties_;
  std::vector<bool> testable_;
  mutable std::map<Index, VectorXd> rows_;
  mutable std::map<std::pair<Index, Index>, double> entries_;
  mutable std::map<Index, VectorXd> projected_;
};

}  // namespace nineline::discovery
