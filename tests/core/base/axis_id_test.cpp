#include "core/base/axis_id.h"

#include <gtest/gtest.h>

namespace nineline {
namespace {

TEST(AxisId, ReadsTheNineLettersInBothCases) {
  for (const char letter : std::string("XYZUVWABC")) {
    EXPECT_EQ(parseAxisId(std::string(1, letter)), (AxisId{letter, 0}));
    const auto lower = static_cast<char>(letter + ('a' - 'A'));
    EXPECT_EQ(parseAxisId(std::string(1, lower)), (AxisId{letter, 0}));
  }
}

TEST(AxisId, TextReadsBack) {
  for (const char* text : {"X", "C2", "Z9", "B1"}) {
    const std::optional<AxisId> axis = parseAxisId(text);
    ASSERT_TRUE(axis) << text;
    EXPECT_EQ(axis->text(), text);
  }
  EXPECT_EQ(parseAxisId("c2")->text(), "C2");
}

TEST(AxisId, RefusesAllElse) {
  for (const char* text : {"", " ", "D", "x0", "X10", "XY", "2", "X ", "X-", "µ"}) {
    EXPECT_FALSE(parseAxisId(text)) << "'" << text << "'";
  }
  EXPECT_FALSE(parseAxisId(std::string_view("\0", 1)));
}

TEST(AxisId, LettersAreUpperCase) {
  EXPECT_TRUE(isAxisLetter('W'));
  EXPECT_FALSE(isAxisLetter('w'));
  EXPECT_FALSE(isAxisLetter('\0'));
  EXPECT_FALSE(isAxisLetter('F'));
}

TEST(AxisId, DigitTellsAxesApart) {
  EXPECT_NE(*parseAxisId("C"), *parseAxisId("C1"));
  EXPECT_NE(*parseAxisId("C1"), *parseAxisId("C2"));
}

}  // namespace
}  // namespace nineline
