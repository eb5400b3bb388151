#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/kinematics/machine.h"

namespace nineline::errors {

using kinematics::JointPositions;

/// What the machine does at one instant. What is unknown is absent, never zero.
struct MachineState {
  JointPositions q{};  ///< commanded positions: mm, rad
  std::array<std::int8_t, kMaxAxes>
      approach{};                          ///< sense of the last motion of each joint: −1, +1; 0 unknown
  std::optional<JointPositions> velocity;  ///< mm/s, rad/s
  std::optional<JointPositions> acceleration;    ///< mm/s², rad/s²
  std::optional<JointPositions> since_reversal;  ///< travel since each joint last reversed: mm, rad
  std::optional<double> feed;                    ///< mm/s
  std::optional<double> time;                    ///< s
  std::optional<double> pass;                    ///< number of the pass
  std::optional<double> load;                    ///< kg
  /// Temperatures and other conditions by column name ("temp_screw_Z_C"), in the unit that the name ends in.
  std::vector<std::pair<std::string, double>> conditions;

  [[nodiscard]] std::optional<double> condition(std::string_view name) const {
    for (const auto& [known, value] : conditions) {
      if (known == name) return value;
    }
    return std::nullopt;
  }
};

}  // namespace nineline::errors
