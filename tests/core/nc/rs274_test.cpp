#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

#include "core/base/units.h"
#include "tests/core/nc/canonical_calls.h"

namespace nineline::nc::testing {
namespace {

namespace fs = std::filesystem;

constexpr int kPrograms = 60;
constexpr int kSteps = 60;

/// Two things are left out because LinuxCNC 2.9 then loses the present position: a change of units while a
/// tool offset acts, and a change of the rotation while G92 acts. Writes programs that LinuxCNC accepts: arcs
/// are stated by increments, so that they fit wherever the tool stands.
class ProgramMaker {
 public:
  explicit ProgramMaker(unsigned seed) : random_(seed), rotates_(seed % 2 == 1) {}

  std::string make() {
    text_ = "G21 G90 G17 G94 G40 G49 G54 F600\n";
    for (int i = 0; i < kSteps; ++i) step();
    return text_ + "G80\nM2\n";
  }

 private:
  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  void step() {
    switch (whole(0, 11)) {
      case 0:
      case 1:
      case 2:
        line();
        break;
      case 3:
      case 4:
        arc();
        break;
      case 5:
        radiusArc();
        break;
      case 6:
        text_ += whole(0, 1) ? "G49\nG20\n" : "G49\nG21\n";
        break;
      case 7:
        text_ += whole(0, 2) ? "G90\n" : "G91\n";
        break;
      case 8:
        offset();
        break;
      case 9:
        cycle();
        break;
      case 10:
        plane_ = rotates_ ? 17 : 17 + whole(0, 2);
        text_ += fmt::format("G{}\n", plane_);
        break;
      default:
        machine();
        break;
    }
  }

  void line() {
    text_ += whole(0, 1) ? "G1" : "G0";
    for (const char axis : {'X', 'Y', 'Z', 'A', 'C'}) {
      if (whole(0, 1)) text_ += fmt::format(" {}{:.4f}", axis, number(-50, 50));
    }
    text_ += whole(0, 3) ? " X1.5\n" : " B3.25\n";
    if (text_.find(" X", text_.rfind("G")) != text_.rfind(" X1.5\n") && text_.ends_with(" X1.5\n")) {
      text_.replace(text_.size() - 6, 6, "\n");
    }
  }

  void arc() {
    const double r = number(1, 20);
    const double begin = number(0, kTurn);
    const double sweep = number(0.3, 6.0);
    const bool ccw = whole(0, 1);
    const double end = ccw ? begin + sweep : begin - sweep;
    const char* const axes = plane_ == 17 ? "XYZIJ" : plane_ == 18 ? "ZXYKI" : "YZXJK";
    text_ +=
        fmt::format("G91 G{} {}{:.6f} {}{:.6f}", ccw ? 3 : 2, axes[0], r * (std::cos(end) - std::cos(begin)),
                    axes[1], r * (std::sin(end) - std::sin(begin)));
    if (whole(0, 1)) text_ += fmt::format(" {}{:.4f}", axes[2], number(-5, 5));
    if (whole(0, 3) == 0) text_ += fmt::format(" C{:.4f}", number(-90, 90));
    text_ += fmt::format(" {}{:.6f} {}{:.6f}", axes[3], -r * std::cos(begin), axes[4], -r * std::sin(begin));
    if (whole(0, 3) == 0) text_ += fmt::format(" P{}", whole(1, 4));
    text_ += "\nG90\n";
  }

  void radiusArc() {
    const double u = number(1, 10);
    const double v = number(-10, 10);
    const double r = std::hypot(u, v) * number(0.51, 2.0);
    const char* const axes = plane_ == 17 ? "XY" : plane_ == 18 ? "ZX" : "YZ";
    text_ += fmt::format("G91 G{} {}{:.4f} {}{:.4f} R{:.4f}\nG90\n", whole(2, 3), axes[0], u, axes[1], v,
                         whole(0, 1) ? r : -r);
  }

