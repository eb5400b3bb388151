#pragma once

#include "core/identification/nine_line.h"

namespace nineline::identification {

/// Repeated bidirectional runs over the lines of one axis: [reading][position][run], mm. `backward` may be
/// empty. Every run is zeroed at its own forward reading at the datum, so that the reversal at the datum
/// stays.
struct LineRuns {
  std::vector<double> positions;  ///< mm
  std::size_t datum = 0;
  std::vector<std::vector<std::vector<double>>> forward;
  std::vector<std::vector<std::vector<double>>> backward;
};

/// Mean readings of one direction with their standard uncertainties.
struct LineMeans {
  std::vector<std::vector<double>> mean;     ///< [reading][position], mm
  std::vector<std::vector<double>> scatter;  ///< standard deviation s of a single reading, mm
  std::vector<std::vector<double>>
      sigma;                    ///< of the mean: s/√K and the set-up's sigma (type B) in quadrature
  std::vector<bool> is_pooled;  ///< [reading]: one s for all positions
};

/// The errors of an axis and what changes with the direction of travel.
struct BidirectionalLines {
  LineReport forward;
  std::optional<LineReport> backward;
  /// Mean of both directions: the error table; the forward values where there is no backward run.
  std::vector<LineErrors> table;
  /// Half the difference, forward minus backward: reversal error ± this. Empty without backward runs.
  std::vector<LineErrors> reversal;
  std::vector<std::size_t> blunders;  ///< positions whose residuals are too large to be chance
};

/// Statistics of one direction; the scatter is pooled over the positions of a reading unless one of them is
/// out of proportion (its variance has a probability below 0.001 under the pooled one). Requires equal
/// shapes.
[[nodiscard]] LineMeans meansOf(const LineSetup& setup, const LineRuns& runs, bool is_backward);

/// Forward and backward separately, then table and reversal error (theory.md, 2.1). Fails like identifyLines,
/// and on runs of different numbers.
[[nodiscard]] Result<BidirectionalLines> identifyLineRuns(const LineSetup& setup, const LineRuns& runs,
                                                          LineMethod method = LineMethod::Exact);

}  // namespace nineline::identification
