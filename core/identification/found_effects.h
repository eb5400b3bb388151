#pragma once

#include "core/identification/knot_search.h"

namespace nineline::identification {

/// The fit as an error model: tables with the standard uncertainty of each value, location errors and plays
/// with theirs. A table of which nothing was told is left out. `coverage` gets the measured range of each.
[[nodiscard]] Result<errors::ErrorModel> modelOf(const estimation::ReadingSet& readings,
                                                 const KnotSearch& search, const std::string& when,
                                                 std::vector<TableCoverage>& coverage);

}  // namespace nineline::identification
