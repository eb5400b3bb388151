#pragma once

#include <cstddef>
#include <string_view>

#include "core/base/result.h"
#include "core/thread_grinding/thread_plan.h"
#include "core/thread_grinding/virtual_cut.h"

namespace nineline::thread_grinding {

/// The thread found on a virtual workpiece.
struct CutThread {
  Hand hand = Hand::Right;
  double lead = 0.0;     ///< mm
  int starts = 0;        ///< grooves at full depth
  double depth = 0.0;    ///< mm below the crest
  std::size_t runs = 0;  ///< cuts from end to end
};

/// Cuts a virtual thread with a program text on a machine that moves as `axes` says. Reads the text with the
/// program's own reader. Fails with NoAnswer when hand, lead, number, place or depth of the grooves, or any
/// single pass, is not what the parameters ask for.
[[nodiscard]] Result<CutThread> checkHand(std::string_view program, const ThreadParameters& parameters,
                                          const ThreadPlan& plan, const AxisConvention& axes);

/// The same on motions that have been cut already.
[[nodiscard]] Result<CutThread> judgeCut(const VirtualCut& cut, const ThreadParameters& parameters,
                                         const ThreadPlan& plan);

/// The blank for these parameters.
[[nodiscard]] VirtualBlank blankOf(const ThreadParameters& parameters, const ThreadPlan& plan);

}  // namespace nineline::thread_grinding
