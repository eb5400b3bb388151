#pragma once

#include "core/nc/execution.h"

namespace nineline::nc {

/// Executes one line; false at the end of the program or after a failure.
bool step(Execution& e);
/// G65: arguments become local variables.
bool callMacro(Execution& e);
/// SUPA, TRAORI and the like.
bool applyKeywords(Execution& e);

}  // namespace nineline::nc
