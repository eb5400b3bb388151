#pragma once

#include <optional>
#include <string>

#include "core/nc/number_style.h"
#include "core/smoothing/tool_path.h"

namespace nineline::smoothing {

/// Writes axis values of one section as words, in the units and with the offsets of its blocks.
class WordWriter {
 public:
  WordWriter(const nc::AxisLayout& axes, const nc::WordFrame& frame, const nc::NumberStyle& style,
             nc::AxisMask mask)
      : axes_(&axes), frame_(&frame), style_(&style), mask_(mask) {}

  /// The values that a control reads from the words of `values`; axes without words stay.
  [[nodiscard]] nc::AxisValues rounded(const nc::AxisValues& values) const;
  /// Words of values, unrounded.
  [[nodiscard]] nc::AxisValues wordsOf(const nc::AxisValues& values) const;
  /// The axes that get words, in the order in which programs name them: X Y Z U V W A B C.
  [[nodiscard]] std::vector<int> wordOrder() const;
  /// " X1.5 Y2." of values.
  void appendWords(std::string& out, const nc::AxisValues& values) const;
  void appendNumber(std::string& out, double value, int decimals) const;
  [[nodiscard]] int decimalsOf(int axis) const;
  [[nodiscard]] nc::AxisMask mask() const { return mask_; }
  [[nodiscard]] const nc::AxisLayout& axes() const { return *axes_; }
  [[nodiscard]] const nc::WordFrame& frame() const { return *frame_; }

 private:
  const nc::AxisLayout* axes_;
  const nc::WordFrame* frame_;
  const nc::NumberStyle* style_;
  nc::AxisMask mask_;
};

}  // namespace nineline::smoothing
