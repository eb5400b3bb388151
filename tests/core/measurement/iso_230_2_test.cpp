#include "core/measurement/iso_230_2.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/units.h"
#include "core/measurement/vdi_3441.h"

namespace nineline::measurement {
namespace {

constexpr double kRounding = 1e-15;

/// Two targets, two approaches each way: every letter follows by hand. In um here, the unit does not matter.
///   target 0: forward 0 2 (mean 1, s √2), backward 4 4 (mean 4, s 0): B −3
///   target 1: forward 5 5 (mean 5, s 0),  backward 7 11 (mean 9, s 2√2): B −4
TargetRuns handCase() { return {{0.0, 100.0}, {{0.0, 2.0}, {5.0, 5.0}}, {{4.0, 4.0}, {7.0, 11.0}}}; }

TEST(Iso2302, GivesTheLettersOfAHandCase) {
  const Result<Iso2302> found = evaluateIso2302(handCase());
  ASSERT_TRUE(found);
  const double root2 = std::sqrt(2.0);
  EXPECT_NEAR(*found->mean_B, -3.5, kRounding);
  EXPECT_NEAR(*found->B, 4.0, kRounding);
  EXPECT_NEAR(*found->M, 4.5, kRounding);  // means 2.5 and 7
  EXPECT_NEAR(*found->E_forward, 4.0, kRounding);
  EXPECT_NEAR(*found->E_backward, 5.0, kRounding);
  EXPECT_NEAR(*found->E, 8.0, kRounding);  // 1 … 9
  EXPECT_NEAR(*found->R_forward, 4.0 * root2, 1e-14);
  EXPECT_NEAR(*found->R_backward, 8.0 * root2, 1e-14);
  // 2 s + 2 s + |B|: 2√2 + 3 = 5.83 at target 0 (4√2 = 5.66 below it), 4√2 + 4 = 9.66 < 8√2 = 11.31 at target
  // 1
  EXPECT_NEAR(*found->positions[0].R, 2.0 * root2 + 3.0, 1e-14);
  EXPECT_NEAR(*found->R, 8.0 * root2, 1e-14);
  EXPECT_NEAR(*found->A_forward, 5.0 - (1.0 - 2.0 * root2), 1e-14);
  EXPECT_NEAR(*found->A_backward, (9.0 + 4.0 * root2) - (9.0 - 4.0 * root2), 1e-14);
  EXPECT_NEAR(*found->A, (9.0 + 4.0 * root2) - (1.0 - 2.0 * root2), 1e-14);
  EXPECT_EQ(found->fewest_approaches, 2U);
}

TEST(Iso2302, LeavesOutWhatOneDirectionCannotGive) {
  TargetRuns runs = handCase();
  runs.backward.clear();
  const Result<Iso2302> found = evaluateIso2302(runs);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->A_forward && found->E_forward && found->R_forward);
  EXPECT_FALSE(found->A || found->E || found->R || found->M || found->B || found->mean_B);
  EXPECT_FALSE(found->A_backward || found->positions[0].mean || found->positions[0].backward);
}

TEST(Iso2302, NeedsTwoApproachesForScatter) {
  const Result<Iso2302> found = evaluateIso2302({{0.0, 1.0}, {{1.0, 2.0}, {3.0}}, {{1.0}, {4.0}}});
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->A || found->R || found->A_forward || found->R_forward);
  EXPECT_NEAR(*found->E, 3.0, kRounding);
  EXPECT_NEAR(*found->B, 1.0, kRounding);
  EXPECT_EQ(found->fewest_approaches, 1U);
}

/// The letters do not change with the zero of the readings, scale with them, and swap with the directions.
TEST(Iso2302, FollowsShiftScaleAndReversal) {
  const Iso2302 plain = evaluateIso2302(handCase()).value();
  TargetRuns moved = handCase();
  for (auto* direction : {&moved.forward, &moved.backward}) {
    for (auto& values : *direction) {
      for (double& value : values) value = -3.0 * value + 17.0;
    }
  }
  std::swap(moved.forward, moved.backward);
  const Iso2302 found = evaluateIso2302(moved).value();
  EXPECT_NEAR(*found.A, 3.0 * *plain.A, 1e-12);
  EXPECT_NEAR(*found.E, 3.0 * *plain.E, 1e-12);
  EXPECT_NEAR(*found.R, 3.0 * *plain.R, 1e-12);
  EXPECT_NEAR(*found.M, 3.0 * *plain.M, 1e-12);
  EXPECT_NEAR(*found.mean_B, 3.0 * *plain.mean_B, 1e-12);
  EXPECT_NEAR(*found.A_forward, 3.0 * *plain.A_backward, 1e-12);
}

