#pragma once

#include "core/measurement/evaluation_runs.h"

namespace nineline::measurement {

/// The figures of VDI/DGQ 3441 for one axis, in the unit of the readings.
struct Vdi3441 {
  double P = 0.0;                      ///< positional uncertainty: range of mean ± (U_i + Ps_i)/2
  double Pa = 0.0;                     ///< positional deviation: range of the means of both directions
  double Ps_mean = 0.0, Ps_max = 0.0;  ///< positional scatter 6 (s↑ + s↓)/2
  double U_mean = 0.0, U_max = 0.0;    ///< reversal error |mean↑ − mean↓|
};

/// Fails unless both directions have at least two approaches to every target.
[[nodiscard]] Result<Vdi3441> evaluateVdi3441(const TargetRuns& runs);

}  // namespace nineline::measurement
