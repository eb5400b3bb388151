#pragma once

#include <span>
#include <vector>

#include "core/estimation/basis.h"

namespace nineline::estimation {

/// Parameters that stand or fall together: one constant, one slope, the shape of one table.
struct ParameterChunk {
  std::vector<Index> parameters;
  MatrixXd prior;  ///< precision of what is known without readings; empty: nothing
};

/// Whether the readings tell a chunk, given that all chunks told before it are unknown too.
struct Telling {
  bool told = false;
  bool has_influence = false;  ///< readings depend on it at all
  Index directions = 0;        ///< how many of its parameters' combinations are told
  /// Chunks that the readings mix it up with, the strongest first; only where it is not told.
  std::vector<std::size_t> partners;
};

/// Tells parameters apart in the order of the chunks: where two chunks show the same in all readings, the
/// first is told and the second is not. `information` is the normal matrix with zeros and run offsets
/// projected out; `plausible` says how large each parameter may reasonably be. A combination is told when its
/// standard uncertainty, all told parameters before it being unknown, is below that size, and when what is
/// left of its information exceeds the rounding of the whole (`kRankTolerance`: 1e-11 of it, 3e-6 of the
/// singular values).
inline constexpr double kRankTolerance = 1e-11;
[[nodiscard]] std::vector<Telling> tellApart(const MatrixXd& information, const VectorXd& plausible,
                                             std::span<const ParameterChunk> chunks);

/// Eigenvalues of the information in plausible units, ascending, and the number above `kRankTolerance` of the
/// largest: the rank.
struct Rank {
  VectorXd eigenvalues;
  Index rank = 0;
};
[[nodiscard]] Rank rankOf(const MatrixXd& information, const VectorXd& plausible);

}  // namespace nineline::estimation
