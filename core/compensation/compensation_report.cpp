#include <cmath>

#include "core/base/units.h"
#include "core/compensation/compensation.h"

namespace nineline::compensation {

using kinematics::Machine;
using simulation::Figures;

namespace {

/// Below this there is nothing to reduce: a tenth of a nanometre, in mm, or the same over 100 mm, in rad.
constexpr double kNothing = 1e-7;

Json reductionToJson(const CompensationReport& report, const Machine& machine) {
  const auto reduction = [](const Figures& before, const Figures& after) {
    return Json(reductionPercent(before.rms, after.rms));
  };
  Json json = Json::object();
  json.set("norm", reduction(report.before.norm, report.after.norm))
      .set("x", reduction(report.before.x, report.after.x));
  json.set("y", reduction(report.before.y, report.after.y))
      .set("z", reduction(report.before.z, report.after.z));
  for (int j = 0; j < machine.jointCount(); ++j) {
    const auto k = static_cast<std::size_t>(j);
    json.set(machine.joint(j).axis.text(), reduction(report.before.joints[k], report.after.joints[k]));
  }
  return json;
}

}  // namespace

double reductionPercent(double rms_before, double rms_after) {
  if (rms_before < kNothing) return 0.0;
  return 100.0 * (1.0 - rms_after / rms_before);
}

Json reportToJson(const CompensationReport& report, const Machine& machine) {
  Json json = Json::object();
  json.set("blocks", report.blocks).set("corrected", report.corrected).set("inserted", report.inserted);
  Json warnings = Json::array();
  for (const Diagnostic& one : report.diagnostics.all()) {
    Json warning = Json::object();
    warning.set("code", one.code).set("text", one.text).set("line", one.line).set("count", one.count);
    warnings.push(std::move(warning));
  }
  json.set("warnings", std::move(warnings));
  Json corrections = Json::object();
  for (int j = 0; j < machine.jointCount(); ++j) {
    const double value = report.max_correction[static_cast<std::size_t>(j)];
    corrections.set(machine.joint(j).axis.text(), machine.isRotary(j) ? degFromRad(value) : value);
  }
  json.set("max_correction", std::move(corrections));
  json.set("before", summaryToJson(report.before, machine))
      .set("after", summaryToJson(report.after, machine));
  json.set("reduction_pct", reductionToJson(report, machine));
  return json.set("seconds", report.seconds);
}

}  // namespace nineline::compensation
