#pragma once

#include "core/smoothing/tool_path.h"

namespace nineline::smoothing {

/// The rotary axes of a machine as further coordinates of a curve, and the way from a curve's point back to
/// axis values: rotary axes as they are, linear axes by exact inverse kinematics, so that the tip follows the
/// curve for any angles (theory.md, 5.5).
class AxisMotion {
 public:
  /// Fails with BadInput where the machine's linear axes do not determine the tip of this section: fewer than
  /// three beside rotary ones that move, or more than three without X, Y and Z.
  [[nodiscard]] static Result<AxisMotion> make(const Machine& machine, const PathSection& section);

  /// The section's points as rows: tip and rotary axes that move.
  [[nodiscard]] PointRows rowsOf(const PathSection& section) const;
  /// Axis values of a point of the curve, started from values near it. Fails with NoAnswer when the linear
  /// axes cannot hold the tip to 1 nm, or outside the travel.
  [[nodiscard]] Result<nc::AxisValues> valuesAt(const CurvePoint& point, const nc::AxisValues& near) const;
  /// Tip in W of axis values.
  [[nodiscard]] Vector3d tipAt(const nc::AxisValues& values) const;

  /// An upper bound, mm/1, of the tip's second derivative when all axes run in step from `a` to `b`, by the
  /// fraction of the way: |p''| <= (sum of turns)² r + 2 (sum of turns) (sum of slides), r the largest lever
  /// on the way. Zero with tool-centre-point control, where the tip runs straight.
  [[nodiscard]] double boundBend(const nc::AxisValues& a, const nc::AxisValues& b) const;

  /// Axes whose words a new block of this section needs.
  [[nodiscard]] nc::AxisMask words() const { return words_; }
  [[nodiscard]] bool hasRotary() const { return !rotary_.empty(); }
  /// Axis of the curve's coordinate 3 + k.
  [[nodiscard]] const std::vector<int>& rotary() const { return rotary_; }

 private:
  explicit AxisMotion(const Machine& machine) : machine_(&machine) {}
  const Machine* machine_;
  bool tool_centre_point_ = false;
  std::vector<int> rotary_;  // that move
  unsigned free_ = 0;        // linear joints that follow
  nc::AxisMask words_ = 0;
};

}  // namespace nineline::smoothing
