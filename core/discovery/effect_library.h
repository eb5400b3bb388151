#pragma once

#include "core/discovery/campaign.h"
#include "core/errors/effect_factory.h"

namespace nineline::discovery {

/// What stands behind a candidate of the bank: an effect of the catalogue at a place.
struct NamedEffect {
  errors::Candidate effect;
  std::vector<double> scales;  ///< value of each linear coefficient at 1, in its parameter's unit
};

/// A wave whose period or frequency is found by scanning all of them.
struct WaveSite {
  std::size_t candidate = 0;
  bool in_time = false;  ///< frequency in Hz of `t_s`; else period of a joint's position
  double low = 0.0;      ///< of the parameter
  double high = 0.0;
  VectorXd response;  ///< what the readings do per unit of the wave, in repeatabilities
  VectorXd argument;  ///< mm or deg of the joint, or s
};

/// Every effect that the campaign can judge, as candidates with columns.
struct EffectLibrary {
  OptionBank bank;
  std::vector<NamedEffect> named;  ///< of the bank's first candidates, in order
  std::vector<WaveSite> waves;
};

/// The campaign must outlive the library.
[[nodiscard]] EffectLibrary makeLibrary(const Campaign& campaign);

/// The non-linear parameters of an option in their units.
[[nodiscard]] std::vector<errors::Parameter> nonlinearOf(const NamedEffect& named,
                                                         const std::vector<double>& shape);

}  // namespace nineline::discovery
