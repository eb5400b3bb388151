#pragma once

#include <functional>
#include <vector>

#include "core/base/diagnostics.h"
#include "core/base/progress.h"
#include "core/postprocessing/cl_data.h"
#include "core/postprocessing/pose_solver.h"

namespace nineline::postprocessing {

struct PlanOptions {
  double singular_openness = 0.02;  ///< below it a pose counts as near singular: PoseSolver::opennessAt
  double axis_tolerance = 0.0;   ///< rad: how far the tool axis may leave the wanted one in a singular turn
  double most_turn = 0.1;        ///< rad of a rotary joint between two near-singular points
  std::size_t most_states = 24;  ///< alternatives of a point, whole turns included
};

/// Where the machine stands at one point of the path.
struct PlannedPoint {
  JointPositions q{};
  int iterations = 0;
  double openness = 1.0;
  bool switched = false;  ///< another branch, or other whole turns, than at the point before
  bool turned = false;    ///< the tool axis was let off within its tolerance
};

struct PathPlan {
  std::vector<PlannedPoint> points;  ///< one for each point of the path
  std::size_t switches = 0;
  std::size_t singular = 0;
  Diagnostics warnings;
};

/// Chooses among all branches the one that serves the whole path: inside the travel, no other branch within a
/// cut, the least motion, rapids included (dynamic programming over the alternatives of each point,
/// theory.md, 4.5). Joints without end and those without travel run on past whole turns. Fails with NoAnswer,
/// naming the line, where no branch passes.
[[nodiscard]] Result<PathPlan> planPath(const PoseSolver& solver, const std::vector<ClPoint>& points,
                                        const JointPositions& home, const PlanOptions& options,
                                        Progress& progress);

/// Near singular poses, spreads the turns of rotary joints that are wilder than `most_turn` over the points
/// around them, as far as the tool axis stays within its tolerance; warns of what remains. The tip stays.
void calmTurns(const PoseSolver& solver, const std::vector<ClPoint>& points, const PlanOptions& options,
               PathPlan& plan);

}  // namespace nineline::postprocessing
