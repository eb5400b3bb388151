#pragma once

#include <cstdint>

#include "core/base/result.h"

namespace nineline::nc {

class TextSource;

enum class Dialect : std::uint8_t { Fanuc, Siemens, LinuxCnc };

/// What the first 64 KiB of a program say about the control it was written for.
struct DialectSigns {
  Dialect dialect = Dialect::Fanuc;
  bool incremental_letters = false;  ///< U or W words stand beside X and Z words
  bool return_codes = false;         ///< G98 or G99 without any drilling cycle
  bool distance_codes = false;       ///< G91, G94 or G95
};

[[nodiscard]] Result<DialectSigns> recogniseDialect(TextSource& source);

}  // namespace nineline::nc
