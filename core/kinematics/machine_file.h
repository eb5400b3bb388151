#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/json.h"
#include "core/kinematics/machine.h"

namespace nineline::kinematics {

/// Reads a machine in the format `nineline-machine/1`; a rotary joint's travel is in degrees there. Beyond
/// the contract each joint may have `diameter` (NC words are diameters) and `rapid_mm_min` or
/// `rapid_deg_min`.
[[nodiscard]] Result<Machine> machineFromJson(const Json& json, const std::string& source);
[[nodiscard]] Result<Machine> readMachine(std::string_view text, const std::string& source);

/// The same format; reading it back gives an equal machine.
[[nodiscard]] Json machineToJson(const Machine& machine);

/// The machines of resources/machines, in the order of the contract.
[[nodiscard]] const std::vector<Machine>& builtInMachines();
/// A built-in machine by its id, nullptr where there is none.
[[nodiscard]] const Machine* findBuiltInMachine(std::string_view id);

/// `M` of the command line: a built-in id, or else the path of a machine file.
[[nodiscard]] Result<Machine> loadMachine(const std::string& id_or_path);

}  // namespace nineline::kinematics
