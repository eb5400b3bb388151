#pragma once

#include <vector>

#include "core/base/json.h"
#include "core/errors/component.h"
#include "core/kinematics/machine.h"

namespace nineline::models {

/// A curve as a screen shows it: positions in mm or deg, values in µm or arcsec.
struct SampledCurve {
  std::vector<double> x, y;
};

/// The interpolated curve of a table entry; empty while core cannot read it.
[[nodiscard]] SampledCurve sampleTable(const kinematics::Machine& machine, const errors::Component& component,
                                       const Json& entry);

}  // namespace nineline::models