  void offset() {
    switch (whole(0, 7)) {
      case 0:
        text_ += fmt::format("G92 X{:.3f} Z{:.3f}\n", number(-5, 5), number(-5, 5));
        break;
      case 1:
        text_ += fmt::format("G92.{}\n", whole(1, 3));
        break;
      case 2:
        text_ += fmt::format("G52 X{:.3f} Y{:.3f}\n", number(-5, 5), number(-5, 5));
        break;
      case 3:
        text_ += fmt::format("G10 L2 P{} X{:.3f} Y{:.3f} Z{:.3f}\n", whole(1, 9), number(-9, 9),
                             number(-9, 9), number(-9, 9));
        break;
      case 4:
        text_ += fmt::format("G92.1\nG10 L2 P{} R{:.1f}\n", whole(1, 3), rotates_ ? number(-90, 90) : 0.0);
        break;
      case 5:
        text_ += fmt::format("G10 L20 P{} X{:.3f} Y{:.3f} A{:.3f}\n", whole(1, 6), number(-9, 9),
                             number(-9, 9), number(-9, 9));
        break;
      case 6:
        text_ += fmt::format("G{}\n", whole(54, 59));
        break;
      default:
        text_ += whole(0, 1) ? fmt::format("G43.1 Z{:.3f}\n", number(-9, 9)) : "G49\n";
        break;
    }
  }

  void cycle() {
    static constexpr int kCycles[] = {81, 82, 83, 73, 85, 89};
    const int code = kCycles[whole(0, 5)];
    const char* const axes = plane_ == 17 ? "XYZ" : plane_ == 18 ? "ZXY" : "YZX";
    const double bottom = number(-20, 10);
    text_ += fmt::format("G90 G9{} G{} {}{:.3f} {}{:.3f} {}{:.3f} R{:.3f}", whole(8, 9), code, axes[0],
                         number(-9, 9), axes[1], number(-9, 9), axes[2], bottom, bottom + number(1, 9));
    if (code == 82 || code == 89) text_ += " P0.1";
    if (code == 83 || code == 73) text_ += " Q1.25";
    text_ += fmt::format("\n{}{:.3f}\n", axes[0], number(-9, 9));
    text_ += whole(0, 1) ? "G80\n" : fmt::format("G0 {}{:.3f}\n", axes[1], number(-9, 9));
    if (text_.ends_with("G80\n")) text_ += "G1\n";
  }

  void machine() {
    if (whole(0, 1)) {
      text_ += fmt::format("G90 G53 G{} X{:.3f} Z{:.3f}\n", whole(0, 1), number(-9, 9), number(-9, 9));
    } else {
      text_ += fmt::format("G28 Z{:.3f}\n", number(-9, 9));
    }
  }

  std::mt19937 random_;
  std::string text_;
  bool rotates_;  ///< LinuxCNC refuses arcs outside G17 while its frame is turned
  int plane_ = 17;
};

std::string runRs274(const fs::path& folder, const std::string& program) {
  const fs::path file = folder / "program.ngc";
  std::ofstream(file) << program;
  const std::string command =
      fmt::format("cd '{}' && rm -f rs274ngc.var && HOME='{}' rs274 -g program.ngc 2>&1", folder.string(),
                  folder.string());
  std::string output;
  std::FILE* const pipe = ::popen(command.c_str(), "r");
  if (!pipe) return output;
  std::array<char, 4096> buffer;
  for (std::size_t got = 0; (got = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    output.append(buffer.data(), got);
  ::pclose(pipe);
  return output;
}

TEST(Rs274, MovesOurProgramsAsWeDo) {
  if (std::system("command -v rs274 >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "needs rs274 (package linuxcnc-uspace)";
  const fs::path folder = fs::temp_directory_path() /
                          fmt::format("nineline-rs274-{}", ::testing::UnitTest::GetInstance()->random_seed());
  fs::create_directories(folder);
  std::size_t moves = 0;
  int accepted = 0;
  for (unsigned seed = 1; seed <= kPrograms; ++seed) {
    const std::string program = ProgramMaker(seed).make();
    const std::string output = runRs274(folder, program);
    if (output.find("PROGRAM_END") == std::string::npos)
      continue;  // not all that is generated is allowed there
    ++accepted;
    InterpreterOptions options;
    options.dialect = Dialect::LinuxCnc;
    const OwnMoves own = interpretMoves("program.ngc", program, options);
    EXPECT_EQ(own.error, "") << "seed " << seed << "\n" << program;
    const std::string difference = differenceOf(own.moves, readCanonicalCalls(output));
    EXPECT_EQ(difference, "") << "seed " << seed;
    if (!difference.empty()) std::ofstream(folder / fmt::format("seed{}.ngc", seed)) << program;
    moves += own.moves.size();
  }
  EXPECT_GE(accepted, 30);
  EXPECT_GT(moves, 2000U);
  if (!HasFailure()) fs::remove_all(folder);
}

}  // namespace
}  // namespace nineline::nc::testing
