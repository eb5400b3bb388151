#pragma once

#include <cstddef>
#include <vector>

#include "core/base/result.h"

namespace nineline::measurement {

/// One term of a reading over the turn: amplitude · cos(order · angle + phase).
struct TurnHarmonic {
  int order = 1;
  double amplitude = 0.0;  ///< in the unit of the readings, ≥ 0
  double phase = 0.0;      ///< rad, in (−π, π]
};

/// Figures of a dial or capacitive gauge on a turning artefact, in the unit of the readings; the gauge stands
/// still (fixed sensitive direction).
struct RunOut {
  double mean = 0.0;
  double total = 0.0;                   ///< largest minus smallest reading
  TurnHarmonic once_per_turn;           ///< eccentricity of artefact and axis together
  double without_eccentricity = 0.0;    ///< total after the once-per-turn term is taken out
  std::vector<TurnHarmonic> harmonics;  ///< orders 2 and up
  /// Over several turns: range of the mean curve without eccentricity (synchronous), and the largest spread
  /// at one angle (asynchronous), ISO 230-7. Absent values are 0 turns.
  std::size_t turns = 0;
  double synchronous = 0.0;
  double asynchronous = 0.0;
};

/// Least squares over whatever angles there are, so they need not be equally spaced. `angles` in rad (running
/// on from turn to turn or not), `highest` the highest order fitted; it is lowered where the angles are too
/// few. Fails on fewer than four different angles or numbers that are not finite.
[[nodiscard]] Result<RunOut> evaluateRunOut(const std::vector<double>& angles,
                                            const std::vector<double>& readings, int highest = 8);

}  // namespace nineline::measurement
