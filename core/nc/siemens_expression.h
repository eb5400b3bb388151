#pragma once

#include "core/nc/statement_reader.h"

namespace nineline::nc {

/// Evaluates Siemens expressions: R parameters, DEF variables, functions, comparisons; angles in degrees.
/// After a fault the value is zero and `reader.fault` says why.
[[nodiscard]] double evaluateSiemens(LineReader& reader);

/// A name of letters, digits and underscores at the cursor, upper case; taken.
[[nodiscard]] std::string takeName(Cursor& at);

}  // namespace nineline::nc
