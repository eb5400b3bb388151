#include "core/smoothing/quality.h"

#include <algorithm>
#include <cmath>

namespace nineline::smoothing {

namespace {

/// Second divided difference, the estimate of the second derivative at point j.
double secondDifference(const std::vector<double>& l, const std::vector<nc::AxisValues>& q, std::size_t axis,
                        std::size_t j) {
  const double in = (q[j][axis] - q[j - 1][axis]) / (l[j] - l[j - 1]);
  const double out = (q[j + 1][axis] - q[j][axis]) / (l[j + 1] - l[j]);
  return 2.0 * (out - in) / (l[j + 1] - l[j - 1]);
}

}  // namespace

JumpStatistics::JumpStatistics(const Machine& machine) {
  for (int i = 0; i < machine.jointCount(); ++i) {
    AxisJumps one;
    one.axis = machine.joint(i).axis;
    one.rotary = machine.isRotary(i);
    jumps_.push_back(one);
  }
}

void JumpStatistics::add(const std::vector<double>& lengths, const std::vector<nc::AxisValues>& before,
                         const std::vector<nc::AxisValues>& after) {
  if (lengths.size() < 4) return;
  count_ += lengths.size() - 3;
  for (std::size_t axis = 0; axis < jumps_.size(); ++axis) {
    AxisJumps& one = jumps_[axis];
    for (std::size_t j = 1; j + 2 < lengths.size(); ++j) {
      const double was = std::abs(secondDifference(lengths, before, axis, j + 1) -
                                  secondDifference(lengths, before, axis, j));
      const double is =
          std::abs(secondDifference(lengths, after, axis, j + 1) - secondDifference(lengths, after, axis, j));
      one.before_max = std::max(one.before_max, was);
      one.after_max = std::max(one.after_max, is);
      one.before_rms += was * was;
      one.after_rms += is * is;
    }
  }
}

std::vector<AxisJumps> JumpStatistics::result() const {
  std::vector<AxisJumps> jumps = jumps_;
  for (AxisJumps& one : jumps) {
    const double count = std::max(1.0, static_cast<double>(count_));
    one.before_rms = std::sqrt(one.before_rms / count);
    one.after_rms = std::sqrt(one.after_rms / count);
  }
  return jumps;
}

}  // namespace nineline::smoothing
