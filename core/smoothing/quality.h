#pragma once

#include "core/smoothing/axis_motion.h"
#include "core/smoothing/smoothing.h"

namespace nineline::smoothing {

/// Gathers the jumps of second differences of every axis, as programmed (axes in step from point to point)
/// and as smoothed, at the same places of the chord length.
class JumpStatistics {
 public:
  explicit JumpStatistics(const Machine& machine);
  /// Samples of one curve: places, axis values as programmed and on the curve.
  void add(const std::vector<double>& lengths, const std::vector<nc::AxisValues>& before,
           const std::vector<nc::AxisValues>& after);
  [[nodiscard]] std::vector<AxisJumps> result() const;

 private:
  std::vector<AxisJumps> jumps_;  // rms members hold sums of squares
  std::size_t count_ = 0;
};

}  // namespace nineline::smoothing
