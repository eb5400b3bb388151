#pragma once

#include <filesystem>
#include <string>

#include "core/base/diagnostics.h"
#include "core/base/json.h"
#include "core/base/progress.h"

namespace nineline::cli {

/// What the worked example showed.
struct WorkedExample {
  Json record;  ///< thread, simulate, compensate and compensate_nanometre: the records of these commands
  std::string summary;  ///< for people
};

/// The worked example, start to finish, into a folder, which is made where it is missing: machine.json,
/// model.json, thread.json, thread.nc, corrected.nc, path-before.csv, path-after.csv, report.json,
/// summary.txt and an error curve error-<axis>.svg for each axis. Files of these names are replaced.
[[nodiscard]] Result<WorkedExample> writeWorkedExample(const std::filesystem::path& folder,
                                                       Progress& progress);

}  // namespace nineline::cli
