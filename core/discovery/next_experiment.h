#pragma once

#include "core/discovery/report.h"

namespace nineline::discovery {

/// The measurement that would tell the least certain name from its likeliest look-alike, in words of the
/// catalogue; empty when every name is sure or no measurement is known to help.
[[nodiscard]] std::string nextExperiment(const DiscoveryReport& report);

}  // namespace nineline::discovery
