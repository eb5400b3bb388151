#include "core/errors/effect_specs.h"

namespace nineline::errors {

std::vector<EffectSpec> dynamicSpecs() { return {}; }

}  // namespace nineline::errors
