#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/measurement/iso_230_4.h"

namespace nineline::measurement {

/// One named share of a ballbar trace, with its standard uncertainty from the residuals.
struct BallbarShare {
  std::string name;    ///< "squareness", "scale mismatch", "backlash X", …
  double value = 0.0;  ///< mm; rad for squareness; mm/mm for scale mismatch
  double sigma = 0.0;
  double radial = 0.0;  ///< range of the share's trace, mm: how much it costs on the circle
};

struct BallbarShares {
  std::vector<BallbarShare> shares;  ///< largest range first
  double residual_rms = 0.0;         ///< what none of them explains, mm
  double residual_range = 0.0;       ///< mm
};

/// A first-order diagnosis: least squares of all readings of a test on the traces of named errors (formulas
/// in resources/docs/evaluation.md). `first` and `second` are the letters of the plane's axes. Servo mismatch
/// needs both senses and is absent otherwise. Fails like evaluateIso2304 and where the paths cannot tell the
/// shares apart.
[[nodiscard]] Result<BallbarShares> ballbarShares(const CircularTest& test, char first, char second);

}  // namespace nineline::measurement
