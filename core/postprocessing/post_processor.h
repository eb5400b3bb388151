#pragma once

#include <functional>
#include <map>

#include "core/base/json.h"
#include "core/postprocessing/nc_output.h"

namespace nineline::postprocessing {

/// Axis positions of the actual machine for a pose, given the ideal ones.
using AxisCorrection =
    std::function<Result<JointPositions>(const JointPositions& ideal, const TipAxis& target)>;

struct PostOptions {
  NcOptions nc;
  PlanOptions plan;
  MoveOptions moves;
  SolverOptions solver;
  std::map<std::string, double> held;  ///< joints that stand still, by name: mm, rad
  AxisCorrection correction;           ///< empty: the ideal machine
};

struct PostReport {
  std::size_t points = 0;  ///< GOTO statements
  std::size_t blocks = 0;  ///< that move
  std::size_t inserted_points = 0;
  double solver_iterations_mean = 0.0;
  double max_residual = 0.0;             ///< mm, by the forward kinematics of the machine
  double max_axis_residual = 0.0;        ///< rad
  double max_chord_error = 0.0;          ///< mm
  std::optional<double> max_correction;  ///< mm or rad of a joint, where errors were corrected
  std::size_t branch_switches = 0;
  std::size_t singular_points = 0;
  std::size_t slowed_blocks = 0;
  double cutting_time = 0.0;  ///< s
  Diagnostics warnings;
};

struct PostResult {
  std::string text;  ///< the NC program
  AxisMoves moves;
  PostReport report;
};

/// CL data → NC program for one machine (theory.md, 4).
[[nodiscard]] Result<PostResult> postProcess(const Machine& machine, const ClProgram& program,
                                             const PostOptions& options, Progress& progress);

/// The result record of the contract.
[[nodiscard]] Json postReportJson(const PostReport& report);
/// One row for each motion: `line_1,goto_1,rapid_1` and the joints, `<letter>_mm` or `<letter>_deg`.
[[nodiscard]] std::string axesCsv(const Machine& machine, const ClProgram& program, const AxisMoves& moves);

}  // namespace nineline::postprocessing
