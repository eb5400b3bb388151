#include "core/thread_grinding/pass_plan.h"

#include <gtest/gtest.h>

#include "core/base/contract.h"
#include "core/thread_grinding/thread_geometry.h"

namespace nineline::thread_grinding {
namespace {

PassPlan plan(double depth, double infeed) {
  PassPlan result;
  result.depth = depth;
  result.infeed = infeed;
  return result;
}

TEST(PassPlan, LiteratureCaseTakes46Passes) {
  const double depth = threadGeometry(48.0, 1.5, 1).external_depth;
  PassPlan merged = plan(depth, 0.02);
  EXPECT_EQ(planPasses(merged).size(), 46U);
  EXPECT_DOUBLE_EQ(planPasses(merged).back().depth, depth);
  merged.min_last_ratio = 0.0;
  EXPECT_EQ(planPasses(merged).size(), 47U);
}

TEST(PassPlan, ADepthOfWholeInfeedsIsNotSplitByRounding) {
  EXPECT_EQ(planPasses(plan(0.06, 0.02)).size(), 3U);
  EXPECT_EQ(planPasses(plan(0.3, 0.1)).size(), 3U);
}

TEST(PassPlan, ADepthBelowTheInfeedIsOnePass) {
  const std::vector<ThreadPass> passes = planPasses(plan(0.01, 0.02));
  ASSERT_EQ(passes.size(), 1U);
  EXPECT_DOUBLE_EQ(passes[0].depth, 0.01);
}

TEST(PassPlan, FinishingLeavesRoomForItselfAndEndsAtFullDepth) {
  PassPlan finishing = plan(0.5, 0.1);
  finishing.finishing_passes = 2;
  finishing.finishing_infeed = 0.005;
  finishing.spark_out_passes = 1;
  const std::vector<ThreadPass> passes = planPasses(finishing);
  ASSERT_EQ(passes.size(), 8U);  // 0.1 … 0.4, 0.49, 0.495, 0.5, 0.5
  EXPECT_DOUBLE_EQ(passes[4].depth, 0.49);
  EXPECT_EQ(passes[4].kind, PassKind::Roughing);
  EXPECT_DOUBLE_EQ(passes[5].depth, 0.495);
  EXPECT_EQ(passes[5].kind, PassKind::Finishing);
  EXPECT_DOUBLE_EQ(passes[6].depth, 0.5);
  EXPECT_DOUBLE_EQ(passes[7].depth, 0.5);
  EXPECT_EQ(passes[7].kind, PassKind::SparkOut);
}

TEST(PassPlan, DepthsNeverFallAndStepsNeverExceedInfeedPlusTheMergedRest) {
  for (const double depth : {0.013, 0.25, 0.920152, 1.7}) {
    for (const double infeed : {0.003, 0.02, 0.07}) {
      double before = 0.0;
      for (const ThreadPass& pass : planPasses(plan(depth, infeed))) {
        EXPECT_GT(pass.depth, before);
        EXPECT_LE(pass.depth - before, infeed * 1.25 + 1e-12);
        before = pass.depth;
      }
      EXPECT_DOUBLE_EQ(before, depth);
    }
  }
}

TEST(PassPlan, SpeedRisesLinearlyOrGeometrically) {
  PassPlan speeds = plan(0.06, 0.02);
  speeds.speed_first = 1.0;
  speeds.speed_last = 4.0;
  EXPECT_DOUBLE_EQ(planPasses(speeds)[1].speed, 2.5);
  speeds.speed_plan = SpeedPlan::Geometric;
  EXPECT_DOUBLE_EQ(planPasses(speeds)[1].speed, 2.0);
  EXPECT_DOUBLE_EQ(planPasses(speeds)[0].speed, 1.0);
  EXPECT_DOUBLE_EQ(planPasses(speeds)[2].speed, 4.0);
}

TEST(PassPlan, UnsoundValuesAreTheCallersFault) {
  EXPECT_THROW((void)planPasses(plan(0.5, 0.0)), ContractViolation);
  EXPECT_THROW((void)planPasses(plan(0.5, 1e-9)), ContractViolation);
  PassPlan all_finishing = plan(0.01, 0.02);
  all_finishing.finishing_passes = 2;
  all_finishing.finishing_infeed = 0.005;
  EXPECT_THROW((void)planPasses(all_finishing), ContractViolation);
}

}  // namespace
}  // namespace nineline::thread_grinding
