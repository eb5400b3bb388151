#pragma once

#include "core/base/diagnostics.h"
#include "core/thread_grinding/thread_parameters.h"

namespace nineline::thread_grinding {

/// Every parameter against its limits. Each finding has the code "thread.<parameter>" and says value, limit
/// and what happens otherwise; an error means that no program is generated. What depends on derived sizes is
/// checked once the plain values are sound.
[[nodiscard]] Diagnostics checkThread(const ThreadParameters& parameters, const MachineLimits& limits);

}  // namespace nineline::thread_grinding
