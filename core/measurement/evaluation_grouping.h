#pragma once

#include <span>

#include "core/base/diagnostics.h"
#include "core/measurement/evaluation_runs.h"
#include "core/measurement/iso_230_4.h"
#include "core/measurement/measurement.h"

namespace nineline::measurement {

/// A file of readings and the machine whose joint order its samples follow.
struct EvaluationInput {
  const Measurement* measurement = nullptr;
  const Machine* machine = nullptr;
};

/// Index in the machine of the joint whose positioning a file tells: the axis of a `joint` or `laser-linear`
/// instrument; of a `deviation` file the only joint that moves. Fails with BadInput where there is none.
[[nodiscard]] Result<int> positionedJoint(const EvaluationInput& input);

/// Sorts readings of one or more files of the same test by target and direction. The direction is that of the
/// column `approach_<joint>_1`; else of the last move within the run; a reading repeated at the place where
/// the axis turns round (overrun and return) and the first of a run belong to the move that follows. Readings
/// whose direction is unknown and targets that one driven direction never reads are left out with a warning.
[[nodiscard]] Result<TargetRuns> groupByTarget(std::span<const EvaluationInput> inputs, int joint,
                                               Diagnostics& warnings);

/// Sorts the readings of ballbar files of one test into a clockwise and a counter-clockwise path, by the
/// commanded tool place in W, seen against the plane's normal (XY from +Z, YZ from +X, ZX from +Y).
[[nodiscard]] Result<CircularTest> groupByPath(std::span<const EvaluationInput> inputs,
                                               Diagnostics& warnings);

}  // namespace nineline::measurement
