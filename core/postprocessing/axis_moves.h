#pragma once

#include "core/postprocessing/path_plan.h"

namespace nineline::postprocessing {

/// One straight motion of the axes, to a point of the path or to one that was inserted on the way to it.
struct AxisMove {
  JointPositions q{};     ///< its end
  std::size_t point = 0;  ///< of the path, to which it leads
  bool inserted = false;  ///< ends on the way to the point
  bool rapid = false;
  bool starts_known = true;  ///< false where the place before the motion is not known
  double length = 0.0;       ///< mm of the tip along the workpiece
  double time = 0.0;         ///< s; 0 in a rapid or where the start is not known
  double feed = 0.0;         ///< mm/s wanted at the tip; 0 in a rapid
};

struct MoveOptions {
  bool tip_control = false;        ///< the control keeps the tip on the line: only the tool axis is checked
  double chord_tolerance = 0.005;  ///< mm: how far the tip may leave the line between two points
  double axis_deviation = 0.0017;  ///< rad: how far the tool axis may leave the way between two points
  std::size_t most_moves = 50'000'000;
};

struct AxisMoves {
  std::vector<AxisMove> moves;
  std::size_t inserted = 0;
  std::size_t slowed = 0;      ///< moves that an axis' top speed makes slower than the feed
  double largest_chord = 0.0;  ///< mm: what remains
  double time = 0.0;           ///< s, rapids left out
};

/// The motions along a plan. Where the straight line of the axes would take the tip or the tool axis off the
/// way between two points of a cut by more than the tolerances (looked at in seven places), the point in the
/// middle is solved and inserted, again and again (theory.md, 4.8). Times follow from feed and length, or
/// from the slowest axis. `events` state the spindle speed that a feed per turn needs.
[[nodiscard]] Result<AxisMoves> makeMoves(const PoseSolver& solver, const ClProgram& program,
                                          const PathPlan& plan, const MoveOptions& options);

}  // namespace nineline::postprocessing
