#pragma once

#include <QString>

#include "core/kinematics/machine.h"

namespace nineline::models {

/// "12.35 mm", "4.2 m".
[[nodiscard]] QString lengthText(double length);
/// "42 s", "3 min 20 s", "1 h 5 min".
[[nodiscard]] QString timeText(double seconds);
/// "X 23.0798  Z −1.5000  C 15.0000": a command as a control shows it.
[[nodiscard]] QString commandText(const kinematics::Machine& machine, const kinematics::JointPositions& q);
/// "+12.3 µm" or "−4.1″" with three significant digits.
[[nodiscard]] QString deviationText(double value, bool angular);

}  // namespace nineline::models
