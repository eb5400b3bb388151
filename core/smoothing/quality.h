#pragma once

#include "core/smoothing/axis_motion.h"
#include "core/smoothing/smoothing.h"

namespace nineline::smoothing {

/// Gathers the jumps of second differences of every axis at the programmed points, as programmed and as
/// smoothed, over the chord lengths of the programmed points.
class JumpStatistics {
 public:
  explicit JumpStatistics(const Machine& machine);
  /// Points of one curve: chord lengths, axis values as programmed and on the curve.
  void add(const std::vector<double>& lengths, const std::vector<nc::AxisValues>& before,
           const std::vector<nc::AxisValues>& after);
  [[nodiscard]] std::vector<AxisJumps> result() const;

 private:
  std::vector<AxisJumps> jumps_;  // rms members hold sums of squares
  std::size_t count_ = 0;
};

}  // namespace nineline::smoothing
