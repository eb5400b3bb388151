#pragma once

#include <cstddef>
#include <vector>

namespace nineline::thread_grinding {

enum class PassKind { Roughing, Finishing, SparkOut };
enum class SpeedPlan { Linear, Geometric };

/// One pass over all starts.
struct ThreadPass {
  PassKind kind = PassKind::Roughing;
  double depth = 0.0;  ///< mm: below the crest, radial
  double speed = 0.0;  ///< rad/s of the work spindle
};

struct PassPlan {
  double depth = 0.0;            ///< mm, > 0
  double infeed = 0.02;          ///< mm for each roughing pass, > 0
  double min_last_ratio = 0.25;  ///< a last roughing step below this part of the infeed joins the one before
  int finishing_passes = 0;
  double finishing_infeed = 0.0;  ///< mm for each finishing pass; they leave room for themselves in `depth`
  int spark_out_passes = 0;       ///< at full depth, without infeed
  double speed_first = 1.0;       ///< rad/s
  double speed_last = 1.0;        ///< rad/s
  SpeedPlan speed_plan = SpeedPlan::Linear;
};

/// How many roughing steps bring `depth`: ⌈depth/infeed⌉, one less where the last step would be too thin.
/// Returned as double so that an absurd infeed cannot overflow; whole and ≥ 1 for depth, infeed > 0.
[[nodiscard]] double roughingPassCount(double depth, double infeed, double min_last_ratio);

/// Speed of pass `index` of `count`, rising linearly or geometrically.
[[nodiscard]] double passSpeed(const PassPlan& plan, std::size_t index, std::size_t count);

/// Roughing, finishing, spark-out. The last pass with infeed has exactly the full depth. Requires sound
/// values (depth, infeed > 0, finishing passes that leave depth for roughing, at most 100,000 passes).
[[nodiscard]] std::vector<ThreadPass> planPasses(const PassPlan& plan);

}  // namespace nineline::thread_grinding
