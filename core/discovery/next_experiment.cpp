#include "core/discovery/next_experiment.h"

#include <fmt/format.h>

namespace nineline::discovery {

std::string nextExperiment(const DiscoveryReport& report) {
  constexpr double kSure = 0.9;
  const FoundEffect* least = nullptr;
  for (const FoundEffect& found : report.effects) {
    if (found.lookalikes.empty() || found.confidence >= kSure || !found.detail_of.empty()) continue;
    if (least == nullptr || found.confidence < least->confidence) least = &found;
  }
  if (least == nullptr) return {};
  const LookAlikeFound& like = least->lookalikes.front();
  return fmt::format("To tell {} at {} from {} at {}: {}.", least->effect, least->joint, like.effect,
                     like.joint, like.why);
}

}  // namespace nineline::discovery
