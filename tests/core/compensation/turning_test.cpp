// Blocks that turn a rotary axis alone: F counts degrees there, and the control decides what it counts where
// linear axes join (resources/docs/adr/006).
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "core/compensation/verification.h"
#include "core/errors/error_model_file.h"
#include "tests/core/compensation/correction.h"

namespace nineline::compensation {
namespace {

using test_support::hasWarning;
using test_support::linesOf;

const std::string kProgram = "G21 G90 G94\nG0 X50. Z10. C0.\nG1 X40. F200\nC90. F500\nX41.\n";

ErrorModel grinder() {
  return errors::loadErrorModel(NINELINE_SOURCE_DIR "/resources/examples/b2-k3032-model.json").value();
}

CompensatedText needed(const std::string& text, std::optional<nc::Dialect> stated,
                       const CompensationOptions& options = {}) {
  simulation::ProgramSetup setup;
  setup.dialect = stated;
  const Result<CompensatedText> result = test_support::correct(grinder(), text, options, setup);
  EXPECT_TRUE(result) << result.error().message();
  return result ? *result : CompensatedText{};
}

/// The lines from the one with `F500` (or the first with a C word behind line 3) to the last before `X41`.
std::vector<std::string> turningLines(const std::string& text) {
  std::vector<std::string> lines = linesOf(text);
  while (!lines.empty() && lines.front()[0] != 'C') lines.erase(lines.begin());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].find('C') == std::string::npos && lines[i][0] != 'F') lines.resize(i);
  }
  return lines;
}

std::vector<nc::Motion> motionsOf(const std::string& text, nc::Dialect dialect) {
  nc::MemoryText source("test.nc", text);
  simulation::ProgramSetup setup;
  setup.dialect = dialect;
  nc::Interpreter interpreter(source, simulation::interpreterOptionsOf(grinder().machine(), setup));
  std::vector<nc::Motion> motions;
  for (;;) {
    const Result<const nc::ExecutedBlock*> block = interpreter.next();
    EXPECT_TRUE(block) << block.error().message();
    if (!block || *block == nullptr) return motions;
    for (const nc::Motion& motion : (*block)->motions) motions.push_back(motion);
  }
}

struct Way {
  double linear = 0.0;   // mm
  double degrees = 0.0;  // of C
};
Way wayOf(const nc::Motion& motion) {  // joints of the grinder: Z C X
  return {std::hypot(motion.end[0] - motion.start[0], motion.end[2] - motion.start[2]),
          degFromRad(std::abs(motion.end[1] - motion.start[1]))};
}

Result<Verification> check(const std::string& original, const std::string& corrected, std::size_t motions,
                           std::optional<nc::Dialect> stated) {
  simulation::ProgramSetup setup;
  setup.dialect = stated;
  nc::MemoryText a("a.nc", original);
  nc::MemoryText b("b.nc", corrected);
  PieceLog log;
  for (std::size_t i = 0; i < motions; ++i) log.addWhole();
  NoProgress progress;
  return verifyCorrection(grinder(), setup, a, b, log, progress);
}

TEST(TurningBlocks, GetNoLinearWordsForAControlThatNobodyNamed) {
  for (const std::optional<nc::Dialect> stated :
       {std::optional<nc::Dialect>{}, std::optional(nc::Dialect::Siemens)}) {
    const CompensatedText result = needed(kProgram, stated);
    const std::vector<std::string> lines = turningLines(result.text);
    ASSERT_FALSE(lines.empty());
    for (const std::string& line : lines) EXPECT_EQ(line.find_first_of("XZ"), std::string::npos) << line;
    EXPECT_TRUE(hasWarning(result.report, "compensation.turning"));
  }
}

TEST(TurningBlocks, KeepTheirFeedOnAFanucControl) {
  const CompensatedText result = needed(kProgram, nc::Dialect::Fanuc);
  const std::vector<std::string> lines = turningLines(result.text);
  ASSERT_GT(lines.size(), 2U);
  EXPECT_NE(result.text.find("F500"), std::string::npos);
  bool joined = false;
  for (const std::string& line : lines) {
    joined = joined || line.find_first_of("XZ") != std::string::npos;
    EXPECT_EQ(line.find('F') != std::string::npos, &line == &lines.front()) << line;
  }
  EXPECT_TRUE(joined) << result.text;
  EXPECT_TRUE(hasWarning(result.report, "compensation.turning.kept"));
  // The time by the manual's rule, a degree as a millimetre: 90° at 500 a minute.
  double minutes = 0.0;
  for (const nc::Motion& motion : motionsOf(result.text, nc::Dialect::Fanuc)) {
    const Way way = wayOf(motion);
    if (motion.kind != nc::MotionKind::Linear || way.degrees < 0.5) continue;
    const double word = way.linear > 0.0 ? motion.feed * 60.0 : degFromRad(motion.feed) * 60.0;
    EXPECT_NEAR(word, 500.0, 1e-9);
    minutes += std::hypot(way.linear, way.degrees) / word;
  }
  EXPECT_NEAR(minutes, 90.0 / 500.0, 2e-4);
}

