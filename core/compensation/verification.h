#pragma once

#include "core/compensation/compensation.h"
#include "core/compensation/piece_log.h"

namespace nineline::compensation {

struct Verification {
  DeviationSummary before;
  DeviationSummary after;
  std::size_t worst_line = 0;  ///< of the original: where the corrected program deviates most
};

/// Reads the original and the corrected program side by side and simulates both, apart from the solver:
/// deviation of the actual tool from the original's ideal path, before and after. Fails when the corrected
/// program does not mean what the original means: another motion, feed, spindle speed or count of motions.
[[nodiscard]] Result<Verification> verifyCorrection(const ErrorModel& model, const ProgramSetup& setup,
                                                    nc::TextSource& original, nc::TextSource& corrected,
                                                    const PieceLog& log, Progress& progress,
                                                    const ComparisonSink& sink = {});

}  // namespace nineline::compensation
