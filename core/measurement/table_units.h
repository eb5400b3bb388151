#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace nineline::measurement {

/// Factor of a unit to mm or rad: "mm", "um", "nm", "m", "inch", "mil"; "deg", "arcmin", "arcsec", "rad",
/// "mrad", "urad". Nothing for any other text.
[[nodiscard]] std::optional<double> factorOf(std::string_view unit);

/// The unit that a column's header ends in or has in brackets: "Target (mm)", "偏差[µm]", "dev_um". Nothing
/// where it names none.
[[nodiscard]] std::optional<std::string> unitInHeader(std::string_view header);

}  // namespace nineline::measurement
