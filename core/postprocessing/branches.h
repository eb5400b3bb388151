#pragma once

#include <vector>

#include "core/postprocessing/pose_solver.h"

namespace nineline::postprocessing {

struct BranchOptions {
  int starts = 60;        ///< from a low-discrepancy sequence over the rotary joints' ranges
  bool thorough = false;  ///< uses all starts; else stops when twelve found as many branches as usual
  std::size_t most = 16;  ///< branches; of a redundant chain, different ones of its continuum
};

/// The joint positions that reach a pose, each once but for whole turns, rotary joints within half a turn of
/// the middle of their travel; also those outside the travel. By damped search from many starts, and from the
/// mirror images of what was found (theory.md, 4.4). Empty where nothing reaches the pose.
/// `home` gives the positions of held joints and the starts of linear ones.
[[nodiscard]] std::vector<JointPositions> findBranches(const PoseSolver& solver, const TipAxis& target,
                                                       const JointPositions& home,
                                                       const BranchOptions& options = {});

/// Middle of the travel; 0 where there is none.
[[nodiscard]] JointPositions homeOf(const Machine& machine);
/// True where two positions differ by whole turns alone (1e-6 rad, 1e-4 mm).
[[nodiscard]] bool sameButTurns(const Machine& machine, const JointPositions& a, const JointPositions& b);

}  // namespace nineline::postprocessing
