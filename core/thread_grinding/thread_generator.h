#pragma once

#include <string>
#include <vector>

#include "core/base/json.h"
#include "core/thread_grinding/hand_check.h"
#include "core/thread_grinding/pass_plan.h"
#include "core/thread_grinding/thread_parameters.h"

namespace nineline::thread_grinding {

/// What was generated and what the check found in it.
struct ThreadReport {
  std::size_t passes = 0;          ///< all passes at one start
  std::size_t cutting_passes = 0;  ///< without spark-out
  std::size_t starts = 0;          ///< that are ground
  std::size_t motion_blocks = 0;
  double duration = 0.0;      ///< s, estimated
  double depth = 0.0;         ///< mm
  double final_radius = 0.0;  ///< mm, of the contact at the thread's beginning
  double lead_in = 0.0;       ///< mm
  double run_out = 0.0;       ///< mm
  double wheel_tilt = 0.0;    ///< rad
  ThreadGeometry geometry;
  CutThread cut;  ///< measured on the virtual workpiece
  std::vector<Diagnostic> warnings;
};

struct ThreadProgram {
  std::string text;
  std::vector<ThreadPass> passes;
  ThreadReport report;
};

/// A program in Fanuc style. Fails with BadInput when a parameter is out of its limits, and with NoAnswer
/// when an axis would leave its travel or the virtual cut shows another thread than the one asked for.
[[nodiscard]] Result<ThreadProgram> generateThread(const ThreadParameters& parameters,
                                                   const MachineLimits& limits);

/// The result record of the command line and the window.
[[nodiscard]] Json reportJson(const ThreadReport& report);

}  // namespace nineline::thread_grinding
