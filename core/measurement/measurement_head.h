#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/base/diagnostics.h"
#include "core/measurement/delimited_text.h"
#include "core/measurement/measurement.h"

namespace nineline::measurement {

/// The `#key: value` lines in front of the column names.
struct HeadEntry {
  std::string value;
  std::size_t line = 0;
  std::size_t column = 0;  ///< of the value
};
using HeadEntries = std::map<std::string, HeadEntry>;

/// Takes the head off the lines: entries, and the number of lines used. Reports double keys.
struct HeadLines {
  HeadEntries entries;
  std::size_t used = 0;
};
[[nodiscard]] HeadLines readHeadLines(const std::vector<TextLine>& lines, Diagnostics& diagnostics);

/// Fills instrument, repeatability and other head of the measurement, with every fault reported. The machine
/// may be null (nothing is known of the joints then).
void fillHead(const HeadLines& head, const Machine* machine, Measurement& measurement,
              Diagnostics& diagnostics);

}  // namespace nineline::measurement
