#pragma once

#include "core/discovery/effect_library.h"

namespace nineline::discovery {

/// Looks through all periods of every wave site in a whitened residual and puts the strongest into the bank
/// as options (Dictionary::update takes them over). Gives the number of new options.
std::size_t scanWaves(EffectLibrary& library, const NoiseModel& model, const Noise& noise,
                      const VectorXd& whitened_residual);

}  // namespace nineline::discovery
