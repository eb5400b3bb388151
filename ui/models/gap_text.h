#pragma once

#include <QString>

#include "ui/jobs/gap_job.h"

namespace nineline::models {

/// One sentence: what the search says about the model.
[[nodiscard]] QString verdictText(const discovery::DiscoveryReport& report);

/// True where the report's model differs from the one that the search began with.
[[nodiscard]] bool addsSomething(const discovery::DiscoveryReport& report);

/// How the gap shrinks, effect by effect, and on runs that the search did not see (rich text).
[[nodiscard]] QString shrinkText(const jobs::GapOutcome& gap);

/// Where the gap lies, faults of the data, the next measurement, and what is known about one found effect
/// (may be null): rich text.
[[nodiscard]] QString detailsText(const discovery::DiscoveryReport& report,
                                  const discovery::FoundEffect* effect);

}  // namespace nineline::models
