#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

namespace nineline {

/// A mistake of the program itself, never of a user or a file. Caught only in main, in the job runner and in
/// QApplication::notify, which offer to save the project.
class ContractViolation : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

namespace detail {
template <typename... Values>
[[noreturn]] void throwContractViolation(const char* condition, const char* file, int line,
                                         const Values&... values) {
  std::ostringstream text;
  text << file << ":" << line << ": " << condition << " does not hold";
  ((text << " [" << values << "]"), ...);
  throw ContractViolation(text.str());
}
}  // namespace detail
}  // namespace nineline

/// Active in every build. The values are printed with the condition.
#define NL_EXPECTS(condition, ...)                                                                           \
  do {                                                                                                       \
    if (!(condition)) [[unlikely]]                                                                           \
      ::nineline::detail::throwContractViolation(#condition, __FILE__, __LINE__ __VA_OPT__(, ) __VA_ARGS__); \
  } while (false)
