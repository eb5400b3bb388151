#pragma once

#include <vector>

#include "core/simulation/simulation.h"

namespace nineline::cli {

/// Collects the last uninterrupted cut of a simulated thread program: the finished thread.
class FinalPass {
 public:
  /// `turning`: the joint whose motion tells the cut from the infeed before it.
  explicit FinalPass(int turning) : turning_(static_cast<std::size_t>(turning)) {}
  /// Samples in their order.
  void add(const simulation::PathSample& sample);
  /// From the end of the infeed to the end of the cut; empty where nothing was cut.
  [[nodiscard]] std::vector<simulation::PathSample> samples() const;

 private:
  std::size_t turning_;
  bool ended_ = true;
  std::vector<simulation::PathSample> run_;
};

/// One error along a cut.
struct Curve {
  std::vector<double> position;  ///< mm
  std::vector<double> error;     ///< mm, rad
};

/// Error of a joint over the position of joint `along`, as a program runs uncorrected.
[[nodiscard]] Curve errorCurve(const std::vector<simulation::PathSample>& pass, int joint, int along);

/// Error of a joint that is left: the actual tool of the corrected pass against the command that the original
/// pass gives at the same time from the beginning of the cut.
[[nodiscard]] Curve residualCurve(const kinematics::Machine& machine,
                                  const std::vector<simulation::PathSample>& original,
                                  const std::vector<simulation::PathSample>& corrected, int joint, int along);

}  // namespace nineline::cli
