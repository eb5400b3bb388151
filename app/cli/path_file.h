#pragma once

#include <string>

#include "core/base/file.h"
#include "core/simulation/simulation.h"

namespace nineline::cli {

/// Simulates a program and writes each sample as a row of the path file (contract.md, convention 9). The file
/// is complete, but not yet in its place: commit it.
[[nodiscard]] Result<simulation::SimulationReport> simulateToFile(const simulation::ErrorModel& model,
                                                                  nc::TextSource& program,
                                                                  const simulation::ProgramSetup& setup,
                                                                  AtomicFile& file, Progress& progress);

/// The record of `simulate --json`; lengths in mm, times in s, deviations as in the record of `compensate`.
[[nodiscard]] Json simulationToJson(const simulation::SimulationReport& report,
                                    const kinematics::Machine& machine);

}  // namespace nineline::cli
