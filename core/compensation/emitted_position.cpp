#include <cmath>

#include "core/compensation/arc_geometry.h"
#include "core/compensation/program_corrector.h"

namespace nineline::compensation {

using nc::AxisMask;
using nc::AxisValues;
using nc::contains;

void EmittedPosition::moveTo(const nc::WordFrame& frame, const AxisValues& target, AxisMask named,
                             AxisMask writable, const std::array<int, kMaxAxes>& decimals,
                             std::vector<Word>& words) {
  words.clear();
  const int axes = layout_.count;
  const AxisValues wanted = frame.wordsOf(target, axes);
  const AxisValues present = frame.wordsOf(position_, axes);
  AxisValues displacement{};
  for (std::size_t k = 0; k < displacement.size(); ++k) displacement[k] = target[k] - position_[k];
  const AxisValues steps = frame.incrementWordsOf(displacement, axes);
  AxisValues absolute = present;
  AxisValues increments{};
  for (int i = 0; i < axes; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (!contains(static_cast<AxisMask>(named | writable), i)) continue;
    const bool incremental = contains(frame.incremental, i);
    const double value = roundTo(incremental ? steps[k] : wanted[k], decimals[k]);
    const double change = incremental ? value : value - present[k];
    const double half_increment = 0.5 * std::pow(10.0, -decimals[k]);
    if (!contains(named, i) && std::abs(change) < half_increment) continue;
    (incremental ? increments : absolute)[k] = value;
    words.push_back({i, value});
  }
  const AxisValues at = frame.positionOf(absolute, axes);
  const AxisValues by = frame.displacementOf(increments, axes);
  // In a rotated plane a word of one axis moves both.
  AxisMask moved = 0;
  for (const Word& word : words) moved = static_cast<AxisMask>(moved | nc::axisBit(word.axis));
  const bool rotated = frame.rotation_plane[0] >= 0;
  if (rotated && (contains(moved, frame.rotation_plane[0]) || contains(moved, frame.rotation_plane[1]))) {
    moved = static_cast<AxisMask>(moved | nc::axisBit(frame.rotation_plane[0]) |
                                  nc::axisBit(frame.rotation_plane[1]));
  }
  for (int i = 0; i < axes; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (contains(moved, i)) position_[k] = contains(frame.incremental, i) ? position_[k] + by[k] : at[k];
  }
}

void EmittedPosition::jumpTo(const AxisValues& target, AxisMask axes) {
  for (int i = 0; i < layout_.count; ++i) {
    if (contains(axes, i)) position_[static_cast<std::size_t>(i)] = target[static_cast<std::size_t>(i)];
  }
}

}  // namespace nineline::compensation
