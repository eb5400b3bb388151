#pragma once

#include <string>

#include "core/kinematics/machine.h"
#include "core/thread_grinding/thread_parameters.h"

namespace nineline::cli {

/// Fills what the limits of a thread leave open from a machine: travel, rapid speeds, and the sense in which
/// its axes X, Z and C really move. Fails when the machine has no such axes, or when they do not lie as a
/// thread grinder's.
[[nodiscard]] Result<void> takeLimits(const kinematics::Machine& machine, thread_grinding::ThreadJob& job);

}  // namespace nineline::cli
