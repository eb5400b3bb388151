#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/identification/identification.h"
#include "tests/identification_campaign/planted_case.h"

namespace nineline::identification_campaign {

/// Values compared with what was planted.
struct Coverage {
  std::size_t values = 0;
  std::size_t inside = 0;  ///< within 2 sigma
  double square = 0.0;     ///< Σ (deviation / sigma)²
  double largest = 0.0;    ///< largest deviation / sigma
  void add(double deviation, double sigma);
  void add(const Coverage& other);
  [[nodiscard]] double percent() const;
};

/// Comparison of one identified model with the planted one.
struct Comparison {
  Coverage all;
  std::map<std::string, Coverage> by_part;  ///< "table", "location", "play"
  double largest_length = 0.0;              ///< largest deviation of any value, mm
  double largest_angle = 0.0;               ///< rad
  std::vector<std::string> missing;         ///< planted, but not in the identified model
  std::vector<std::string> invented;        ///< in the identified model, but not planted
};

/// Value by value; table values at the planted nodes. Values that a convention fixes (sigma 0) do not count.
[[nodiscard]] Comparison compare(const errors::ErrorModel& found, const errors::ErrorModel& planted);

}  // namespace nineline::identification_campaign
