#pragma once

#include <vector>

#include "core/simulation/simulation.h"

namespace nineline::models {

/// What a curve of errors runs over.
enum class Abscissa { Length, Time, Position };

/// An error of a path as a curve: mm, s or deg against µm or arcsec. Rapid motions are left out.
struct PathCurve {
  std::vector<double> x, y;
};

/// The error of one joint (index from 0), or of the tool tip's distance (`joint` < 0).
[[nodiscard]] PathCurve pathCurve(const kinematics::Machine& machine,
                                  const std::vector<simulation::PathSample>& samples,
                                  const std::vector<simulation::PathSample>& commands, int joint,
                                  Abscissa abscissa);

}  // namespace nineline::models
