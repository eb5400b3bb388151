#include "core/postprocessing/post_processor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/kinematics/chain.h"
#include "core/postprocessing/branches.h"

namespace nineline::postprocessing {

namespace {

/// Takes the held joints out of the solver and puts their positions into `home`.
Result<void> holdJoints(const std::map<std::string, double>& held, PoseSolver& solver, JointPositions& home) {
  const Machine& machine = solver.machine();
  for (const auto& [name, position] : held) {
    const std::optional<AxisId> axis = parseAxisId(name);
    const int joint = axis ? machine.find(*axis) : -1;
    if (joint < 0)
      return usageError("post.hold",
                        fmt::format("'{}' has no axis {} to hold.", machine.id(), printable(name)));
    home[static_cast<std::size_t>(joint)] = position;
    solver.hold(1U << joint);
  }
  return {};
}

void measure(const Machine& machine, const ClProgram& program, const PathPlan& plan, PostReport& report) {
  double iterations = 0.0;
  for (std::size_t i = 0; i < plan.points.size(); ++i) {
    const kinematics::ToolPose pose = kinematics::forward(machine, plan.points[i].q);
    report.max_residual = std::max(report.max_residual, (pose.tip - program.points[i].tip).norm());
    report.max_axis_residual =
        std::max(report.max_axis_residual, angleBetween(pose.axis, program.points[i].axis));
    if (i > 0) iterations += plan.points[i].iterations;
  }
  if (plan.points.size() > 1)
    report.solver_iterations_mean = iterations / static_cast<double>(plan.points.size() - 1);
}

/// Targets of inserted moves are what the ideal machine does there.
Result<void> correct(const Machine& machine, const ClProgram& program, const AxisCorrection& correction,
                     AxisMoves& moves, PostReport& report) {
  const TipAxisChain chain(machine);
  double most = 0.0;
  for (AxisMove& move : moves.moves) {
    const Result<JointPositions> q = correction(move.q, chain.at(move.q));
    const std::size_t line = program.points[move.point].line;
    if (!q) {
      Error error = q.error();
      error.line = line;
      return error;
    }
    if (const int joint = machine.firstOutsideTravel(*q); joint >= 0)
      return noAnswer(
          "post.travel",
          fmt::format("The correction takes axis {} out of its travel.", machine.joint(joint).axis.text()),
          {}, line);
    for (std::size_t k = 0; k < kMaxAxes; ++k) most = std::max(most, std::abs((*q)[k] - move.q[k]));
    move.q = *q;
  }
  report.max_correction = most;
  return {};
}

void fill(const ClProgram& program, const PathPlan& plan, const AxisMoves& moves, PostReport& report) {
  report.points = program.goto_count;
  report.inserted_points = moves.inserted;
  report.max_chord_error = moves.largest_chord;
  report.branch_switches = plan.switches;
  report.singular_points = plan.singular;
  report.slowed_blocks = moves.slowed;
  report.cutting_time = moves.time;
  report.warnings.append(program.warnings);
  report.warnings.append(plan.warnings);
  if (moves.slowed > 0)
    report.warnings.warning(
        "post.slowed",
        fmt::format("{} blocks are slower than their feed, because an axis reaches its top speed.",
                    moves.slowed));
}

}  // namespace

Result<PostResult> postProcess(const Machine& machine, const ClProgram& program, const PostOptions& options,
                               Progress& progress) {
  if (Result<void> possible = checkControl(machine, options.nc); !possible) return possible.error();
  if (options.correction && options.nc.tip_control)
    return usageError("post.tip-control",
                      "With tip control the words hold the tool tip: axis errors cannot be "
                      "corrected in them. Leave --tcp or --model out.");
  PoseSolver solver(machine, options.solver);
  JointPositions home = homeOf(machine);
  if (Result<void> held = holdJoints(options.held, solver, home); !held) return held.error();
  Result<PathPlan> plan = planPath(solver, program.points, home, options.plan, progress);
  if (!plan) return plan.error();
  calmTurns(solver, program.points, options.plan, *plan);
  MoveOptions move_options = options.moves;
  move_options.tip_control = options.nc.tip_control;
  Result<AxisMoves> moves = makeMoves(solver, program, *plan, move_options);
  if (!moves) return moves.error();
  PostResult result;
  fill(program, *plan, *moves, result.report);
  measure(machine, program, *plan, result.report);
  if (options.correction) {
    Result<void> corrected = correct(machine, program, options.correction, *moves, result.report);
    if (!corrected) return corrected.error();
  }
  Result<NcText> nc = writeNc(machine, program, *moves, options.nc);
  if (!nc) return nc.error();
  result.report.blocks = nc->blocks;
  result.report.warnings.append(nc->warnings);
  result.text = std::move(nc->text);
  result.moves = std::move(*moves);
  return result;
}

}  // namespace nineline::postprocessing
