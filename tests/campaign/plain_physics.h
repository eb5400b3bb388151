#pragma once

#include <array>

#include "tests/campaign/campaign_machine.h"

namespace nineline::campaign {

using Positions = std::array<double, 9>;

/// Tip and tool axis relative to the workpiece: mm, unit vector.
struct PlainPose {
  Vector3d tip = Vector3d::Zero();
  Vector3d axis = Vector3d::UnitZ();
};

/// The physics of a machine a second time, in the plainest way: 4×4 matrices one after the other, splines
/// through a dense linear solve. Shares no code with core/.
class PlainPhysics {
 public:
  explicit PlainPhysics(const PlainMachine& machine);

  [[nodiscard]] PlainPose ideal(const Positions& q) const { return pose(q, nullptr); }
  /// `play`: where each joint stands in its dead band, mm or rad.
  [[nodiscard]] PlainPose actual(const Positions& q, const Positions& play) const { return pose(q, &play); }
  [[nodiscard]] std::size_t jointCount() const { return machine_.joints.size(); }
  [[nodiscard]] const PlainMachine& machine() const { return machine_; }
  [[nodiscard]] double playWidth(std::size_t joint) const { return width_[joint]; }

  /// What remains of the deviation from `ideal` when the joints stand as well as they can near q: the tip,
  /// and with `lever` above 0 (mm) the tool axis too.
  [[nodiscard]] PlainPose best(const Positions& q, const Positions& play, const PlainPose& ideal,
                               double lever) const;

 private:
  [[nodiscard]] PlainPose pose(const Positions& q, const Positions* play) const;
  [[nodiscard]] double valueOf(const PlainTable& table, const std::vector<double>& curvature, double q) const;
  PlainMachine machine_;
  std::vector<std::vector<double>> curvatures_;  // second derivatives at the grid, for each table
  Positions width_{};
};

/// Dead bands along a path: what the control commands, and where each joint hangs behind.
class PlainPlay {
 public:
  explicit PlainPlay(const PlainPhysics& physics) : physics_(physics) {}
  /// The joints go straight from one command to the next.
  void move(const Positions& from, const Positions& to);
  [[nodiscard]] const Positions& offsets() const { return offsets_; }

 private:
  const PlainPhysics& physics_;
  Positions offsets_{};
  std::array<bool, 9> moved_{};
};

}  // namespace nineline::campaign