TEST(TurningBlocks, RestateTheirFeedForLinuxCncAndPutItBack) {
  CompensationOptions finely;
  finely.linear_decimals = 5;  // so that every line has a linear word, the last one too
  const CompensatedText result = needed(kProgram, nc::Dialect::LinuxCnc, finely);
  const std::vector<std::string> lines = turningLines(result.text);
  ASSERT_GT(lines.size(), 2U);
  EXPECT_EQ(lines.back(), "F500.") << result.text;
  EXPECT_TRUE(hasWarning(result.report, "compensation.turning.restated"));
  double minutes = 0.0;
  bool joined = false;
  const std::vector<nc::Motion> motions = motionsOf(result.text, nc::Dialect::LinuxCnc);
  for (const nc::Motion& motion : motions) {
    const Way way = wayOf(motion);
    if (motion.kind != nc::MotionKind::Linear || way.degrees < 0.5) continue;
    joined = joined || way.linear > 0.0;
    const double time =
        way.linear > 0.0 ? way.linear / (motion.feed * 60.0) : way.degrees / (degFromRad(motion.feed) * 60.0);
    EXPECT_NEAR(way.degrees / time, 500.0, 0.01) << way.linear;
    minutes += time;
  }
  EXPECT_TRUE(joined);
  EXPECT_NEAR(minutes, 90.0 / 500.0, 2e-4);
  EXPECT_DOUBLE_EQ(motions.back().feed, 500.0 / 60.0);  // X41. has no F of its own
}

TEST(TurningBlocks, LeaveTheFeedInForceThatAnEarlierBlockStated) {
  const std::string text = "G21 G90 G94\nG0 X50. Z10. C0.\nG1 X40. F333.25\nC45.\nC90.\nX41.\n";
  const CompensatedText result = needed(text, nc::Dialect::LinuxCnc);
  EXPECT_NE(result.text.find("\nF333.25\n"), std::string::npos) << result.text;
  for (const nc::Motion& motion : motionsOf(result.text, nc::Dialect::LinuxCnc)) {
    const Way way = wayOf(motion);
    if (motion.kind != nc::MotionKind::Linear || way.linear == 0.0) continue;
    if (way.degrees < 0.5) {
      EXPECT_DOUBLE_EQ(motion.feed * 60.0, 333.25);
    } else {
      EXPECT_NEAR(motion.feed * 60.0 * way.degrees / way.linear, 333.25, 0.01);
    }
  }
}

TEST(TurningBlocks, CountInchesInInchPrograms) {
  const std::string text = "G20 G90 G94\nG0 X2. Z0.4 C0.\nG1 X1.6 F8\nC90. F500\nX1.7\n";
  CompensationOptions options;
  options.linear_decimals = 5;
  static_cast<void>(needed(text, nc::Dialect::Fanuc, options));
  const CompensatedText result = needed(text, nc::Dialect::LinuxCnc, options);
  double degrees = 0.0;
  for (const nc::Motion& motion : motionsOf(result.text, nc::Dialect::LinuxCnc)) {
    const Way way = wayOf(motion);
    if (motion.kind != nc::MotionKind::Linear || way.degrees < 0.5 || way.linear == 0.0) continue;
    EXPECT_NEAR(motion.feed * 60.0 * way.degrees / way.linear, 500.0, 0.01);  // both in mm
    degrees += way.degrees;
  }
  EXPECT_GT(degrees, 45.0);
}

