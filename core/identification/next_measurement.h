#pragma once

#include "core/estimation/design.h"
#include "core/identification/knot_search.h"

namespace nineline::identification {

/// A set-up that an engineer could make, with the positions that he would drive to.
struct FeasibleSetup {
  std::string text;  ///< "laser-angular of X about Z"
  Measurement measurement;
};

/// The usual set-ups on a machine: for each linear joint laser-linear, straightness and angular with the
/// point on and beside the axis, for each rotary joint angular, dials along and across at two heights, the
/// circular tests of all pairs of linear joints. Targets over `low`…`high` of what was measured, else over
/// the travel.
[[nodiscard]] std::vector<FeasibleSetup> feasibleSetups(const estimation::ReadingSet& readings);

/// The set-ups that tell most beside the readings at hand (D-optimal, greedy): only those that tell something
/// that is not told yet.
[[nodiscard]] std::vector<ProposedMeasurement> proposeMeasurements(const estimation::ReadingSet& readings,
                                                                   const KnotSearch& search,
                                                                   std::size_t count);

/// How well planned measurements (readings may be empty) would tell the errors of the joints that they move:
/// rank, condition number, expected uncertainty of each parameter, before anyone measures. Readings count
/// with the stated repeatability, else with 1 µm and 1 arcsec.
struct PlanReport {
  estimation::PlanQuality quality;
  std::vector<std::string> told;
  std::vector<Unobservable> unobservable;
};
[[nodiscard]] Result<PlanReport> judgePlan(const Machine& machine, std::span<const Measurement> planned);

}  // namespace nineline::identification
