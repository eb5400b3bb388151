#pragma once

#include <vector>

#include "core/compensation/compensation.h"

namespace nineline::cli {

/// Collects the last uninterrupted cut that the check of a corrected thread program compares: the finished
/// thread.
class FinalPass {
 public:
  /// One place of the cut: the original command, and what became of it.
  struct Place {
    simulation::PathSample before;
    simulation::PathSample after;
  };
  /// `turning`: the joint whose motion tells the cut from the infeed before it.
  explicit FinalPass(int turning) : turning_(static_cast<std::size_t>(turning)) {}
  /// Places in their order.
  void add(const simulation::PathSample& before, const simulation::PathSample& after);
  /// From the end of the infeed to the end of the cut; empty where nothing was cut.
  [[nodiscard]] std::vector<Place> places() const;

 private:
  std::size_t turning_;
  bool ended_ = true;
  std::vector<Place> run_;
};

}  // namespace nineline::cli
