#pragma once

#include <cstdint>
#include <string>

namespace nineline::nc {

/// What a reader found wrong in one line: the first fault wins.
struct Fault {
  const char* code = nullptr;  ///< of nc_error.h; nullptr: nothing wrong
  std::string text;
  std::uint32_t column = 0;  ///< from 0

  [[nodiscard]] bool found() const { return code != nullptr; }
  void set(const char* what, std::uint32_t where, std::string message) {
    if (found()) return;
    code = what;
    column = where;
    text = std::move(message);
  }
};

}  // namespace nineline::nc
