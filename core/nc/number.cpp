#include "core/nc/number.h"

#include <system_error>

namespace nineline::nc::detail {

double readLongDecimal(const char* first, const char* last) {
  double value = 0.0;
  const auto [end, fault] = std::from_chars(first, last, value, std::chars_format::fixed);
  // More than 308 digits: an infinity, which every reader of the value refuses.
  return fault == std::errc::result_out_of_range && end != first ? 1e308 * 10.0 : value;
}

}  // namespace nineline::nc::detail
