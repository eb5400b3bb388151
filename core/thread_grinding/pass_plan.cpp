#include "core/thread_grinding/pass_plan.h"

#include <cmath>

#include "core/base/contract.h"

namespace nineline::thread_grinding {
namespace {
constexpr double kMostPasses = 1e5;
}

double roughingPassCount(double depth, double infeed, double min_last_ratio) {
  const double count = std::ceil(depth / infeed - 1e-9);
  if (count <= 1.0) return 1.0;
  const double last_step = depth - (count - 1.0) * infeed;
  return last_step < min_last_ratio * infeed ? count - 1.0 : count;
}

double passSpeed(const PassPlan& plan, std::size_t index, std::size_t count) {
  if (count < 2) return plan.speed_first;
  const double fraction = static_cast<double>(index) / static_cast<double>(count - 1);
  if (plan.speed_plan == SpeedPlan::Geometric)
    return plan.speed_first * std::pow(plan.speed_last / plan.speed_first, fraction);
  return plan.speed_first + (plan.speed_last - plan.speed_first) * fraction;
}

std::vector<ThreadPass> planPasses(const PassPlan& plan) {
  const double finishing_depth = plan.finishing_passes * plan.finishing_infeed;
  const double roughing_depth = plan.depth - finishing_depth;
  NL_EXPECTS(plan.infeed > 0.0 && roughing_depth > 0.0, plan.infeed, roughing_depth);
  const double roughing = roughingPassCount(roughing_depth, plan.infeed, plan.min_last_ratio);
  NL_EXPECTS(roughing + plan.finishing_passes + plan.spark_out_passes <= kMostPasses, roughing);

  std::vector<ThreadPass> passes;
  for (int i = 1; i <= static_cast<int>(roughing); ++i) {
    const bool last = i == static_cast<int>(roughing);
    passes.push_back({PassKind::Roughing, last ? roughing_depth : i * plan.infeed, 0.0});
  }
  for (int i = 1; i <= plan.finishing_passes; ++i) {
    const int left = plan.finishing_passes - i;
    passes.push_back({PassKind::Finishing, plan.depth - left * plan.finishing_infeed, 0.0});
  }
  for (int i = 0; i < plan.spark_out_passes; ++i) passes.push_back({PassKind::SparkOut, plan.depth, 0.0});
  for (std::size_t i = 0; i < passes.size(); ++i) passes[i].speed = passSpeed(plan, i, passes.size());
  return passes;
}

}  // namespace nineline::thread_grinding
