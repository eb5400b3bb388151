#include "core/base/text.h"
#include "core/base/units.h"
#include "core/postprocessing/post_processor.h"

namespace nineline::postprocessing {

Json postReportJson(const PostReport& report) {
  Json json = Json::object();
  json.set("points", report.points)
      .set("blocks", report.blocks)
      .set("inserted_points", report.inserted_points);
  json.set("solver_iterations_mean", report.solver_iterations_mean);
  json.set("max_residual_mm", report.max_residual);
  json.set("max_residual_deg", degFromRad(report.max_axis_residual));
  json.set("max_chord_error_um", umFromMm(report.max_chord_error));
  json.set("branch_switches", report.branch_switches).set("singular_points", report.singular_points);
  json.set("slowed_blocks", report.slowed_blocks).set("cutting_time_s", report.cutting_time);
  if (report.max_correction) json.set("max_correction_mm_or_rad", *report.max_correction);
  Json warnings = Json::array();
  for (const Diagnostic& one : report.warnings.all()) {
    Json warning = Json::object();
    warning.set("code", one.code).set("text", one.text).set("line", one.line).set("count", one.count);
    warnings.push(std::move(warning));
  }
  return json.set("warnings", std::move(warnings));
}

std::string axesCsv(const Machine& machine, const ClProgram& program, const AxisMoves& moves) {
  std::string text = "line_1,goto_1,rapid_1";
  for (int j = 0; j < machine.jointCount(); ++j)
    text += "," + machine.joint(j).axis.text() + (machine.isRotary(j) ? "_deg" : "_mm");
  text += "\n";
  for (const AxisMove& move : moves.moves) {
    const ClPoint& point = program.points[move.point];
    const bool is_goto = !move.inserted && point.kind == ClPoint::Kind::Goto;
    text += std::to_string(point.line) + (is_goto ? ",1" : ",0") + (move.rapid ? ",1" : ",0");
    for (int j = 0; j < machine.jointCount(); ++j) {
      const double q = move.q[static_cast<std::size_t>(j)];
      text += "," + shortest(machine.isRotary(j) ? degFromRad(q) : q);
    }
    text += "\n";
  }
  return text;
}

}  // namespace nineline::postprocessing
