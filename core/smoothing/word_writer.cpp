#include "core/smoothing/word_writer.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/base/contract.h"

namespace nineline::smoothing {

nc::AxisValues WordWriter::wordsOf(const nc::AxisValues& values) const {
  return frame_->wordsOf(values, axes_->count);
}

int WordWriter::decimalsOf(int axis) const {
  return axes_->axes[static_cast<std::size_t>(axis)].rotary ? style_->rotary_decimals
                                                            : style_->linear_decimals;
}

nc::AxisValues WordWriter::rounded(const nc::AxisValues& values) const {
  nc::AxisValues words = wordsOf(values);
  for (int i = 0; i < axes_->count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (nc::contains(mask_, i)) words[k] = nc::writtenValue(words[k], decimalsOf(i));
  }
  nc::AxisValues back = frame_->positionOf(words, axes_->count);
  for (int i = 0; i < axes_->count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (!nc::contains(mask_, i)) back[k] = values[k];
  }
  return back;
}

void WordWriter::appendNumber(std::string& out, double value, int decimals) const {
  std::array<char, nc::kLongestNumber> number;
  const std::size_t size = nc::formatNumber(value, decimals, *style_, number);
  NL_EXPECTS(size != 0, value);
  out.append(number.data(), size);
}

std::vector<int> WordWriter::wordOrder() const {
  static constexpr std::string_view kOrder = "XYZUVWABC";
  const auto rank = [this](int i) {
    const AxisId& axis = axes_->axes[static_cast<std::size_t>(i)].id;
    return std::pair(kOrder.find(axis.letter), axis.digit);
  };
  std::vector<int> order;
  for (int i = 0; i < axes_->count; ++i) {
    if (nc::contains(mask_, i)) order.push_back(i);
  }
  std::sort(order.begin(), order.end(), [&](int a, int b) { return rank(a) < rank(b); });
  return order;
}

void WordWriter::appendWords(std::string& out, const nc::AxisValues& values) const {
  const nc::AxisValues words = wordsOf(values);
  for (const int i : wordOrder()) {
    const AxisId& axis = axes_->axes[static_cast<std::size_t>(i)].id;
    out += ' ';
    out += axis.text();
    if (axis.digit != 0) out += '=';
    appendNumber(out, words[static_cast<std::size_t>(i)], decimalsOf(i));
  }
}

}  // namespace nineline::smoothing
