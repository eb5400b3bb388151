#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/postprocessing/cl_data.h"

namespace nineline::postprocessing {

struct ClOptions {
  double arc_tolerance = 0.001;  ///< mm: how far a chord may leave the arc of a CIRCLE
};

/// Reads cutter location data: APT/CLDATA text, or a table whose first line names the columns
/// `x_mm y_mm z_mm` and, where wanted, `i_1 j_1 k_1 feed_mm_min rapid_1`. Statements that move nothing and
/// are not known become comments, with a warning; a statement that could be motion and is not understood, and
/// every bad number, is BadInput with line and column; `faults`, where given, receives all of them.
[[nodiscard]] Result<ClProgram> readClData(std::string_view text, const std::string& source,
                                           const ClOptions& options = {}, Diagnostics* faults = nullptr);

}  // namespace nineline::postprocessing
