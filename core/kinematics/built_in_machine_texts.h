#pragma once

#include <array>
#include <string_view>

namespace nineline::kinematics {

inline constexpr std::size_t kBuiltInMachineCount = 8;

/// The files of resources/machines, in the order of core/kinematics/CMakeLists.txt.
[[nodiscard]] const std::array<std::string_view, kBuiltInMachineCount>& builtInMachineTexts();

}  // namespace nineline::kinematics
