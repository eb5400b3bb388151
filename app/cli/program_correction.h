#pragma once

#include <optional>
#include <string>

#include "core/base/file.h"
#include "core/compensation/compensation.h"

namespace nineline::cli {

/// What a correction reads and writes. Files are complete, but not yet in their places, until `commit`.
struct CorrectionFiles {
  AtomicFile program;
  std::optional<AtomicFile> path;

  [[nodiscard]] static Result<CorrectionFiles> create(const std::string& program, const std::string& path);
  /// Puts the files in place, the program last.
  [[nodiscard]] Result<void> commit();
};

/// Corrects `source` into `files.program`, and simulates what was written into `files.path`, where there is
/// one.
[[nodiscard]] Result<compensation::CompensationReport> correctProgram(
    const errors::ErrorModel& model, const std::string& source, const simulation::ProgramSetup& setup,
    const compensation::CompensationOptions& options, CorrectionFiles& files, Progress& progress,
    const compensation::ComparisonSink& compared = {});

}  // namespace nineline::cli
