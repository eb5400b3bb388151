#pragma once

#include <initializer_list>

#include "core/nc/execution.h"

namespace nineline::nc {

/// Where a line stands.
struct Place {
  std::uint64_t offset = 0;
  std::size_t line = 1;
};

/// A set of flow keywords.
class FlowSet {
 public:
  FlowSet(std::initializer_list<Flow> flows) {
    for (const Flow flow : flows) bits_ |= 1U << static_cast<unsigned>(flow);
  }
  [[nodiscard]] bool contains(Flow flow) const { return (bits_ >> static_cast<unsigned>(flow) & 1U) != 0; }

 private:
  std::uint32_t bits_ = 0;
};

/// Finds all subprograms of the file, once.
bool indexPrograms(Execution& e);
/// The line that `e.jump` names, by N number or label.
bool findLabel(Execution& e, Place& place);
/// The next line from here with this label and one of the keywords.
bool findFlow(Execution& e, const std::string& label, FlowSet flows, Place& place, Flow& found);
/// The innermost loop, if it has this label.
LoopLevel* openLoopHere(Execution& e, const std::string& label);

}  // namespace nineline::nc
