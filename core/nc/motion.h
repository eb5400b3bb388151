#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "core/base/axis_id.h"

namespace nineline::nc {

/// One value for each axis of an AxisLayout, in its order: mm for linear axes, rad for rotary ones.
using AxisValues = std::array<double, kMaxAxes>;

/// A set of axes of a layout, one bit each.
using AxisMask = std::uint16_t;
constexpr AxisMask axisBit(int axis) { return static_cast<AxisMask>(1U << static_cast<unsigned>(axis)); }
constexpr bool contains(AxisMask mask, int axis) { return (mask & axisBit(axis)) != 0; }

/// The axes that a control has, as its program words name them. Made from a machine by the layers above.
struct AxisLayout {
  struct Axis {
    AxisId id;
    bool rotary = false;    ///< words in degrees, never scaled by inch or diameter
    bool diameter = false;  ///< words are diameters: twice the axis position
  };
  int count = 0;
  std::array<Axis, kMaxAxes> axes{};

  /// Index of an axis, −1 where the machine has none of that name.
  [[nodiscard]] int find(AxisId id) const {
    for (int i = 0; i < count; ++i) {
      if (axes[static_cast<std::size_t>(i)].id == id) return i;
    }
    return -1;
  }
};

enum class MotionKind : std::uint8_t {
  Rapid,   ///< G00: every axis from start to end, taken as in step
  Linear,  ///< G01, G33 and the like: axes in step
  Arc      ///< G02, G03: circle in a plane, the other axes in step with the angle (helix)
};

/// Why a motion exists: decides what may be rewritten.
enum class MotionRole : std::uint8_t {
  Block,   ///< the block's own axis words state the end point
  Thread,  ///< like Block, feed coupled to the spindle (G32, G33, G34)
  Cycle,   ///< one of the motions into which a canned cycle (G73…G89, G76, G92 threading, CYCLE…) expands
  Machine  ///< end fixed in machine coordinates (G53, G28, G30): never corrected
};

enum class FeedMode : std::uint8_t { PerMinute, InverseTime, PerRevolution };

/// One motion of a program in machine coordinates, that is, as the control's position display shows its axes:
/// work offsets, rotation and tool length applied. Values in mm, rad, mm/s.
struct Motion {
  MotionKind kind = MotionKind::Linear;
  MotionRole role = MotionRole::Block;
  FeedMode feed_mode = FeedMode::PerMinute;
  bool tool_centre_point =
      false;  ///< G43.4, G43.5, TRAORI: linear words are the tool tip in the workpiece frame
  std::int8_t cutter_compensation =
      0;                   ///< G41: −1 (left), G42: +1; the path is the programmed contour all the same
  AxisMask commanded = 0;  ///< axes named in the block
  AxisMask established =
      0;                 ///< axes whose position the program has stated absolutely up to and with this block
  std::size_t line = 0;  ///< of the file, from 1
  AxisValues start{};
  AxisValues end{};
  /// Feed as programmed: mm/s (rad/s when only rotary axes move), 1/s for InverseTime, mm per turn for
  /// PerRevolution; 0 for Rapid or where no feed was stated.
  double feed = 0.0;
  double feed_unit = 1.0;      ///< mm for one unit of the F word where it counts lengths: 1, 25.4
  double spindle_speed = 0.0;  ///< rad/s as programmed, 0 when unknown
  /// Arc only: indices of the first and second axis of the plane (G17 X Y, G18 Z X, G19 Y Z), centre in
  /// machine coordinates, and signed angle from the first towards the second axis (G03 positive), more than a
  /// turn possible.
  std::array<std::int8_t, 2> plane{0, 1};
  std::array<double, 2> centre{};
  double sweep = 0.0;
};

/// Axis positions of a motion at `fraction` 0…1 of it (of the angle, on an arc).
[[nodiscard]] AxisValues positionAt(const Motion& motion, int axes, double fraction);

/// How the axis words of one block become machine coordinates.
/// For axis i: position_i = Σ rotation(word_i · factor_i) + shift_i, with a rotation (G68) in one plane at
/// most.
struct WordFrame {
  AxisMask incremental = 0;  ///< axes whose words are increments in this block
  AxisValues factor{};       ///< mm or rad for one unit of a word: 1, 25.4, ½ (diameter), π/180
  AxisValues shift{};        ///< work offset, G92, G52, tool length: mm, rad
  std::array<std::int8_t, 2> rotation_plane{-1, -1};  ///< −1: no rotation
  double cosine = 1.0;
  double sine = 0.0;

  /// Absolute words of a machine position.
  [[nodiscard]] AxisValues wordsOf(const AxisValues& position, int axes) const;
  /// Words of a displacement in machine coordinates.
  [[nodiscard]] AxisValues incrementWordsOf(const AxisValues& displacement, int axes) const;
  /// The machine position of absolute words.
  [[nodiscard]] AxisValues positionOf(const AxisValues& words, int axes) const;
  /// The machine displacement of increment words.
  [[nodiscard]] AxisValues displacementOf(const AxisValues& words, int axes) const;
};

}  // namespace nineline::nc
