#pragma once

#include "core/discovery/effect_library.h"
#include "core/errors/nonparametric_effect.h"

namespace nineline::discovery {

/// A structure without a name: smooth functions at one component of one joint, side by side.
struct SmoothStructure {
  std::string name;  ///< "f(Z) at EXZ, by direction"
  errors::Placement placement;
  std::vector<errors::SmoothForm> forms;
  double unit = 1.0;  ///< µm or arcsec of a coefficient at 1
};

/// Every smooth structure that the campaign could show: of a joint's position, alone or times direction,
/// time, temperature or load, over the whole travel and over windows of it; and of each condition alone.
[[nodiscard]] std::vector<SmoothStructure> smoothStructures(const Campaign& campaign, double typical_size);

/// Its columns, in units of the repeatability.
[[nodiscard]] RowMatrix columnsOf(const Campaign& campaign, const SmoothStructure& structure);

/// As a candidate; penalties are its own.
[[nodiscard]] Candidate candidateOf(const Campaign& campaign, const SmoothStructure& structure);

}  // namespace nineline::discovery
