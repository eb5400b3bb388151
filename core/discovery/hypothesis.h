#pragma once

#include "core/discovery/search.h"

namespace nineline::discovery {

/// Judges sets of options with the noise re-estimated under each of them, so that an effect must beat
/// "longer-correlated noise" and "larger offsets from run to run" as well as chance.
class Hypotheses {
 public:
  Hypotheses(const NoiseModel& model, const FixedPart& fixed, const VectorXd& residual);

  struct Verdict {
    double score = 0.0;     ///< −2 ln L + penalties + coefficients against their priors
    Noise noise;            ///< of largest likelihood
    VectorXd coefficients;  ///< of the set
    VectorXd fixed;         ///< of the fixed part
    VectorXd residual;      ///< what is left, in units of the declared repeatability
  };
  [[nodiscard]] Verdict judge(const Dictionary& dictionary, const OptionSet& set) const;
  [[nodiscard]] double score(const Dictionary& dictionary, const OptionSet& set) const {
    return judge(dictionary, set).score;
  }

 private:
  struct Whitened {
    Noise noise;
    Eigen::MatrixXd fixed;
    VectorXd target;
    Eigen::MatrixXd inverse;  // of the fixed part's normal matrix
  };
  [[nodiscard]] Whitened whiten(const Noise& noise) const;
  void fit(const Whitened& space, const RowMatrix& raw, const VectorXd& prior, Verdict& verdict) const;

  const NoiseModel* model_;
  const FixedPart* fixed_;
  VectorXd residual_;
};

/// What one member of a set is worth: the rise of the score when it is removed.
struct Evidence {
  std::size_t option = 0;
  double worth = 0.0;
};

struct LikelihoodPolish {
  double keep = 10.0;               ///< a member must be worth this
  std::vector<Evidence> suspected;  ///< dropped, but worth more than 0
};

/// Drops, swaps and adds members by their likelihood until nothing improves.
[[nodiscard]] OptionSet polishByLikelihood(Dictionary& dictionary, const Hypotheses& hypotheses,
                                           OptionSet set, LikelihoodPolish& polish);

}  // namespace nineline::discovery
