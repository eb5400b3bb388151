#pragma once

#include <optional>
#include <string>

#include "core/discovery/search.h"

namespace nineline::discovery {

struct GateOptions {
  double least_rms = 0.15;           ///< of a contribution where it shows best, in repeatabilities
  double least_gain_to_error = 1.0;  ///< of the held-out gain
  double least_cluster_worth = 0.0;  ///< gain discounted for what clusters say about its error, less penalty
  double least_refinement = 0.2;     ///< smaller than this share of another on its axis: a shape detail
};

/// Gain on samples that the fit did not see.
struct HeldOut {
  double gain = 0.0;
  double error = 0.0;  ///< standard error of the gain
  std::size_t units = 0;
};

/// A member of a set that does not stand, and why.
struct Refusal {
  std::size_t option = 0;
  std::string gate;    ///< "held-out", "chance", "agreement", "size"
  double worth = 0.0;  ///< score that it would have saved
};

/// The checks that every accepted effect must pass whatever its likelihood.
class Gates {
 public:
  Gates(const NoiseModel& model, const FixedPart& fixed, const VectorXd& residual,
        const GateOptions& options);

  /// Removes members that fail, the weakest first, until all pass.
  [[nodiscard]] OptionSet admit(const Dictionary& dictionary, OptionSet set,
                                std::vector<Refusal>& refused) const;
  /// Five folds by run (by blocks of 14 samples where fewer than four runs carry the effect); Huberised loss.
  [[nodiscard]] HeldOut heldOut(const Dictionary& dictionary, const OptionSet& set, std::size_t option) const;
  /// How many times larger the variance of a member's size is by clusters than by the noise model; at
  /// least 1. Takes the place of sign flips: the same null by blocks, without chance, and it needs no draws.
  [[nodiscard]] double clusterInflation(const Dictionary& dictionary, const OptionSet& set,
                                        std::size_t option) const;
  /// Root mean square of a member's contribution on the instrument that sees it best, in repeatabilities.
  [[nodiscard]] double bestRms(const Dictionary& dictionary, const OptionSet& set, std::size_t option) const;
  /// What a member contributes to every sample, in repeatabilities.
  [[nodiscard]] static VectorXd contribution(const Dictionary& dictionary, const OptionSet& set,
                                             std::size_t option);

 private:
  [[nodiscard]] bool agrees(const Dictionary& dictionary, const OptionSet& set, std::size_t option) const;
  [[nodiscard]] std::string failedGate(const Dictionary& dictionary, const OptionSet& set, std::size_t option,
                                       double worth) const;
  [[nodiscard]] std::vector<int> unitsFor(const Dictionary& dictionary, std::size_t option,
                                          std::size_t fewest) const;
  [[nodiscard]] std::vector<int> foldsOf(const std::vector<int>& units) const;

  /// Least squares on what the declared repeatabilities alone weigh; outliers left out.
  struct PlainFixed {
    RowMatrix columns;
    Eigen::MatrixXd inverse;
  };
  [[nodiscard]] const PlainFixed& plainFixed() const;

  const NoiseModel* model_;
  const FixedPart* fixed_;
  VectorXd residual_;
  GateOptions options_;
  mutable std::optional<PlainFixed> plain_fixed_;
  std::vector<int> runs_;       // of each sample
  std::vector<int> blocks_;     // of each sample
  std::vector<int> groups_;     // of each sample
  std::vector<bool> has_zero_;  // of each group
};

}  // namespace nineline::discovery
