#include <fmt/format.h>

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/measurement/evaluation_record.h"

namespace nineline::measurement {

namespace {

/// The unit in which a test's readings are shown: um, or arcsec for angles.
struct Shown {
  const char* unit;
  bool is_angular;
  [[nodiscard]] double of(double value) const { return is_angular ? arcsecFromRad(value) : umFromMm(value); }
  [[nodiscard]] std::string key(const char* letter) const { return fmt::format("{}_{}", letter, unit); }
  [[nodiscard]] Json json(const std::optional<double>& value) const {
    return value ? Json(of(*value)) : Json();
  }
  [[nodiscard]] std::string text(const std::optional<double>& value) const {
    return value ? fmt::format("{:9.2f}", of(*value)) : fmt::format("{:>9}", "-");
  }
};

Shown shownOf(const Evaluation& evaluation) {
  return evaluation.is_angular ? Shown{"arcsec", true} : Shown{"um", false};
}

double shownTarget(const Evaluation& evaluation, double target) {
  return evaluation.is_rotary ? degFromRad(target) : target;
}

void addSide(const Shown& shown, const char* name, const std::optional<ApproachStatistics>& side,
             Json& json) {
  json.set(fmt::format("approaches_{}", name), side ? Json(side->count) : Json());
  json.set(shown.key(fmt::format("mean_{}", name).c_str()), side ? Json(shown.of(side->mean)) : Json());
  json.set(shown.key(fmt::format("s_{}", name).c_str()), side ? shown.json(side->s) : Json());
}

Json positionJson(const Evaluation& evaluation, const Iso2302Position& position) {
  const Shown shown = shownOf(evaluation);
  Json json = Json::object();
  json.set(evaluation.is_rotary ? "target_deg" : "target_mm", shownTarget(evaluation, position.target));
  addSide(shown, "forward", position.forward, json);
  addSide(shown, "backward", position.backward, json);
  json.set(shown.key("mean"), shown.json(position.mean)).set(shown.key("B"), shown.json(position.B));
  json.set(shown.key("R_forward"), shown.json(position.R_forward));
  json.set(shown.key("R_backward"), shown.json(position.R_backward));
  return json.set(shown.key("R"), shown.json(position.R));
}

Json positioningJson(const Evaluation& evaluation) {
  const Iso2302& figures = *evaluation.iso_230_2;
  const Shown shown = shownOf(evaluation);
  Json json = Json::object();
  json.set(shown.key("A"), shown.json(figures.A)).set(shown.key("A_forward"), shown.json(figures.A_forward));
  json.set(shown.key("A_backward"), shown.json(figures.A_backward));
  json.set(shown.key("E"), shown.json(figures.E)).set(shown.key("E_forward"), shown.json(figures.E_forward));
  json.set(shown.key("E_backward"), shown.json(figures.E_backward));
  json.set(shown.key("R"), shown.json(figures.R)).set(shown.key("R_forward"), shown.json(figures.R_forward));
  json.set(shown.key("R_backward"), shown.json(figures.R_backward));
  json.set(shown.key("M"), shown.json(figures.M)).set(shown.key("B"), shown.json(figures.B));
  json.set(shown.key("mean_B"), shown.json(figures.mean_B));
  json.set("approaches", figures.fewest_approaches);
  Json positions = Json::array();
  for (const Iso2302Position& position : figures.positions)
    positions.push(positionJson(evaluation, position));
  return json.set("positions", std::move(positions));
}

Json vdiJson(const Evaluation& evaluation) {
  const Vdi3441& figures = *evaluation.vdi_3441;
  const Shown shown = shownOf(evaluation);
  Json json = Json::object();
  json.set(shown.key("P"), shown.of(figures.P)).set(shown.key("Pa"), shown.of(figures.Pa));
  json.set(shown.key("Ps_mean"), shown.of(figures.Ps_mean))
      .set(shown.key("Ps_max"), shown.of(figures.Ps_max));
  return json.set(shown.key("U_mean"), shown.of(figures.U_mean))
      .set(shown.key("U_max"), shown.of(figures.U_max));
}

Json circleJson(const Iso2304& figures) {
  const auto um = [](const std::optional<double>& value) { return value ? Json(umFromMm(*value)) : Json(); };
  const auto G = [&](const std::optional<CircleFit>& fit) { return fit ? Json(umFromMm(fit->G)) : Json(); };
  Json json = Json::object();
  json.set("G_um", umFromMm(figures.all.G)).set("G_cw_um", G(figures.clockwise));
  json.set("G_ccw_um", G(figures.counterclockwise));
  json.set("F_max_um", umFromMm(figures.F_max)).set("F_min_um", umFromMm(figures.F_min));
  json.set("D_um", umFromMm(figures.D)).set("H_um", um(figures.H));
  json.set("F_max_as_set_um", umFromMm(figures.F_max_as_set));
  json.set("F_min_as_set_um", umFromMm(figures.F_min_as_set));
  json.set("G_minimum_zone_um", umFromMm(figures.all.G_minimum_zone));
  json.set("centre_offset_um",
           Json(Json::Array{umFromMm(figures.all.centre_u), umFromMm(figures.all.centre_v)}));
  return json.set("full_circle", figures.is_full_circle);
}

/// Squareness is an angle, scale mismatch a ratio; all others are lengths.
struct ShareUnit {
  const char* unit;
  double value, sigma;
};
ShareUnit shownShare(const BallbarShare& share) {
  if (share.name == "squareness") return {"arcsec", arcsecFromRad(share.value), arcsecFromRad(share.sigma)};
  if (share.name == "scale mismatch") return {"um/m", 1e6 * share.value, 1e6 * share.sigma};
  return {"um", umFromMm(share.value), umFromMm(share.sigma)};
}

Json ballbarJson(const BallbarShares& shares) {
  Json list = Json::array();
  for (const BallbarShare& share : shares.shares) {
    const ShareUnit shown = shownShare(share);
    Json one = Json::object();
    one.set("error", share.name).set("value", shown.value).set("sigma", shown.sigma).set("unit", shown.unit);
    list.push(one.set("range_um", umFromMm(share.radial)));
  }
  Json json = Json::object();
  json.set("errors", std::move(list)).set("residual_rms_um", umFromMm(shares.residual_rms));
  return json.set("residual_range_um", umFromMm(shares.residual_range));
}

std::string ballbarText(const BallbarShares& shares) {
  std::string text;
  for (const BallbarShare& share : shares.shares) {
    const ShareUnit shown = shownShare(share);
    text += fmt::format("    {:<36}{:9.2f} ± {:.2f} {}, on the circle {:.2f} um\n", share.name, shown.value,
                        2.0 * shown.sigma, shown.unit, umFromMm(share.radial));
  }
  return text + fmt::format("    {:<36}{:9.2f} um rms\n", "unexplained", umFromMm(shares.residual_rms));
}

Json runOutJson(const RunOut& figures) {
  const auto harmonic = [](const TurnHarmonic& one) {
    Json json = Json::object();
    json.set("order", one.order).set("amplitude_um", umFromMm(one.amplitude));
    return json.set("phase_deg", degFromRad(one.phase));
  };
  Json json = Json::object();
  json.set("total_um", umFromMm(figures.total)).set("once_per_turn", harmonic(figures.once_per_turn));
  json.set("without_eccentricity_um", umFromMm(figures.without_eccentricity));
  json.set("turns", figures.turns);
  const bool has_turns = figures.turns >= 2;
  json.set("synchronous_um", has_turns ? Json(umFromMm(figures.synchronous)) : Json());
  json.set("asynchronous_um", has_turns ? Json(umFromMm(figures.asynchronous)) : Json());
  Json harmonics = Json::array();
  for (const TurnHarmonic& one : figures.harmonics) harmonics.push(harmonic(one));
  return json.set("harmonics", std::move(harmonics));
}

void addFigures(const Evaluation& evaluation, Json& json) {
  const auto add = [&](const char* key, bool has, auto make) {
    if (has && json.find(key) == nullptr) json.set(key, make());
  };
  add("iso_230_2", evaluation.iso_230_2.has_value(), [&] { return positioningJson(evaluation); });
  add("vdi_3441", evaluation.vdi_3441.has_value(), [&] { return vdiJson(evaluation); });
  add("iso_230_4", evaluation.iso_230_4.has_value(), [&] { return circleJson(*evaluation.iso_230_4); });
  add("ballbar", evaluation.ballbar.has_value(), [&] { return ballbarJson(*evaluation.ballbar); });
  add("run_out", evaluation.run_out.has_value(), [&] { return runOutJson(*evaluation.run_out); });
}

std::string positioningText(const Evaluation& evaluation) {
  const Iso2302& f = *evaluation.iso_230_2;
  const Shown shown = shownOf(evaluation);
  std::string text = fmt::format("  ISO 230-2, {}     both  forward backward\n", shown.unit);
  const auto line = [&](const char* name, const auto& both, const auto& forward, const auto& backward) {
    text +=
        fmt::format("    {:<14}{}{}{}\n", name, shown.text(both), shown.text(forward), shown.text(backward));
  };
  line("A accuracy", f.A, f.A_forward, f.A_backward);
  line("E systematic", f.E, f.E_forward, f.E_backward);
  line("R repeatab.", f.R, f.R_forward, f.R_backward);
  text += fmt::format("    {:<14}{}\n    {:<14}{}, mean{}\n", "M mean range", shown.text(f.M), "B reversal",
                      shown.text(f.B), shown.text(f.mean_B));
  text += fmt::format("    {:>10}  forward        s backward        s        B        R\n",
                      evaluation.is_rotary ? "target deg" : "target mm");
  for (const Iso2302Position& p : f.positions) {
    const auto mean = [&](const std::optional<ApproachStatistics>& side) {
      return shown.text(side ? std::optional(side->mean) : std::nullopt) +
             shown.text(side ? side->s : std::nullopt);
    };
    text += fmt::format("    {:>10.4g}{}{}{}{}\n", shownTarget(evaluation, p.target), mean(p.forward),
                        mean(p.backward), shown.text(p.B), shown.text(p.R));
  }
  if (!evaluation.vdi_3441) return text;
  const Vdi3441& v = *evaluation.vdi_3441;
  return text +
         fmt::format(
             "  VDI 3441, {}: P {:.2f}, Pa {:.2f}, Ps mean {:.2f} max {:.2f}, U mean {:.2f} max {:.2f}\n",
             shown.unit, shown.of(v.P), shown.of(v.Pa), shown.of(v.Ps_mean), shown.of(v.Ps_max),
             shown.of(v.U_mean), shown.of(v.U_max));
}

std::string circleText(const Iso2304& f) {
  const auto G = [&](const std::optional<CircleFit>& fit) { return fit ? fixed(umFromMm(fit->G), 2) : "-"; };
  return fmt::format(
      "  ISO 230-4, um: G {:.2f} (clockwise {}, counter-clockwise {}; minimum zone {:.2f})\n"
      "    F max {:.2f}, min {:.2f} ({}); D {:.2f}; H {}; centre {:.2f}, {:.2f}\n",
      umFromMm(f.all.G), G(f.clockwise), G(f.counterclockwise), umFromMm(f.all.G_minimum_zone),
      umFromMm(f.F_max), umFromMm(f.F_min),
      f.is_full_circle ? "from the fitted centre" : "from the centre as set up", umFromMm(f.D),
      f.H ? fixed(umFromMm(*f.H), 2) : "-", umFromMm(f.all.centre_u), umFromMm(f.all.centre_v));
}

std::string runOutText(const RunOut& f) {
  std::string text =
      fmt::format("  Run-out, um: total {:.2f}; once per turn ±{:.2f} at {:.1f}°; without it {:.2f}\n",
                  umFromMm(f.total), umFromMm(f.once_per_turn.amplitude), degFromRad(f.once_per_turn.phase),
                  umFromMm(f.without_eccentricity));
  if (f.turns >= 2) {
    text += fmt::format("    {} turns: synchronous {:.2f}, asynchronous {:.2f}\n", f.turns,
                        umFromMm(f.synchronous), umFromMm(f.asynchronous));
  }
  return text;
}

}  // namespace

Json evaluationsToJson(const std::vector<Evaluation>& evaluations) {
  Json record = Json::object();
  Json tests = Json::array();
  for (const Evaluation& evaluation : evaluations) {
    Json test = Json::object(), files = Json::array(), warnings = Json::array();
    for (const std::string& source : evaluation.sources) files.push(source);
    for (const Diagnostic& one : evaluation.warnings.all()) warnings.push(one.text);
    test.set("files", std::move(files)).set("instrument", evaluation.instrument).set("axis", evaluation.axis);
    addFigures(evaluation, test);
    test.set("warnings", std::move(warnings));
    tests.push(std::move(test));
    addFigures(evaluation, record);
  }
  return record.set("tests", std::move(tests));
}

std::string evaluationText(const Evaluation& evaluation) {
  std::string text;
  for (const std::string& source : evaluation.sources) text += (text.empty() ? "" : ", ") + source;
  text += fmt::format(": {} {}\n", evaluation.instrument, evaluation.axis);
  if (evaluation.iso_230_2) text += positioningText(evaluation);
  if (evaluation.iso_230_4) text += circleText(*evaluation.iso_230_4);
  if (evaluation.ballbar) text += ballbarText(*evaluation.ballbar);
  if (evaluation.run_out) text += runOutText(*evaluation.run_out);
  return text;
}

}  // namespace nineline::measurement
