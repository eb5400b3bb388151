#pragma once

#include <vector>

#include "core/measurement/measurement.h"

namespace nineline::measurement {

/// Travel since reversal (mm, rad) of a joint that has not reversed since the first row of its file: so long
/// that every memory of an earlier reversal has faded.
inline constexpr double kNoReversal = 1e6;

/// What the machine does at each sample; one state for each sample, in order.
///
/// - `q` as commanded; joints without a column stand at 0.
/// - `approach`: the column `approach_<joint>_1` where it has a value; else the sense of the last change of
/// the
///   position within the run; before the first change the sense of that change; 0 where the joint stands
///   still throughout the run.
/// - `velocity`: the columns `v_<joint>_mm_min` (`_deg_min`); else the derivative of the parabola through the
///   neighbouring samples of the run over `t_s`; 0 for a joint that stands still. Absent unless it is known
///   for every joint. A column that says 0 means: stopped, then read.
/// - `acceleration`: `a_<joint>_mm_s2` (`_deg_s2`); else 0 where the speed's column says 0, else the second
///   difference.
/// - `since_reversal`: travel along the commanded path of the file since the approach last changed,
/// kNoReversal
///   more before the first change.
/// - `feed`, `time`, `pass`, `load` from their columns; `conditions` holds every numeric column under its
/// name
///   (positions, readings and sigmas excepted). An empty cell is absent.
[[nodiscard]] std::vector<MachineState> statesOf(const Measurement& measurement, const Machine& machine);

}  // namespace nineline::measurement
