#include "tests/campaign/campaign.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace nineline::campaign {
namespace {

constexpr unsigned kFirstSeed = 7001;
constexpr unsigned kCases = 12;
constexpr int kBlocks = 25;

TEST(Campaign, RemovesNearlyAllOfWhatTheAxesCanCorrect) {
  PathFigures before;
  PathFigures after;
  for (unsigned seed = kFirstSeed; seed < kFirstSeed + kCases; ++seed) {
    const Case one = drawCase(seed, kBlocks);
    const Outcome outcome = run(one, writings().at(2), nullptr);
    ASSERT_EQ(outcome.fault, "") << "seed " << seed << "\n" << one.program.text;
    before.add(outcome.paths.before);
    after.add(outcome.paths.after);
  }
  EXPECT_GT(before.rms(), 5e-3);
  EXPECT_GT(removedPercent(before, after), 99.0);
}

TEST(Campaign, LinuxCncReadsTheSameMeaning) {
  if (!SecondOpinion::isInstalled()) GTEST_SKIP() << "needs rs274 (package linuxcnc-uspace)";
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / fmt::format("nineline-campaign-{}", ::getpid());
  const SecondOpinion opinion(folder);
  for (unsigned seed = kFirstSeed; seed < kFirstSeed + kCases; ++seed) {
    const Case one = drawCase(seed, kBlocks);
    const Outcome outcome = run(one, writings().at(1), &opinion);
    EXPECT_EQ(outcome.fault, "") << "seed " << seed << "\n" << one.program.text;
    EXPECT_EQ(outcome.meaning, "") << "seed " << seed << "\n" << one.program.text;
    EXPECT_TRUE(outcome.second_read) << "seed " << seed;
  }
  std::filesystem::remove_all(folder);
}

/// The measure itself must be able to fail: a program that stays as it is keeps its deviation.
TEST(Campaign, SeesThatAnUncorrectedProgramKeepsItsErrors) {
  const Case one = drawCase(kFirstSeed, kBlocks);
  const PlainPhysics physics(one.machine);
  nc::InterpreterOptions options;
  options.dialect = nc::Dialect::Fanuc;
  options.tool_lengths[1] = one.program.tool_length;
  for (const PlainJoint& joint : one.machine.joints)
    options.axes.axes[static_cast<std::size_t>(options.axes.count++)] = {
        {joint.letter, 0}, joint.rotary, joint.diameter};
  const Result<std::vector<PlainMotion>> motions = motionsOf(one.program.text, options);
  ASSERT_TRUE(motions) << motions.error().message();
  const PathComparison same =
      comparePaths(physics, one.program.text, *motions, one.program.text, *motions, options.start);
  EXPECT_EQ(same.fault, "");
  EXPECT_NEAR(same.after.rms(), same.before.rms(), 1e-9 + 0.001 * same.before.rms());
  EXPECT_LT(removedPercent(same.before, same.after), 1.0);
}

TEST(SecondOpinion, SeesAChangedFeedAndAChangedPlace) {
  const std::string a =
      "  1 N1 SET_FEED_RATE(100.0000)\n 2 N2 STRAIGHT_FEED(1.0, 2.0)\n 3 N3 COMMENT(\"x\")\n";
  EXPECT_EQ(changedMeaning(a, a), "");
  std::string b = a;
  b.replace(b.find("100.0"), 5, "101.0");
  EXPECT_NE(changedMeaning(a, b), "");
  b = a;
  b.replace(b.find("2.0)"), 4, "2.9)");
  EXPECT_NE(changedMeaning(a, b), "");
}

}  // namespace
}  // namespace nineline::campaign
