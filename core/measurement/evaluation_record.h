#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/json.h"
#include "core/measurement/evaluation_ballbar.h"
#include "core/measurement/evaluation_grouping.h"
#include "core/measurement/iso_230_2.h"
#include "core/measurement/iso_230_4.h"
#include "core/measurement/run_out.h"
#include "core/measurement/vdi_3441.h"

namespace nineline::measurement {

/// One test: the files that belong to it and the figures that its instrument gives.
struct Evaluation {
  std::vector<std::string> sources;
  std::string instrument;   ///< "laser-linear"
  std::string axis;         ///< "X"; of a circular test the plane, "XY"
  bool is_angular = false;  ///< readings are rad, targets rad
  bool is_rotary = false;   ///< targets are rad
  std::optional<TargetRuns> runs;
  std::optional<Iso2302> iso_230_2;
  std::optional<Vdi3441> vdi_3441;
  std::optional<Iso2304> iso_230_4;
  std::optional<BallbarShares> ballbar;  ///< absent where the path cannot tell its errors apart
  std::optional<RunOut> run_out;
  Diagnostics warnings;
};

/// `ballbar` and `deviation` files of the same set-up make one test; other files have an unknown zero each
/// and are tests of their own. `joint`, `laser-linear` and one-axis `deviation` files: ISO 230-2 and VDI
/// 3441; `ballbar`: ISO 230-4; `dial` on a rotary axis: run-out. Fails on the first file that none of these
/// fits.
[[nodiscard]] Result<std::vector<Evaluation>> evaluateMeasurements(std::span<const EvaluationInput> inputs);

/// contract.md, convention 10: `iso_230_2`, `iso_230_4`, `vdi_3441`, `ballbar`, `run_out` of the first test
/// that has them, and `tests`, each with its files and figures. Figures that a test does not give are null.
[[nodiscard]] Json evaluationsToJson(const std::vector<Evaluation>& evaluations);

/// The same as a table for people.
[[nodiscard]] std::string evaluationText(const Evaluation& evaluation);

}  // namespace nineline::measurement
