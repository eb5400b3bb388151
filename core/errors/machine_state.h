#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/units.h"
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

  /// By column name; t_s, pass_1, load_kg and feed_mm_min as well. In the unit that the name ends in.
  [[nodiscard]] std::optional<double> condition(std::string_view name) const {
    if (name == "t_s") return time;
    if (name == "pass_1") return pass;
    if (name == "load_kg") return load;
    if (name == "feed_mm_min" && feed) return perMinuteFromPerSecond(*feed);
    for (const auto& [known, value] : conditions) {
      if (known == name) return value;
    }
    return std::nullopt;
  }
};

}  // namespace nineline::errors
