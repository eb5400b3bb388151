// Good programs, spoilt in one place: the check must say what is wrong.
#include "core/thread_grinding/hand_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "core/thread_grinding/thread_generator.h"

namespace nineline::thread_grinding {
namespace {

using testing::HasSubstr;

ThreadParameters twoStarts() {
  ThreadParameters p;
  p.diameter = 48.0;
  p.pitch = 1.5;
  p.length = 15.0;
  p.starts = 2;
  p.infeed = 0.4;
  p.min_last_pass_ratio = 0.5;  // two passes
  p.spark_out_passes = 0;
  p.block_step = 0.0;
  return p;
}

std::string program(const ThreadParameters& p) {
  const Result<ThreadProgram> made = generateThread(p, {});
  EXPECT_TRUE(made);
  return made ? made->text : std::string();
}

/// The text with its n-th (from 0) `before` replaced.
std::string spoilt(std::string text, const std::string& before, const std::string& after, int n = 0) {
  std::size_t at = text.find(before);
  for (int i = 0; i < n && at != std::string::npos; ++i) at = text.find(before, at + 1);
  EXPECT_NE(at, std::string::npos) << before;
  return at == std::string::npos ? text : text.replace(at, before.size(), after);
}

void expectRefused(const ThreadParameters& p, const std::string& text, const std::string& says) {
  const Result<CutThread> cut = checkHand(text, p, derive(p, {}), p.axes);
  ASSERT_FALSE(cut) << says;
  EXPECT_EQ(cut.error().kind, ErrorKind::NoAnswer);
  EXPECT_THAT(cut.error().text, HasSubstr(says));
}

// With one block a pass, right hand, lead 3: start 1 runs C 180 → −1980 over Z 1.5 → −16.5, start 2 from C 0.
TEST(HandCheck, TheUnspoiltProgramPasses) {
  const ThreadParameters p = twoStarts();
  const std::string text = program(p);
  EXPECT_THAT(text, HasSubstr("Z1.500 C180.000\n"));
  EXPECT_THAT(text, HasSubstr("G93 G01 Z-16.500 C-1980.000 F"));
  const Result<CutThread> cut = checkHand(text, p, derive(p, {}), p.axes);
  ASSERT_TRUE(cut) << cut.error().message();
  EXPECT_EQ(cut->starts, 2);
  EXPECT_EQ(cut->runs, 4U);
}

TEST(HandCheck, AReturnToAnotherAngleIsFound) {
  const ThreadParameters p = twoStarts();
  expectRefused(p, spoilt(program(p), "C180.000", "C190.000", 1), "cuts a lead of");
  const std::string shifted = spoilt(program(p), "C180.000", "C190.000", 1);
  expectRefused(p, spoilt(shifted, "C-1980.000", "C-1970.000", 1), "beside its groove");
}

TEST(HandCheck, AStartGroundTwiceIsFound) {
  const ThreadParameters p = twoStarts();
  std::string text = program(p);
  for (int i = 0; i < 2; ++i) {
    text = spoilt(text, " C0.000\n", " C180.000\n");
    text = spoilt(text, "C-2160.000", "C-1980.000");
  }
  expectRefused(p, text, "beside its groove");
}

TEST(HandCheck, AMirroredPassIsFound) {
  const ThreadParameters p = twoStarts();
  expectRefused(p, spoilt(program(p), "C-1980.000", "C2340.000", 1), "cuts a left-hand groove");
}

TEST(HandCheck, AMissingPassIsFound) {
  const ThreadParameters p = twoStarts();
  const std::string text = program(p);
  const std::size_t from = text.find("(PASS 2 OF 2, START 2");
  const std::size_t to = text.find("(END)");
  expectRefused(p, text.substr(0, from) + text.substr(to), "3 cuts were made, asked for 4");
}

TEST(HandCheck, AWrongDepthIsFound) {
  const ThreadParameters p = twoStarts();
  expectRefused(p, spoilt(program(p), "X23.600", "X23.590"), "deep, asked for 0.4");
}

TEST(HandCheck, AShortPassIsFound) {
  const ThreadParameters p = twoStarts();
  // Half the way at the same lead.
  expectRefused(p, spoilt(program(p), "Z-16.500 C-1980.000", "Z-7.500 C-900.000"), "a rapid motion");
  expectRefused(p,
                spoilt(spoilt(program(p), "Z-16.500 C-1980.000", "Z-7.500 C-900.000"), "G00 X25", "G01 X25"),
                "to 0.400000 mm deep");
}

TEST(HandCheck, AReturnWithoutRetractIsFound) {
  const ThreadParameters p = twoStarts();
  expectRefused(p, spoilt(program(p), "G00 X25.000", "G00 X23.900"),
                "a rapid motion passes through the work");
}

TEST(HandCheck, AProgramThatCannotBeReadIsBadInput) {
  const ThreadParameters p = twoStarts();
  const Result<CutThread> cut =
      checkHand(spoilt(program(p), "X23.600", "X2#3.600"), p, derive(p, {}), p.axes);
  ASSERT_FALSE(cut);
}

TEST(HandCheck, AnEmptyProgramIsNoThread) {
  const ThreadParameters p = twoStarts();
  expectRefused(p, "%\nO0001\nM30\n%\n", "0 cuts were made, asked for 4");
}

}  // namespace
}  // namespace nineline::thread_grinding
