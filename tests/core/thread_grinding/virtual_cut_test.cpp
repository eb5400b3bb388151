#include "core/thread_grinding/virtual_cut.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nineline::thread_grinding {
namespace {

VirtualBlank bar() {
  VirtualBlank blank;
  blank.crest_radius = 20.0;
  blank.length = 10.0;
  return blank;
}

VirtualMove move(ThreadPoint from, ThreadPoint to, bool rapid = false) { return {from, to, rapid, 7}; }

std::vector<GrooveRun> runsOf(const VirtualBlank& blank, const std::vector<VirtualMove>& moves) {
  VirtualCut cut(blank);
  for (const VirtualMove& each : moves) cut.add(each);
  cut.finish();
  EXPECT_FALSE(cut.fault()) << *cut.fault();
  return cut.runs();
}

TEST(VirtualCut, TableAndSpindleBothPositiveCutARightHandThread) {
  // z falls by 12 mm while γ falls by 6 turns: dz/dγ = +2 mm a turn.
  const std::vector<GrooveRun> runs = runsOf(bar(), {move({19.5, 1.0, 0.0}, {19.5, -11.0, -6.0 * kTurn})});
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_NEAR(runs[0].slope * kTurn, 2.0, 1e-12);
  EXPECT_NEAR(runs[0].depth, 0.5, 1e-12);
  EXPECT_NEAR(runs[0].first_wz, 0.0, 2e-3);
  EXPECT_NEAR(runs[0].last_wz, 10.0, 2e-3);
}

TEST(VirtualCut, TheSpindleTurningTheOtherWayCutsALeftHandThread) {
  const std::vector<GrooveRun> runs = runsOf(bar(), {move({19.5, 1.0, 0.0}, {19.5, -11.0, 6.0 * kTurn})});
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_NEAR(runs[0].slope * kTurn, -2.0, 1e-12);
}

TEST(VirtualCut, NothingIsCutOutsideTheBlank) {
  EXPECT_TRUE(runsOf(bar(), {move({20.5, 1.0, 0.0}, {20.5, -11.0, 1.0}),         // above the crest
                             move({19.0, 5.0, 0.0}, {19.0, 1.0, 9.0}),           // before its end
                             move({25.0, -5.0, 0.0}, {21.0, -5.0, 0.0}, true)})  // only near it
                  .empty());
}

TEST(VirtualCut, BlocksOfOnePassAreOneRunAndARetractSeparatesPasses) {
  const double turn = kTurn;
  const std::vector<GrooveRun> runs = runsOf(
      bar(),
      {move({19.5, 0.0, 0.0}, {19.5, -5.0, -turn}), move({19.5, -5.0, -turn}, {19.5, -10.0, -2.0 * turn}),
       move({19.5, -10.0, -2.0 * turn}, {22.0, -10.0, -2.0 * turn}, true),
       move({22.0, -10.0, -2.0 * turn}, {22.0, 0.0, 0.0}, true), move({22.0, 0.0, 0.0}, {19.0, 0.0, 0.0}),
       move({19.0, 0.0, 0.0}, {19.0, -10.0, -2.0 * turn})});
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_NEAR(runs[0].slope, 5.0 / turn, 1e-12);
  EXPECT_NEAR(runs[1].depth, 1.0, 1e-12);
}

TEST(VirtualCut, AKinkShowsAsResidual) {
  const std::vector<GrooveRun> runs =
      runsOf(bar(), {move({19.5, 0.0, 0.0}, {19.5, -5.0, -kTurn}),
                     move({19.5, -5.0, -kTurn}, {19.5, -10.0, -2.1 * kTurn})});
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_GT(runs[0].residual, 0.05);
}

TEST(VirtualCut, RapidsThroughTheWorkAndWheelsBeyondTheAxisAreFaults) {
  VirtualCut rapid(bar());
  rapid.add(move({19.9, 1.0, 0.0}, {19.9, -11.0, 0.0}, true));
  ASSERT_TRUE(rapid.fault());
  EXPECT_NE(rapid.fault()->find("line 7"), std::string::npos);
  VirtualCut beyond(bar());
  beyond.add(move({-19.5, 1.0, 0.0}, {-19.5, -11.0, 1.0}));
  EXPECT_TRUE(beyond.fault());
}

TEST(VirtualCut, ABoreIsCutFromInside) {
  VirtualBlank bore = bar();
  bore.type = ThreadType::Internal;
  EXPECT_TRUE(runsOf(bore, {move({19.5, 1.0, 0.0}, {19.5, -11.0, 1.0})}).empty());
  const std::vector<GrooveRun> runs = runsOf(bore, {move({20.25, 1.0, 0.0}, {20.25, -11.0, 1.0})});
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_NEAR(runs[0].depth, 0.25, 1e-12);
}

TEST(VirtualCut, AContactAboveTheAxisCutsAtItsTrueRadius) {
  VirtualBlank blank = bar();
  blank.contact_height = 12.0;
  const std::vector<GrooveRun> runs = runsOf(blank, {move({15.0, 1.0, 0.0}, {15.0, -11.0, 3.0})});
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_NEAR(runs[0].depth, 20.0 - std::hypot(15.0, 12.0), 1e-12);
}

}  // namespace
}  // namespace nineline::thread_grinding
