#pragma once

#include "core/discovery/report.h"
#include "core/discovery/selection.h"

namespace nineline::discovery {

/// How sure a name is, and what else the same readings may be.
struct NameJudgement {
  double confidence = 0.0;  ///< of effect and joint
  double evidence = 0.0;    ///< −2 ln L that the member is worth
  std::vector<LookAlikeFound> lookalikes;
};

/// Replaces a member by each of its best substitutes with the noise estimated anew; probabilities go by half
/// the difference, because the formulas of a library are approximate.
[[nodiscard]] NameJudgement judgeName(Selection& selection, std::size_t member);

}  // namespace nineline::discovery
