#pragma once

#include "core/discovery/dictionary.h"

namespace nineline::discovery {

struct SearchOptions {
  std::size_t width = 3;   ///< sets kept at each depth
  std::size_t branch = 4;  ///< continuations tried of each
  std::size_t depth = 9;
  Dictionary::Which which = Dictionary::Which::Named;
  double margin = 0.0;  ///< fall of the score that a member must be worth
};

/// The non-linear parameters of every member moved to where the score is least, one after the other. Members
/// keep their places in the set.
[[nodiscard]] OptionSet refine(Dictionary& dictionary, OptionSet set, int rounds = 1);

/// Beam search for the set of options with the least score, then `polish`.
[[nodiscard]] OptionSet search(Dictionary& dictionary, const SearchOptions& options);

/// Backward elimination, one-for-one swaps over all options, two-for-one replacement and additions, until
/// nothing improves.
[[nodiscard]] OptionSet polish(Dictionary& dictionary, OptionSet set, const SearchOptions& options);

/// The set without one member.
[[nodiscard]] OptionSet without(const OptionSet& set, std::size_t option);
[[nodiscard]] OptionSet with(const OptionSet& set, std::size_t option);
/// True when a member is an option of the same candidate.
[[nodiscard]] bool hasCandidateOf(const Dictionary& dictionary, const OptionSet& set, std::size_t option);
/// Options by falling value, −∞ left out; at most one for each candidate.
[[nodiscard]] std::vector<std::size_t> bestPerCandidate(const Dictionary& dictionary, const VectorXd& value,
                                                        std::size_t most);

}  // namespace nineline::discovery
