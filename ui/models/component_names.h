#pragma once

#include <QString>
#include <string>
#include <vector>

#include "core/errors/component.h"
#include "core/kinematics/machine.h"

namespace nineline::models {

/// The six motion errors of a joint (EXZ EYZ EZZ EAZ EBZ ECZ for Z) and its six location errors (X0Z … C0Z).
[[nodiscard]] std::vector<errors::Component> motionComponents(AxisId axis);
[[nodiscard]] std::vector<errors::Component> locationComponents(AxisId axis);

/// "positioning error of Z", "straightness of Z in X", "roll of Z about Z": plain words.
[[nodiscard]] QString descriptionOf(const errors::Component& component, const kinematics::Machine& machine);
/// "µm" or "″".
[[nodiscard]] QString unitOf(const errors::Component& component);
/// "mm" or "°".
[[nodiscard]] QString positionUnitOf(const kinematics::Machine& machine, int joint);
/// The machine's name; built-in machines have one in the user's language.
[[nodiscard]] QString machineName(const kinematics::Machine& machine);
/// Plain words for an effect's id: "Scale error", "Backlash"….
[[nodiscard]] QString effectName(const std::string& id);
/// Plain words for an effect's parameter.
[[nodiscard]] QString parameterName(const std::string& effect, const std::string& parameter);
/// The unit as people write it, from the unit of files: "um/m/C" → "µm/(m·°C)".
[[nodiscard]] QString shownUnit(const std::string& unit);

}  // namespace nineline::models
