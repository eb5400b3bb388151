#pragma once

#include "core/discovery/selection.h"
#include "core/discovery/smooth_library.h"

namespace nineline::discovery {

/// What is left beside the named effects: smooth structures of the set, by their candidate in the bank.
struct Leftover {
  std::vector<SmoothStructure> structures;  ///< all that were offered to the dictionary
  std::size_t first_candidate = 0;          ///< of the first of them in the bank
  /// The structure behind an option of the selection's bank.
  [[nodiscard]] const SmoothStructure& of(const OptionBank& bank, std::size_t option) const {
    return structures[bank.options[option].candidate - first_candidate];
  }
};

/// Adds structures without a name to the selection's set where the named effects leave something that repeats
/// on unseen runs; named effects that only stood in for it fall out. An effect that explains nine tenths of
/// what the structure does keeps its name: library formulas are approximate.
[[nodiscard]] Leftover findLeftover(Selection& selection);

}  // namespace nineline::discovery
