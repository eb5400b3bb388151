#include "core/nc/number_style.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>

#include "core/nc/block.h"
#include "core/nc/number.h"
#include "core/nc/text_source.h"
#include "core/nc/tokenizer.h"

namespace nineline::nc {
namespace {

constexpr double kLargestWritten = 1e9;
constexpr std::array<std::uint64_t, kMostDecimals + 1> kPowers{
    1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000, 1000000000};

std::int64_t scaled(double value, int decimals) {
  return std::llround(value * static_cast<double>(kPowers[static_cast<std::size_t>(decimals)]));
}

/// What the words of one kind of axis look like.
struct Seen {
  int most = 0;
  int least = 255;
  bool any = false;
};

}  // namespace

double writtenValue(double value, int decimals) {
  return static_cast<double>(scaled(value, decimals)) /
         detail::kPowersOfTen[static_cast<std::size_t>(decimals)];
}

std::size_t formatNumber(double value, int decimals, const NumberStyle& style,
                         std::span<char, kLongestNumber> out) {
  if (!(std::fabs(value) < kLargestWritten) || decimals < 0 || decimals > kMostDecimals) return 0;
  const std::int64_t whole_value = scaled(value, decimals);
  const bool negative = whole_value < 0;
  const auto digits = static_cast<std::uint64_t>(negative ? -whole_value : whole_value);
  const std::uint64_t power = kPowers[static_cast<std::size_t>(decimals)];
  const std::uint64_t whole = digits / power;
  std::uint64_t fraction = digits % power;
  char* p = out.data();
  if (negative) *p++ = '-';
  p = std::to_chars(p, out.data() + out.size(), whole).ptr;
  int places = decimals;
  if (!style.trailing_zeros) {
    while (places > 0 && fraction % 10 == 0) fraction /= 10, --places;
  }
  if (places > 0 || style.keep_point) *p++ = '.';
  for (int i = places; i-- > 0; fraction /= 10) p[i] = static_cast<char>('0' + fraction % 10);
  return static_cast<std::size_t>(p + places - out.data());
}

Result<NumberStyle> learnNumberStyle(TextSource& source, Dialect dialect, const AxisLayout& axes,
                                     std::uint64_t most_bytes) {
  Seen linear, rotary;
  bool whole_with_point = false;
  bool any_point = false;
  NumberStyle style;
  Block block;
  const std::uint64_t end = std::min(source.size(), most_bytes);
  for (std::uint64_t offset = 0; offset < end;) {
    const Result<TextSource::Line> line = source.lineAt(offset);
    if (!line) return line.error();
    offset = line->next;
    block.text = line->text;
    ++block.line;
    if (!readPlainWords(block, dialect)) continue;
    for (const Word& word : block.words) {
      style.inch =
          style.inch || (word.letter == 'G' && word.value == (dialect == Dialect::Siemens ? 70.0 : 20.0));
      const int axis = axes.find({word.letter, word.digit});
      if (axis < 0) continue;
      Seen& seen = axes.axes[static_cast<std::size_t>(axis)].rotary ? rotary : linear;
      seen.any = true;
      seen.most = std::max(seen.most, static_cast<int>(word.decimals));
      seen.least = std::min(seen.least, static_cast<int>(word.decimals));
      any_point = any_point || word.decimal_point;
      whole_with_point = whole_with_point || (word.decimal_point && word.decimals == 0);
    }
  }
  const auto decimalsOf = [](const Seen& seen, int otherwise) {
    return seen.any && seen.most > 0 ? std::min(seen.most, kMostDecimals) : otherwise;
  };
  style.linear_decimals = decimalsOf(linear, style.linear_decimals);
  style.rotary_decimals = decimalsOf(rotary, style.linear_decimals);
  style.keep_point = whole_with_point || (dialect == Dialect::Fanuc && any_point) ||
                     (dialect == Dialect::Fanuc && !linear.any);
  const bool all_full = linear.any && linear.least == linear.most && linear.most > 0;
  style.trailing_zeros = all_full && (!rotary.any || rotary.least == rotary.most);
  return style;
}

}  // namespace nineline::nc
