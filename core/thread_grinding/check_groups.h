#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/base/diagnostics.h"
#include "core/thread_grinding/thread_plan.h"

namespace nineline::thread_grinding {

/// A thread whose plain values are sound, with its derived sizes.
struct ThreadCase {
  const ThreadParameters& parameters;
  const MachineLimits& limits;
  ThreadPlan plan;
};

using ValueCheck = void (*)(const ThreadParameters&, const MachineLimits&, Diagnostics&);
using PlanCheck = void (*)(const ThreadCase&, Diagnostics&);

/// Checks of single values; the first one is that all of them are finite.
[[nodiscard]] std::span<const ValueCheck> valueChecks();
/// Checks of what follows from the values.
[[nodiscard]] std::span<const PlanCheck> planChecks();

/// "<what> is <value>, expected <limit>: <otherwise>."
[[nodiscard]] std::string finding(std::string_view what, double value, std::string_view limit,
                                  std::string_view otherwise);

}  // namespace nineline::thread_grinding
