#include "core/discovery/report.h"

#include <fmt/format.h>

namespace nineline::discovery {

namespace {

Json parametersJson(const FoundEffect& found) {
  Json parameters = Json::object();
  for (const errors::Parameter& parameter : found.parameters) {
    Json entry = Json::object();
    entry.set("value", parameter.value);
    if (parameter.sigma) entry.set("sigma", *parameter.sigma);
    entry.set("unit", parameter.unit);
    parameters.set(parameter.name, std::move(entry));
  }
  if (!found.covariates.empty()) {
    Json covariates = Json::array();
    for (const std::string& name : found.covariates) covariates.push(name);
    parameters.set("covariates", std::move(covariates));
  }
  return parameters;
}

Json effectJson(const FoundEffect& found) {
  Json json = Json::object();
  json.set("effect", found.effect).set("joint", found.joint).set("component", found.component);
  if (!found.sensor.empty()) json.set("sensor", found.sensor);
  json.set("confidence", found.confidence);
  json.set("parameters", parametersJson(found));
  json.set("share_pct", found.share_pct);
  json.set("evidence", found.evidence);
  json.set("rms_sigma", found.rms_in_sigma);
  if (found.is_measurement) json.set("kind", "measurement");
  if (!found.detail_of.empty()) json.set("detail_of", found.detail_of);
  Json lookalikes = Json::array();
  for (const LookAlikeFound& like : found.lookalikes) {
    Json entry = Json::object();
    entry.set("effect", like.effect).set("joint", like.joint).set("component", like.component);
    entry.set("why", like.why).set("probability", like.probability).set("likeness", like.likeness);
    lookalikes.push(std::move(entry));
  }
  json.set("lookalikes", std::move(lookalikes));
  return json;
}

Json gapJson(const Gap& gap) {
  Json json = Json::object();
  json.set("significant", gap.significant).set("p_value", gap.p_value);
  json.set("rms_before_um", gap.rms_before).set("rms_after_um", gap.rms_after);
  json.set("noise_floor_um", gap.noise_floor);
  json.set("holdout_before_um", gap.holdout_before).set("holdout_after_um", gap.holdout_after);
  json.set("closed_pct", gap.closed_pct ? Json(*gap.closed_pct) : Json());
  Json runs = Json::array();
  for (const double run : gap.holdout_runs) runs.push(run);
  return json.set("holdout_runs", std::move(runs));
}

Json placeJson(const Place& place) {
  Json json = Json::object();
  json.set("text", place.text).set("direction", place.direction);
  Json conditions = Json::array();
  for (const Condition& condition : place.conditions) {
    Json entry = Json::object();
    entry.set("variable", condition.variable).set("min", condition.low).set("max", condition.high);
    conditions.push(std::move(entry));
  }
  json.set("conditions", std::move(conditions));
  return json.set("share_pct", place.share_pct);
}

Json faultJson(const DataFault& fault) {
  Json rows = Json::array();
  rows.push(fault.first_row).push(fault.last_row);
  Json json = Json::object();
  return json.set("text", fault.text).set("file", fault.file).set("rows", std::move(rows));
}

Json noiseJson(const NoiseFinding& noise) {
  Json json = Json::object();
  json.set("instrument", noise.instrument).set("level", noise.level).set("correlated", noise.correlated);
  return json.set("length", noise.length).set("run_offset", noise.offset);
}

template <typename Items, typename Write>
Json listJson(const Items& items, const Write& write) {
  Json list = Json::array();
  for (const auto& item : items) list.push(write(item));
  return list;
}

Json suspectedJson(const NotAccepted& one) {
  Json json = Json::object();
  json.set("effect", one.effect).set("joint", one.joint).set("why", one.why);
  return json.set("evidence", one.evidence);
}

}  // namespace

std::string_view nameOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::None:
      return "none";
    case Verdict::Explained:
      return "explained";
    case Verdict::Partly:
      return "partly";
    case Verdict::Unknown:
      return "unknown";
  }
  return "none";
}

Json reportToJson(const DiscoveryReport& report, const std::string& model_file) {
  Json json = Json::object();
  json.set("verdict", nameOf(report.verdict));
  json.set("gap", gapJson(report.gap));
  json.set("where", listJson(report.where, placeJson));
  json.set("effects", listJson(report.effects, effectJson));
  json.set("suspected", listJson(report.suspected, suspectedJson));
  json.set("data_quality", listJson(report.data_quality, faultJson));
  json.set("noise", listJson(report.noise, noiseJson));
  Json moved = Json::array();
  for (const std::string& name : report.moved_parameters) moved.push(name);
  json.set("re_estimated", std::move(moved));
  json.set("samples", report.samples).set("outliers", report.outliers);
  json.set("next_experiment", report.next_experiment);
  return json.set("model", model_file);
}

std::string reportText(const DiscoveryReport& report) {
  std::string text = fmt::format("Verdict: {}. Gap {:.3g} um RMS before, {:.3g} after, noise {:.3g}.\n",
                                 nameOf(report.verdict), report.gap.rms_before, report.gap.rms_after,
                                 report.gap.noise_floor);
  if (report.gap.closed_pct) {
    text += fmt::format(
        "On runs that were held out: {:.3g} um before, {:.3g} after; {:.0f} % of the gap closed.\n",
        report.gap.holdout_before, report.gap.holdout_after, *report.gap.closed_pct);
  }
  for (const FoundEffect& found : report.effects) {
    text += fmt::format("{} at {} ({}), confidence {:.2f}:", found.effect, found.joint, found.component,
                        found.confidence);
    for (const errors::Parameter& parameter : found.parameters) {
      text += fmt::format(" {} = {:.4g}", parameter.name, parameter.value);
      if (parameter.sigma) text += fmt::format(" ± {:.2g}", *parameter.sigma);
      text += " " + parameter.unit;
    }
    text += "\n";
    for (const LookAlikeFound& like : found.lookalikes) {
      text += fmt::format("  may also be {} at {}: {}\n", like.effect, like.joint, like.why);
    }
  }
  for (const Place& place : report.where) text += "Where: " + place.text + "\n";
  for (const DataFault& fault : report.data_quality) {
    text +=
        fmt::format("Data: {} rows {} to {}: {}\n", fault.file, fault.first_row, fault.last_row, fault.text);
  }
  if (!report.next_experiment.empty()) text += "Next: " + report.next_experiment + "\n";
  return text;
}

}  // namespace nineline::discovery
