#include "core/errors/effect_specs.h"

namespace nineline::errors {

std::vector<EffectSpec> loadSpecs() { return {}; }

}  // namespace nineline::errors
