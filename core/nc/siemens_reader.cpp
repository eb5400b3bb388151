#include "core/nc/nc_error.h"
#include "core/nc/statement_reader.h"

namespace nineline::nc {
void readSiemensStatement(LineReader& r) { r.fail(code::kBadWord, "not yet"); }
}  // namespace nineline::nc
