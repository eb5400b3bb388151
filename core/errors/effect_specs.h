#pragma once

#include <vector>

#include "core/errors/effect_spec.h"

namespace nineline::errors {

/// The parts of the catalogue, one file each; together they are effectCatalogue().
[[nodiscard]] std::vector<EffectSpec> positionSpecs();
[[nodiscard]] std::vector<EffectSpec> rotarySpecs();
[[nodiscard]] std::vector<EffectSpec> reversalSpecs();
[[nodiscard]] std::vector<EffectSpec> dynamicSpecs();
[[nodiscard]] std::vector<EffectSpec> thermalSpecs();
[[nodiscard]] std::vector<EffectSpec> loadSpecs();
[[nodiscard]] std::vector<EffectSpec> measurementSpecs();

}  // namespace nineline::errors
