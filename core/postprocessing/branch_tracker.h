#pragma once

#include <vector>

#include "core/postprocessing/branches.h"

namespace nineline::postprocessing {

/// One way to stand at a point. `track` stays the same as long as one branch is followed.
struct Alternative {
  JointPositions q{};
  int track = 0;
  int iterations = 0;
};

/// All branches of a path's poses, each followed continuously from point to point. Branches that run into one
/// another at a singular pose are counted once, and searched anew behind it.
class BranchTracker {
 public:
  BranchTracker(const PoseSolver& solver, const JointPositions& home) : solver_(solver), home_(home) {}
  void start(const TipAxis& target);
  void advance(const TipAxis& target);
  /// Looks longer for branches at the present point, where none of those known serves.
  void searchThoroughly() { search(true); }
  [[nodiscard]] const std::vector<Alternative>& alternatives() const { return alternatives_; }

 private:
  void search(bool thorough = false);
  [[nodiscard]] Solution followClosely(const Alternative& from, const TipAxis& to) const;
  const PoseSolver& solver_;
  JointPositions home_;
  TipAxis target_;
  std::vector<Alternative> alternatives_;
  int next_track_ = 0;
  std::size_t complete_ = 0;  // branches that the last full search found
  int until_search_ = 0;
  int search_interval_ = 1;
};

}  // namespace nineline::postprocessing
