#include <gmock/gmock.h>

#include <filesystem>
#include <map>

#include "core/base/file.h"
#include "core/base/text.h"
#include "tests/core/nc/canonical_calls.h"

namespace nineline::nc::testing {
namespace {

namespace fs = std::filesystem;

const fs::path kCases = fs::path(NINELINE_SOURCE_DIR) / "../shared/data/nc-linuxcnc/interp-expected";

/// Cases that we refuse, and why. Whatever is refused must be in this list with the words of its reason.
const std::map<std::string, std::string> kRefused = {
    {"abort-hot-comment", "stops itself"},
    {"g71-endless-loop", "G71.1 is not understood"},
    {"g71-endless-loop_2", "G71 is not understood"},
    {"g72-facing", "G72 is not understood"},
    {"iniparam-failassign", "read-only"},
    {"m98m99_03-error-M98-no-P-word", "M98 needs P"},
    {"nested-sub-in-file-error", "is not in this file"},
    {"python-self", "Python code"},
    {"value-returned", "Python code"},
};

/// Cases whose expected path is that of the tool's edge (G41.1 with a radius); ours is the programmed
/// contour.
bool hasCutterRadius(const std::string& name) {
  return name == "crazy-paths" || name == "inverse-time-with-comp";
}

/// LinuxCNC writes the feeds of G84 outside G17 with the axes in another order than it moves the tool to the
/// hole and back: Y Z X in G18, Z X Y in G19. No tap can be meant so; the order is put right before
/// comparing.
void restoreTapAxes(const std::string& name, std::vector<CanonicalMove>& moves) {
  for (CanonicalMove& move : moves) {
    const std::array<double, 6> p = move.end;
    if (!move.locked) continue;
    if (name == "g84_g18_g99") move.end = {p[2], p[0], p[1], p[3], p[4], p[5]};
    if (name == "g84_g19_g99") move.end = {p[1], p[2], p[0], p[3], p[4], p[5]};
  }
}

std::map<int, double> readToolTable(const fs::path& folder) {
  std::map<int, double> lengths;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".tbl") continue;
    const std::string text = upper(readFile(entry.path()).value());
    for (const std::string_view line : split(text, '\n')) {
      const std::size_t tool = line.find('T');
      const std::size_t z = line.find('Z');
      if (tool == std::string_view::npos || z == std::string_view::npos) continue;
      const double length = std::atof(std::string(line.substr(z + 1)).c_str());
      lengths[std::atoi(std::string(line.substr(tool + 1)).c_str())] = length;
    }
  }
  return lengths;
}

TEST(LinuxCncExpected, EveryCaseMovesAsExpectedOrIsRefusedWithItsReason) {
  if (!fs::exists(kCases)) GTEST_SKIP() << "needs the folder shared/data beside the repository";
  int compared = 0;
  for (const fs::directory_entry& folder : fs::directory_iterator(kCases)) {
    const std::string name = folder.path().filename().string();
    for (const fs::directory_entry& file : fs::directory_iterator(folder)) {
      if (file.path().extension() != ".ngc") continue;
      InterpreterOptions options;
      options.dialect = Dialect::LinuxCnc;
      options.tool_lengths = readToolTable(folder.path());
      if (name.starts_with("g76")) {
        for (auto& [number, length] : options.tool_lengths) length *= 25.4;
      }
      const OwnMoves own =
          interpretMoves(file.path().filename().string(), readFile(file.path()).value(), options);
      const auto refused = kRefused.find(name);
      if (refused != kRefused.end()) {
        EXPECT_THAT(own.error, ::testing::HasSubstr(refused->second)) << name;
        continue;
      }
      EXPECT_EQ(own.error, "") << name;
      if (hasCutterRadius(name)) continue;
      const std::string expected = readFile(folder.path() / "expected").value();
      if (expected.find("SET_FEED_REFERENCE") == std::string::npos) continue;  // messages only, no motions
      std::vector<CanonicalMove> moves = readCanonicalCalls(expected);
      restoreTapAxes(name, moves);
      EXPECT_EQ(differenceOf(own.moves, moves), "") << name;
      ++compared;
    }
  }
  EXPECT_GE(compared, 21);
}

}  // namespace
}  // namespace nineline::nc::testing
