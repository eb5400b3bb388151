#include "core/errors/effect_specs.h"

namespace nineline::errors {

std::vector<EffectSpec> measurementSpecs() { return {}; }

}  // namespace nineline::errors
