#include "core/errors/effect_specs.h"

namespace nineline::errors {

std::vector<EffectSpec> rotarySpecs() { return {}; }

}  // namespace nineline::errors
