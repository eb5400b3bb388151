#pragma once

#include "core/discovery/campaign.h"
#include "core/discovery/report.h"

namespace nineline::discovery {

/// Where a contribution (in repeatabilities, by reading) lies: box peeling on the instrument that sees it
/// best. The sentence names only conditions that the box cuts by more than 15 % of their range.
[[nodiscard]] Place placeOf(const Campaign& campaign, const VectorXd& contribution);

}  // namespace nineline::discovery
