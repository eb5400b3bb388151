#pragma once

#include <string_view>

#include "core/postprocessing/cl_data.h"
#include "core/postprocessing/cl_reader.h"

namespace nineline::postprocessing {

/// Reads APT/CLDATA text into `program`; faults go to `faults`.
void readApt(std::string_view text, const ClOptions& options, ClProgram& program, Diagnostics& faults);
/// Reads the table form.
void readClTable(std::string_view text, ClProgram& program, Diagnostics& faults);
/// True where the first line that is not empty names the columns of a table.
[[nodiscard]] bool isClTable(std::string_view text);

}  // namespace nineline::postprocessing
