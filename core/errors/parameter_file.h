#pragma once

#include "core/errors/effect.h"
#include "core/errors/effect_spec.h"

namespace nineline::errors {

/// The member `parameters` of an entry: {"k": {"value": 11.2, "sigma": 0.3, "unit": "um/m/C"}}.
[[nodiscard]] Json parametersToJson(const std::vector<Parameter>& parameters);

/// Reads them; a parameter may be a bare number. Those that have a standard value or are optional may be
/// missing and stay out. Fails at the place of the fault.
[[nodiscard]] Result<std::vector<Parameter>> readParameters(JsonReader& reader, const EffectSpec& spec,
                                                            const UnitChoice& units);

}  // namespace nineline::errors
