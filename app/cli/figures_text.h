#pragma once

#include <string>

#include "core/simulation/deviation_statistics.h"

namespace nineline::cli {

/// A table for people: mean, RMS and largest deviation of the tool tip and of each joint, in um and arcsec.
[[nodiscard]] std::string figuresText(const simulation::DeviationSummary& deviation,
                                      const kinematics::Machine& machine);

/// The same before and after a correction, with the part of the RMS that is gone.
[[nodiscard]] std::string figuresText(const simulation::DeviationSummary& before,
                                      const simulation::DeviationSummary& after,
                                      const kinematics::Machine& machine);

}  // namespace nineline::cli
