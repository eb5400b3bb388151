// The straight output, interpreted by LinuxCNC.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/base/units.h"
#include "tests/core/smoothing/sample_programs.h"

namespace nineline::smoothing {
namespace {

namespace fs = std::filesystem;

std::string interpretedByLinuxCnc(const std::string& program) {
  const fs::path folder = fs::path(::testing::TempDir()) / "nineline-smooth-rs274";
  fs::create_directories(folder);
  std::ofstream(folder / "program.ngc") << program;
  const std::string command =
      fmt::format("cd '{0}' && rm -f rs274ngc.var && HOME='{0}' rs274 -g program.ngc 2>&1", folder.string());
  std::string text;
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return text;
  std::array<char, 4096> part;
  while (const std::size_t size = std::fread(part.data(), 1, part.size(), pipe))
    text.append(part.data(), size);
  pclose(pipe);
  fs::remove_all(folder);
  return text;
}

TEST(SmoothingRs274, LinuxCncDrivesTheSamePath) {
  if (std::system("command -v rs274 >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "needs rs274 (package linuxcnc-uspace)";
  const Machine& machine = testing::machineNamed("trunnion-ac");
  NoProgress progress;
  std::string program = testing::impellerProgram(120, 6);
  program.erase(program.find("O1000"), program.find("G90") - program.find("O1000"));
  const Result<SmoothedText> smoothed =
      smoothText(machine, "in.nc", program, testing::impellerSetup(), SmoothingOptions{}, progress);
  ASSERT_TRUE(smoothed) << smoothed.error().message();
  ASSERT_EQ(smoothed->report.segments, 1U);
  const std::string calls = interpretedByLinuxCnc(smoothed->text);
  const testing::ReadPath own = testing::readBack(machine, smoothed->text, testing::impellerSetup());
  std::size_t move = 1;
  for (std::size_t at = calls.find("STRAIGHT_FEED("); at != std::string::npos;
       at = calls.find("STRAIGHT_FEED(", at + 1), ++move) {
    double x, y, z, a, b, c;
    ASSERT_EQ(
        std::sscanf(calls.c_str() + at, "STRAIGHT_FEED(%lf, %lf, %lf, %lf, %lf, %lf", &x, &y, &z, &a, &b, &c),
        6);
    ASSERT_LT(move, own.values.size());
    nc::AxisValues q{};
    const auto set = [&](char letter, double value) {
      q[static_cast<std::size_t>(machine.find({letter, 0}))] = value;
    };
    set('X', x), set('Y', y), set('Z', z + 85.0), set('A', radFromDeg(a)), set('C', radFromDeg(c));
    EXPECT_LT((tipOf(machine, q, false) - own.tips[move]).norm(), 0.001)
        << move;  // rs274 prints four decimals
  }
  EXPECT_EQ(move, own.values.size());
}

}  // namespace
}  // namespace nineline::smoothing
