#pragma once

#include <vector>

#include "core/thread_grinding/thread_parameters.h"
#include "core/thread_grinding/thread_path.h"

namespace nineline::thread_grinding {

/// The parameters with every absent value derived. mm, rad, s.
struct ThreadPlan {
  ThreadGeometry geometry;
  double depth = 0.0;           ///< full depth below the crest
  double depth_limit = 0.0;     ///< sharp root: 7/8 H external, 3/4 H internal
  double crest_radius = 0.0;    ///< of the blank at wz = 0: d/2, or D1/2 of the bore
  double inward = 1.0;          ///< +1: deeper is a smaller radius (external); −1: a larger one (internal)
  double lead_in_needed = 0.0;  ///< to reach the highest speed and let the servo lag settle
  double lead_in = 0.0;
  double run_out = 0.0;
  double relief = 0.0;
  double wheel_diameter = 0.0;
  double wheel_width = 0.0;
  double wheel_tilt = 0.0;
  double first_wz = 0.0;           ///< where a pass begins, lead-in included
  double last_wz = 0.0;            ///< where it ends, run-out included
  double roughing_count = 0.0;     ///< also where it is too large to be planned
  std::vector<ThreadPass> passes;  ///< empty when the infeed or the finishing passes make no plan
  std::vector<int> start_indices;
};

/// Most passes that a plan is made for.
inline constexpr double kMostRoughingPasses = 10000.0;

/// v²/(2a) + 5 v/Kv with v = ω L/2π: the path on which Z reaches the speed and the lag settles to 1 %.
[[nodiscard]] double neededLeadIn(double speed, double lead, const MachineLimits& limits);

/// Requires positive sizes, pitch, starts and infeed (the first group of `checkThread`).
[[nodiscard]] ThreadPlan derive(const ThreadParameters& parameters, const MachineLimits& limits);

/// Radius of the contact at wz = 0 for a depth below the crest.
[[nodiscard]] double radiusAtDepth(const ThreadPlan& plan, double depth);

/// The screw line of one pass and start. `roughing_side` ±1 chooses the flank of a pass with flank infeed.
[[nodiscard]] ThreadPath passPath(const ThreadParameters& parameters, const ThreadPlan& plan, double depth,
                                  int start_index, double roughing_side = 1.0);

/// x (model) to which the wheel is retracted for the return: `relief` from full depth where the blank reaches
/// furthest towards the wheel.
[[nodiscard]] double retractX(const ThreadParameters& parameters, const ThreadPlan& plan);

/// How many blocks the C–Z motion of one pass takes.
[[nodiscard]] double blocksPerPass(const ThreadParameters& parameters, const ThreadPlan& plan);

}  // namespace nineline::thread_grinding
