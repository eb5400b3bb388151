#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/measurement/import.h"

namespace nineline::measurement {

/// One row of "Run Target Data:".
struct DeviationRow {
  long long run = 0;
  long long target = 0;  // from 1
  double deviation = 0.0;
  std::size_t line = 0;
};

/// The sections of an .rtl file as they stand.
struct RtlText {
  std::vector<double> targets;
  std::optional<long long> target_count;
  std::optional<long long> run_count;
  std::vector<DeviationRow> rows;
  std::size_t rows_line = 0;
  std::string axis;
  std::string kind_text;  // file types and comments that may tell linear from angular
};

/// Reads the sections, each of which ends in "::" (formats.md); reports unreadable numbers, counts that do
/// not hold and readings that stand twice; half a run is a warning. Other keys go into the import's head.
[[nodiscard]] RtlText readRtlText(std::string_view text, Import& import);

/// The words of a line between blanks, commas and semicolons.
[[nodiscard]] std::vector<std::string_view> wordsOf(std::string_view line);

}  // namespace nineline::measurement
