#pragma once

#include <filesystem>
#include <string>

#include "core/base/diagnostics.h"
#include "core/base/json.h"
#include "core/base/progress.h"

namespace nineline::cli {

/// What the worked example showed.
struct WorkedExample {
  Json record;  ///< thread, compensate, compensate_nanometre (words to 1 nm): the records of these commands
  std::string summary;  ///< for people
};

/// The worked example, start to finish, into a folder, which is made where it is missing: machine.json,
/// model.json, thread.json, thread.nc, corrected.nc, report.json, summary.txt; of the finished thread, the
/// last pass, its path path-before.csv and path-after.csv, and the errors of each axis as curves, error-x.svg
/// and so on. The columns are those of `simulate`, but both paths hold the ideal path of thread.nc, so that
/// path-after.csv shows what is left. Files of these names are replaced.
[[nodiscard]] Result<WorkedExample> writeWorkedExample(const std::filesystem::path& folder,
                                                       Progress& progress);

}  // namespace nineline::cli
