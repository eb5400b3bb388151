#include "core/nc/number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "core/nc/number_style.h"

namespace nineline::nc {
namespace {

struct Read {
  bool ok;
  Decimal number;
  std::size_t used;
};

Read read(const std::string& text) {
  Decimal number;
  const char* const end = readDecimal(text.data(), text.data() + text.size(), number);
  return {end != nullptr, number, end ? static_cast<std::size_t>(end - text.data()) : 0};
}

TEST(Number, ReadsWhatProgramsWrite) {
  EXPECT_EQ(read("10").number.value, 10.0);
  EXPECT_EQ(read("-.5").number.value, -0.5);
  EXPECT_EQ(read("+1.").number.value, 1.0);
  EXPECT_EQ(read("0012.3400").number.value, 12.34);
  EXPECT_EQ(read("12.3400").number.decimals, 4);
  EXPECT_TRUE(read("1.").number.point);
  EXPECT_FALSE(read("1").number.point);
  EXPECT_EQ(read("1.5Y2").used, 3U);
}

TEST(Number, RefusesWhatIsNone) {
  for (const char* const text : {"", "-", ".", "+.", "X", "-X1"}) EXPECT_FALSE(read(text).ok) << text;
}

TEST(Number, IsTheDoubleNearestToTheDecimal) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 20'000; ++i) {
    const int decimals = static_cast<int>(random() % 10);
    const auto digits = static_cast<long long>(random() % 1'000'000'000'000ULL);
    std::string text = std::to_string(digits);
    if (decimals > 0 && text.size() > static_cast<std::size_t>(decimals))
      text.insert(text.size() - static_cast<std::size_t>(decimals), ".");
    EXPECT_EQ(read(text).number.value, std::stod(text)) << text;
  }
  EXPECT_EQ(read("123456789.123456789123").number.value, std::stod("123456789.123456789123"));
}

TEST(NumberStyle, WritesWithoutNoise) {
  const NumberStyle plain{3, 3, false, false};
  const NumberStyle point{3, 3, true, false};
  const NumberStyle full{3, 3, true, true};
  std::array<char, kLongestNumber> out;
  const auto text = [&](double value, int decimals, const NumberStyle& style) {
    return std::string(out.data(), formatNumber(value, decimals, style, out));
  };
  EXPECT_EQ(text(10.0, 3, plain), "10");
  EXPECT_EQ(text(10.0, 3, point), "10.");
  EXPECT_EQ(text(10.0, 3, full), "10.000");
  EXPECT_EQ(text(-0.0004, 3, plain), "0");
  EXPECT_EQ(text(-0.0004, 3, point), "0.");
  EXPECT_EQ(text(-0.0006, 3, plain), "-0.001");
  EXPECT_EQ(text(12.3456, 3, plain), "12.346");
  EXPECT_EQ(text(0.05, 3, plain), "0.05");
  EXPECT_EQ(text(-123.4, 6, plain), "-123.4");
  EXPECT_EQ(text(std::numeric_limits<double>::quiet_NaN(), 3, plain), "");
  EXPECT_EQ(text(std::numeric_limits<double>::infinity(), 3, plain), "");
  EXPECT_EQ(text(1e10, 3, plain), "");
}

TEST(NumberStyle, WhatIsReadBackIsBitEqual) {
  std::mt19937_64 random(11);
  std::array<char, kLongestNumber> out;
  for (int i = 0; i < 50'000; ++i) {
    const int decimals = static_cast<int>(random() % 7);
    const double value = (static_cast<double>(random() % 2'000'000'000ULL) - 1e9) * 1e-6;
    const std::size_t size = formatNumber(value, decimals, NumberStyle{}, out);
    ASSERT_GT(size, 0U);
    EXPECT_EQ(read(std::string(out.data(), size)).number.value, writtenValue(value, decimals));
    EXPECT_LE(std::fabs(writtenValue(value, decimals) - value), 0.5000001 * std::pow(10.0, -decimals));
  }
}

}  // namespace
}  // namespace nineline::nc
