#pragma once

#include <string_view>

#include "core/base/axis_id.h"
#include "core/errors/effect_spec.h"

namespace nineline::errors {

/// Whether an effect at an axis may follow a column, judged by the column's name: temp_screw_Z_C is the screw
/// of Z and no room; a name that says nothing (temp_t1_C) suits every effect that follows a temperature.
[[nodiscard]] bool suitsSensor(const EffectSpec& spec, const AxisId& axis, std::string_view column);

}  // namespace nineline::errors