TEST(TurningBlocks, StayAloneWhereTheUserOrTheBlockSaysSo) {
  CompensationOptions alone;
  alone.turning = TurningFeed::Alone;
  const std::string per_turn = "G21 G90 G0 X50. Z10. C0.\nG94 G1 X40. F200\nS100 M3\nG95\nC90. F5\nX41.\n";
  const std::string ends = "G21 G90 G94\nG0 X50. Z10. C0.\nG1 X40. F200\nC90. F500 M30\n";
  const auto expectAlone = [](const CompensatedText& result) {
    for (const std::string& line : turningLines(result.text))
      EXPECT_EQ(line.find_first_of("XZ"), std::string::npos) << line;
    EXPECT_TRUE(hasWarning(result.report, "compensation.turning"));
  };
  expectAlone(needed(kProgram, nc::Dialect::Fanuc, alone));
  expectAlone(needed(kProgram, nc::Dialect::LinuxCnc, alone));
  expectAlone(needed(per_turn, nc::Dialect::Fanuc));
  expectAlone(needed(ends, nc::Dialect::LinuxCnc));
  EXPECT_EQ(needed(ends, nc::Dialect::LinuxCnc).text.find("\nF"), std::string::npos);
}

/// A linear axis that is named where it stands must not be moved back to where it was programmed: that would
/// be a linear path of some micrometres, and F would count it.
TEST(TurningBlocks, KeepANamedAxisWhereItStands) {
  const CompensatedText result =
      needed("G21 G90 G94\nG0 X50. Z10. C0.\nG1 X40. F200\nC90. Z10. X40. F500\nX41.\n", std::nullopt);
  for (const nc::Motion& motion : motionsOf(result.text, nc::Dialect::Fanuc)) {
    const Way way = wayOf(motion);
    if (motion.kind == nc::MotionKind::Linear && way.degrees > 0.5) {
      EXPECT_EQ(way.linear, 0.0) << result.text;
    }
  }
}

TEST(TurningBlocks, InInverseTimeGetLinearWordsButNotForLinuxCnc) {
  const std::string text = "G21 G90 G94\nG0 X50. Z10. C0.\nG1 X40. F200\nG93\nC90. F5\nG94\n";
  const auto moves = [](const CompensatedText& result, nc::Dialect dialect) {
    double linear = 0.0;
    for (const nc::Motion& motion : motionsOf(result.text, dialect)) {
      if (motion.feed_mode == nc::FeedMode::InverseTime) linear += wayOf(motion).linear;
    }
    return linear;
  };
  EXPECT_GT(moves(needed(text, std::nullopt), nc::Dialect::Fanuc), 0.0);
  EXPECT_EQ(moves(needed(text, nc::Dialect::LinuxCnc), nc::Dialect::LinuxCnc), 0.0);
}

/// The check has a rule of its own and refuses what the writer must never write.
TEST(TurningCheck, TimesTheTurnByTheMeaningOfTheControl) {
  const std::string head = "G21 G90 G94\nG0 X50. Z10. C0.\n";
  const std::string original = head + "G1 C90. F500\n";
  const std::string kept = head + "G1 C90. X50.001 F500\n";
  const std::string restated = head + "G1 C90. X50.001 F0.00555556\n";
  const std::string slow = head + "G1 C90. F499\n";
  const std::string displaced = head + "G1 C90. X60. F500\n";
  EXPECT_TRUE(check(original, kept, 2, nc::Dialect::Fanuc));
  EXPECT_FALSE(check(original, kept, 2, nc::Dialect::LinuxCnc));
  EXPECT_FALSE(check(original, kept, 2, std::nullopt));
  EXPECT_TRUE(check(original, restated, 2, nc::Dialect::LinuxCnc));
  EXPECT_FALSE(check(original, restated, 2, nc::Dialect::Fanuc));
  EXPECT_FALSE(check(original, slow, 2, nc::Dialect::Fanuc));
  EXPECT_FALSE(check(original, displaced, 2, nc::Dialect::Fanuc));
  // Behind the block F is the programmed one again, and nothing else will do.
  EXPECT_TRUE(check(original + "X51.\n", restated + "F500\nX51.\n", 3, nc::Dialect::LinuxCnc));
  EXPECT_FALSE(check(original + "X51.\n", restated + "X51.\n", 3, nc::Dialect::LinuxCnc));
  // Other blocks: the F word itself.
  EXPECT_FALSE(check(head + "G1 X51. F100\n", head + "G1 X51.01 F101\n", 2, nc::Dialect::Fanuc));
  EXPECT_TRUE(check(head + "G1 X51. F100\n", head + "G1 X51.01 F100\n", 2, nc::Dialect::Fanuc));
}

}  // namespace
}  // namespace nineline::compensation
