#include "core/thread_grinding/thread_checks.h"

#include "core/thread_grinding/check_groups.h"

namespace nineline::thread_grinding {

Diagnostics checkThread(const ThreadParameters& parameters, const MachineLimits& limits) {
  Diagnostics findings;
  for (const ValueCheck check : valueChecks()) {
    check(parameters, limits, findings);
    if (findings.hasErrors() && check == valueChecks().front())
      return findings;  // not finite: nothing is known
  }
  if (findings.hasErrors()) return findings;
  const ThreadCase thread{parameters, limits, derive(parameters, limits)};
  for (const PlanCheck check : planChecks()) check(thread, findings);
  return findings;
}

}  // namespace nineline::thread_grinding
