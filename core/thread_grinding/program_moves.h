#pragma once

#include <functional>
#include <string_view>

#include "core/base/result.h"
#include "core/thread_grinding/thread_parameters.h"
#include "core/thread_grinding/virtual_cut.h"

namespace nineline::thread_grinding {

/// Executes a program text and hands out its motions in model coordinates, from the block on at which X, Z
/// and C have all been stated. Fails with BadInput where the text is not understood.
[[nodiscard]] Result<void> forEachMove(std::string_view program, const AxisConvention& axes,
                                       const std::function<void(const VirtualMove&)>& use);

}  // namespace nineline::thread_grinding
