#pragma once

#include <cstdint>
#include <string_view>

namespace nineline::project {

/// 64-bit FNV-1a over fields of a row, so that a flipped bit on the disk is noticed. Each field counts with
/// its length: moving a byte from one field to the next changes the sum. Guards against accidents, not
/// against forgers.
class Checksum {
 public:
  Checksum& add(std::string_view bytes);
  Checksum& add(std::int64_t number);
  [[nodiscard]] std::int64_t value() const { return static_cast<std::int64_t>(sum_); }

 private:
  std::uint64_t sum_ = 14695981039346656037ULL;
};

}  // namespace nineline::project
