#include "core/project/checksum.h"

namespace nineline::project {

namespace {
constexpr std::uint64_t kPrime = 1099511628211ULL;
}  // namespace

Checksum& Checksum::add(std::string_view bytes) {
  for (const char byte : bytes) sum_ = (sum_ ^ static_cast<unsigned char>(byte)) * kPrime;
  return add(static_cast<std::int64_t>(bytes.size()));
}

Checksum& Checksum::add(std::int64_t number) {
  auto rest = static_cast<std::uint64_t>(number);
  for (int i = 0; i < 8; ++i, rest >>= 8U) sum_ = (sum_ ^ (rest & 0xffU)) * kPrime;
  return *this;
}

}  // namespace nineline::project
