#include "core/measurement/vdi_3441.h"

#include <algorithm>
#include <cmath>

namespace nineline::measurement {

Result<Vdi3441> evaluateVdi3441(const TargetRuns& runs) {
  if (const Result<void> checked = checkTargetRuns(runs); !checked) return checked.error();
  if (runs.forward.empty() || runs.backward.empty()) {
    return badInput("evaluation.one_way", "VDI 3441 needs readings in both directions.");
  }
  Vdi3441 result;
  Extent means, bands;
  for (std::size_t i = 0; i < runs.targets.size(); ++i) {
    const ApproachStatistics forward = statisticsOf(runs.forward[i]);
    const ApproachStatistics backward = statisticsOf(runs.backward[i]);
    if (!forward.s || !backward.s) {
      return badInput("evaluation.repeats",
                      "VDI 3441 needs two approaches to every target in each direction.");
    }
    const double mean = 0.5 * (forward.mean + backward.mean);
    const double scatter = 3.0 * (*forward.s + *backward.s);
    const double reversal = std::abs(forward.mean - backward.mean);
    means.add(mean);
    bands.add(mean + 0.5 * (reversal + scatter));
    bands.add(mean - 0.5 * (reversal + scatter));
    result.Ps_mean += scatter;
    result.U_mean += reversal;
    result.Ps_max = std::max(result.Ps_max, scatter);
    result.U_max = std::max(result.U_max, reversal);
  }
  const double count = static_cast<double>(runs.targets.size());
  result.Ps_mean /= count;
  result.U_mean /= count;
  result.Pa = *means.range();
  result.P = *bands.range();
  return result;
}

}  // namespace nineline::measurement
