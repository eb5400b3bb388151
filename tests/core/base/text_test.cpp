#include "core/base/text.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <random>

namespace nineline {
namespace {

TEST(ParseNumber, ReadsDecimalNumbers) {
  EXPECT_EQ(parseNumber("0"), 0.0);
  EXPECT_EQ(parseNumber("-1.5"), -1.5);
  EXPECT_EQ(parseNumber("+1.5"), 1.5);
  EXPECT_EQ(parseNumber(".5"), 0.5);
  EXPECT_EQ(parseNumber("-.5"), -0.5);
  EXPECT_EQ(parseNumber("3."), 3.0);
  EXPECT_EQ(parseNumber("1e-3"), 1e-3);
  EXPECT_EQ(parseNumber("007"), 7.0);
}

TEST(ParseNumber, RefusesAllElse) {
  for (const char* text :
       {"",      " ",  "+",   "-",   ".",   "+-1",  "--1",      "++1",  "1 ",    " 1", "1x", "1,5",
        "1.2.3", "e5", "nan", "NaN", "inf", "-inf", "infinity", "0x10", "1e999", "1e", "1e+"}) {
    EXPECT_FALSE(parseNumber(text)) << "'" << text << "'";
  }
  EXPECT_FALSE(parseNumber(std::string_view("1\0", 2)));
}

TEST(ParseInteger, ReadsWholeNumbersOnly) {
  EXPECT_EQ(parseInteger("42"), 42);
  EXPECT_EQ(parseInteger("+42"), 42);
  EXPECT_EQ(parseInteger("-42"), -42);
  EXPECT_EQ(parseInteger("9223372036854775807"), std::numeric_limits<long long>::max());
  for (const char* text : {"", "4.0", "4e1", "9223372036854775808", "+-4", "0x4", "4 "}) {
    EXPECT_FALSE(parseInteger(text)) << "'" << text << "'";
  }
}

TEST(Trimmed, TakesBlanksFromBothEnds) {
  EXPECT_EQ(trimmed(" \t a b\r\n"), "a b");
  EXPECT_EQ(trimmed("a"), "a");
  EXPECT_EQ(trimmed(" \r\n"), "");
  EXPECT_EQ(trimmed(""), "");
}

TEST(Split, KeepsEmptyParts) {
  using Parts = std::vector<std::string_view>;
  EXPECT_EQ(split("a,b,,c", ','), (Parts{"a", "b", "", "c"}));
  EXPECT_EQ(split("", ','), (Parts{""}));
  EXPECT_EQ(split(",", ','), (Parts{"", ""}));
}

TEST(Upper, ChangesAsciiOnly) {
  EXPECT_EQ(upper("g01 x1a"), "G01 X1A");
  EXPECT_EQ(upper("µm"), "µM");
}

TEST(Shortest, ReadsBackToTheSameBits) {
  std::mt19937_64 random(20260101);
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t bits = random();
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value)) continue;
    ASSERT_EQ(parseNumber(shortest(value)), value) << shortest(value);
  }
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(-25.0), "-25");
}

TEST(Fixed, WritesSoManyDecimals) {
  EXPECT_EQ(fixed(1.5, 3), "1.500");
  EXPECT_EQ(fixed(-1.2345, 3), "-1.234");
  EXPECT_EQ(fixed(2.6, 0), "3");
}

TEST(Fixed, KnowsNoNegativeZeroAndNoNonsense) {
  EXPECT_EQ(fixed(-0.0004, 3), "0.000");
  EXPECT_EQ(fixed(-0.0, 0), "0");
  EXPECT_EQ(fixed(-0.0006, 3), "-0.001");
  EXPECT_EQ(fixed(std::numeric_limits<double>::quiet_NaN(), 3), "");
  EXPECT_EQ(fixed(std::numeric_limits<double>::infinity(), 3), "");
}

TEST(Printable, EscapesControlsAndStrayBytes) {
  EXPECT_EQ(printable("abc"), "abc");
  EXPECT_EQ(printable(std::string_view("a\0b\x7f", 4)), "a\\x00b\\x7f");
  EXPECT_EQ(printable("µ"), "µ");
  EXPECT_EQ(printable("\xb5m"), "\\xb5m");
}

TEST(Printable, ShortensAndStaysUtf8) {
  EXPECT_EQ(printable("abcdef", 3), "abc…");
  for (std::size_t most = 1; most < 8; ++most) EXPECT_TRUE(isUtf8(printable("aµbµcµd", most))) << most;
}

TEST(IsUtf8, KnowsTheFormsOfABrokenText) {
  EXPECT_TRUE(isUtf8(""));
  EXPECT_TRUE(isUtf8("grün 线 🙂"));
  EXPECT_FALSE(isUtf8("\xff"));
  EXPECT_FALSE(isUtf8("\x80")) << "a continuation without its lead";
  EXPECT_FALSE(isUtf8("\xc3")) << "cut off";
  EXPECT_FALSE(isUtf8("\xc3(")) << "no continuation";
  EXPECT_FALSE(isUtf8("\xc0\xaf")) << "longer than needed";
  EXPECT_FALSE(isUtf8("\xe0\x80\xaf")) << "longer than needed";
  EXPECT_FALSE(isUtf8("\xed\xa0\x80")) << "half of a surrogate pair";
  EXPECT_FALSE(isUtf8("\xf4\x90\x80\x80")) << "beyond Unicode";
  EXPECT_FALSE(isUtf8("\xf5\x80\x80\x80"));
}

}  // namespace
}  // namespace nineline
