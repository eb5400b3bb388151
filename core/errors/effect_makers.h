#pragma once

#include <memory>
#include <string>

#include "core/errors/parametric_effects.h"

namespace nineline::errors {

/// Says why a kind of effect has no meaning at a place.
[[nodiscard]] Result<void> checkPlacement(const kinematics::Machine& machine, const EffectSpec& spec,
                                          const Placement& placement);

/// What is wrong with a parameter's value or uncertainty, a sentence; empty when nothing is.
[[nodiscard]] std::string faultOf(const ParameterSpec& rule, const Parameter& parameter);

/// Builds an effect from checked parts. Fails where parameters exclude each other.
[[nodiscard]] Result<std::shared_ptr<Effect>> assembleEffect(EffectParts parts);

}  // namespace nineline::errors