TEST(Iso2302, RefusesWhatItCannotEvaluate) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(evaluateIso2302({}));
  EXPECT_FALSE(evaluateIso2302({{0.0, 0.0}, {{1.0}, {1.0}}, {}}));
  EXPECT_FALSE(evaluateIso2302({{0.0, 1.0}, {{1.0}}, {}}));
  EXPECT_FALSE(evaluateIso2302({{0.0, 1.0}, {{1.0}, {}}, {}}));
  const Result<Iso2302> not_a_number = evaluateIso2302({{0.0, 1.0}, {{1.0}, {nan}}, {}});
  ASSERT_FALSE(not_a_number);
  EXPECT_NE(not_a_number.error().text.find("target 1 in the forward"), std::string::npos);
}

TEST(Iso2302Uncertainty, AddsTheContributionsOfAHandCase) {
  PositioningCircumstances c;
  c.length = 1000.0;
  EXPECT_EQ(uncertaintyOf(c).A, 0.0);
  c.device_expanded = 1e-3;
  EXPECT_NEAR(uncertaintyOf(c).A, 1e-3, 1e-18);  // the device alone, k = 2 as stated
  EXPECT_EQ(uncertaintyOf(c).B, 0.0);            // a long-term error of the device cancels in B and R
  c = {};
  c.length = 1000.0;
  c.environment_variation = std::sqrt(12.0) * 1e-3;  // 1 um standard uncertainty of one reading
  EXPECT_NEAR(uncertaintyOf(c).R, 4e-3, 1e-15);
  EXPECT_NEAR(uncertaintyOf(c).B, 2e-3 * std::sqrt(0.4), 1e-15);
  EXPECT_NEAR(uncertaintyOf(c).M, 2e-3 / std::sqrt(5.0), 1e-15);
  c = {};
  c.length = 1000.0;
  c.misalignment = 1e-3;  // cosine error 0 … 0.5 um
  EXPECT_NEAR(uncertaintyOf(c).E, 2.0 * 0.5e-3 / std::sqrt(12.0), 1e-15);
  c.misalignment = 0.0;
  c.temperature_range = 1.0;  // 11.7 um wide
  c.temperature_off_20 = -5.0;
  c.expansion_range = 2e-6;  // 2e-6 · 1000 · 5 = 10 um wide
  EXPECT_NEAR(uncertaintyOf(c).A, 2.0 * std::hypot(11.7e-3, 10e-3) / std::sqrt(12.0), 1e-15);
}

TEST(Vdi3441, GivesTheFiguresOfAHandCase) {
  const Result<Vdi3441> found = evaluateVdi3441(handCase());
  ASSERT_TRUE(found);
  const double root2 = std::sqrt(2.0);
  EXPECT_NEAR(found->Pa, 4.5, kRounding);
  EXPECT_NEAR(found->U_mean, 3.5, kRounding);
  EXPECT_NEAR(found->U_max, 4.0, kRounding);
  EXPECT_NEAR(found->Ps_max, 6.0 * root2, 1e-14);
  EXPECT_NEAR(found->Ps_mean, 4.5 * root2, 1e-14);
  // 7 + (4 + 6√2)/2 = 13.24; lower ends 2.5 − (3 + 3√2)/2 = −1.12 and 7 − 6.24 = 0.76
  EXPECT_NEAR(found->P, (7.0 + 2.0 + 3.0 * root2) - (2.5 - 1.5 - 1.5 * root2), 1e-14);
  TargetRuns one_way = handCase();
  one_way.backward.clear();
  EXPECT_FALSE(evaluateVdi3441(one_way));
}

}  // namespace
}  // namespace nineline::measurement
