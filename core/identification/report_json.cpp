#include <fmt/format.h>

#include "core/base/units.h"
#include "core/identification/identification.h"

namespace nineline::identification {

namespace {

Json texts(const std::vector<std::string>& values) {
  Json list = Json::array();
  for (const std::string& value : values) list.push(value);
  return list;
}

Json unobservableToJson(const std::vector<Unobservable>& all) {
  Json list = Json::array();
  for (const Unobservable& one : all) {
    Json entry = Json::object();
    entry.set("component", one.name)
        .set("parts", texts(one.parts))
        .set("partners", texts(one.partners))
        .set("text", one.text());
    list.push(std::move(entry));
  }
  return list;
}

Json noiseToJson(const std::vector<NoiseFound>& all) {
  Json list = Json::array();
  for (const NoiseFound& one : all) {
    const auto shown = [&one](double value) { return one.angular ? arcsecFromRad(value) : umFromMm(value); };
    const std::string unit = one.angular ? "arcsec" : "um";
    Json entry = Json::object();
    entry.set("instrument", one.instrument)
        .set("readings", one.readings)
        .set("within_run_" + unit, shown(one.within_run))
        .set("run_offset_" + unit, shown(one.run_offset));
    list.push(std::move(entry));
  }
  return list;
}

Json outliersToJson(const std::vector<OutlierReading>& all, std::span<const Measurement> measurements) {
  Json list = Json::array();
  for (const OutlierReading& one : all) {
    Json entry = Json::object();
    entry.set("file", measurements[one.file].source)
        .set("line", one.line)
        .set("column", one.column)
        .set("sigmas", one.sigmas);
    list.push(std::move(entry));
  }
  return list;
}

Json proposalsToJson(const std::vector<ProposedMeasurement>& all) {
  Json list = Json::array();
  for (const ProposedMeasurement& one : all) {
    Json entry = Json::object();
    entry.set("text", one.text).set("gain_1", one.gain).set("would_tell", texts(one.would_tell));
    list.push(std::move(entry));
  }
  return list;
}

Json coverageToJson(const IdentificationReport& report) {
  Json list = Json::array();
  const Machine& machine = report.model->machine();
  for (const TableCoverage& one : report.coverage) {
    const std::optional<errors::Component> component = errors::parseComponent(one.name);
    const bool rotary = component && machine.isRotary(machine.find(component->axis));
    const auto shown = [rotary](double value) { return rotary ? degFromRad(value) : value; };
    Json entry = Json::object();
    entry.set("component", one.name)
        .set(rotary ? "low_deg" : "low_mm", shown(one.low))
        .set(rotary ? "high_deg" : "high_mm", shown(one.high))
        .set("values", one.values);
    list.push(std::move(entry));
  }
  return list;
}

}  // namespace

Json reportToJson(const IdentificationReport& report, std::span<const Measurement> measurements) {
  NL_EXPECTS(report.model.has_value());
  Json effects = Json::array();
  for (const errors::EffectPtr& effect : report.model->effects()) {
    effects.push(effect->toJson(report.model->machine()));
  }
  Json json = Json::object();
  json.set("effects", std::move(effects))
      .set("condition_number", report.condition_number)
      .set("residual_rms_um", umFromMm(report.residual_rms))
      .set("repeatability_um", report.repeatability ? Json(umFromMm(*report.repeatability)) : Json());
  if (report.angular_residual_rms) {
    json.set("residual_rms_arcsec", arcsecFromRad(*report.angular_residual_rms));
  }
  if (report.angular_repeatability) {
    json.set("repeatability_arcsec", arcsecFromRad(*report.angular_repeatability));
  }
  Json warnings = Json::array();
  for (const Diagnostic& warning : report.warnings.all()) warnings.push(warning.text);
  return json.set("readings", report.readings)
      .set("parameters", report.parameters)
      .set("noise", noiseToJson(report.noise))
      .set("unobservable", unobservableToJson(report.unobservable))
      .set("outliers", outliersToJson(report.outliers, measurements))
      .set("coverage", coverageToJson(report))
      .set("next_measurements", proposalsToJson(report.proposals))
      .set("warnings", std::move(warnings));
}

}  // namespace nineline::identification
