#pragma once

#include "core/errors/effect.h"

namespace nineline::errors {

/// Reads one entry of a model's `effects`. Fails with BadInput at the place of the fault; an effect that this
/// version does not know is a fault, because leaving it out would change the machine silently.
[[nodiscard]] Result<EffectPtr> effectFromJson(const Json& json, const std::string& source,
                                               std::size_t number, const kinematics::Machine& machine);

/// Ids of the effects that this version evaluates.
[[nodiscard]] std::vector<std::string> knownEffects();

}  // namespace nineline::errors
