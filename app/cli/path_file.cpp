#include "app/cli/path_file.h"

namespace nineline::cli {

namespace {

constexpr std::size_t kPiece = 1U << 20;  // bytes

Json warningsToJson(const Diagnostics& diagnostics) {
  Json warnings = Json::array();
  for (const Diagnostic& one : diagnostics.all()) {
    Json warning = Json::object();
    warning.set("code", one.code).set("text", one.text).set("line", one.line).set("count", one.count);
    warnings.push(std::move(warning));
  }
  return warnings;
}

}  // namespace

Result<simulation::SimulationReport> simulateToFile(const simulation::ErrorModel& model,
                                                    nc::TextSource& program,
                                                    const simulation::ProgramSetup& setup, AtomicFile& file,
                                                    Progress& progress) {
  std::string rows = simulation::pathCsvHeader(model.machine());
  Result<void> written;
  const auto pass = [&](std::size_t least) {
    if (rows.size() < least) return true;
    written = file.write(rows);
    rows.clear();
    return written.has_value();
  };
  const auto take = [&](const simulation::PathSample& sample) {
    simulation::appendPathCsvRow(model.machine(), sample, rows);
    return pass(kPiece) && !progress.isCancelled();
  };
  Result<simulation::SimulationReport> report =
      simulation::simulateProgram(model, program, setup, take, progress);
  if (!report) return report;
  if (!written) return written.error();
  if (progress.isCancelled()) return cancelled();
  if (!pass(0)) return written.error();
  if (const Result<void> flushed = file.flush(); !flushed) return flushed.error();
  return report;
}

Json simulationToJson(const simulation::SimulationReport& report, const kinematics::Machine& machine) {
  Json json = Json::object();
  json.set("blocks", report.blocks).set("motions", report.motions).set("samples", report.samples);
  json.set("path_length_mm", report.path_length).set("time_s", report.time);
  json.set("deviation", simulation::summaryToJson(report.deviation, machine));
  return json.set("warnings", warningsToJson(report.diagnostics));
}

}  // namespace nineline::cli
