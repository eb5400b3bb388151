#include "core/errors/table_effects.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"

namespace nineline::errors {

namespace {

constexpr double kLargestTranslation = 1.0;  // mm; larger is a mistake of the unit (theory.md, 3.5)
constexpr double kLargestRotation = 0.01;    // rad
constexpr double kLargestSetting = 10.0;     // mm; the place of an axis is set less finely than it moves

double& rowOf(SmallMotion& motion, int row) {
  return row < 3 ? motion.translation[row] : motion.rotation[row - 3];
}

const char* valuesKey(bool angular) { return angular ? "values_arcsec" : "values_um"; }
double fromShown(bool angular, double value) { return angular ? radFromArcsec(value) : mmFromUm(value); }
double toShown(bool angular, double value) { return angular ? arcsecFromRad(value) : umFromMm(value); }

void checkSize(JsonReader& reader, std::string_view key, const Component& component, double value,
               double largest_translation = kLargestTranslation) {
  const double limit = component.isAngular() ? kLargestRotation : largest_translation;
  if (std::abs(value) < limit || reader.failed()) return;
  reader.fail(
      key, "model.size",
      component.isAngular()
          ? fmt::format(
                "{:.6g} arcsec is larger than any machine's error (limit {:.0f}); is the unit arcsec?",
                arcsecFromRad(value), arcsecFromRad(limit))
          : fmt::format("{:.6g} um is larger than any machine's error (limit {:.0f}); is the unit um?",
                        umFromMm(value), umFromMm(limit)));
}

Interpolation readInterpolation(JsonReader& reader) {
  const std::string text = reader.stringOr("interpolation", "cubic");
  if (text != "cubic" && text != "linear") {
    reader.fail("interpolation", "model.interpolation",
                fmt::format("'interpolation' is '{}', expected 'cubic' or 'linear'.", text));
  }
  return text == "linear" ? Interpolation::Linear : Interpolation::Cubic;
}

/// Makes a table of a continuous joint that covers one turn periodic. A table that repeats its first value at
/// the end of the turn loses that value.
void closeTurn(JsonReader& reader, std::string_view key, ErrorTable::Grid& grid,
               std::vector<double>& values) {
  const auto covers = [&](std::size_t count) {
    return std::abs(static_cast<double>(count) * grid.spacing - kTurn) < 1e-6 * kTurn;
  };
  if (covers(values.size())) {
    grid.period = kTurn;
  } else if (values.size() > 1 && covers(values.size() - 1)) {
    if (std::abs(values.back() - values.front()) > 1e-9) {
      reader.fail(
          key, "model.closure",
          "the values at the start and at the end of the turn differ; a continuous axis needs equal ones.");
    }
    values.pop_back();
    grid.period = kTurn;
  }
}

/// One uncertainty for each of the `given` values; `kept` of them remain where a turn was closed.
std::vector<double> readSigmas(JsonReader& reader, std::string_view key, bool angular, std::size_t given,
                               std::size_t kept) {
  std::vector<double> sigmas = reader.numbers(key, given);
  for (double& sigma : sigmas) {
    if (sigma < 0.0) {
      reader.fail(key, "model.sigma", fmt::format("'{}' holds {}, expected 0 or more.", key, sigma));
    }
    sigma = fromShown(angular, sigma);
  }
  sigmas.resize(kept);
  return sigmas;
}

}  // namespace

TableEffect::TableEffect(int joint, Component component, ErrorTable table, bool fixed_frame)
    : Effect(joint, component, fixed_frame ? Slot::Standing : Slot::Moved), table_(std::move(table)) {}

void TableEffect::addMotion(const MachineState& state, std::span<const double>, SmallMotion& sum) const {
  rowOf(sum, component().row) += table_.value(state.q[static_cast<std::size_t>(joint())]);
}

void TableEffect::addSlope(const MachineState& state, SmallMotion& sum) const {
  rowOf(sum, component().row) += table_.slope(state.q[static_cast<std::size_t>(joint())]);
}

bool TableEffect::covers(const MachineState& state) const {
  return table_.covers(state.q[static_cast<std::size_t>(joint())]);
}

Json TableEffect::toJson(const kinematics::Machine& machine) const {
  const bool rotary = machine.isRotary(joint());
  const bool angular = component().isAngular();
  Json json = Json::object();
  json.set("effect", id()).set("joint", component().axis.text()).set("component", component().text());
  const auto position = [rotary](double value) { return rotary ? degFromRad(value) : value; };
  json.set(rotary ? "start_deg" : "start_mm", position(table_.grid().start));
  json.set(rotary ? "spacing_deg" : "spacing_mm", position(table_.grid().spacing));
  Json values = Json::array();
  for (const double value : table_.values()) values.push(toShown(angular, value));
  json.set(valuesKey(angular), std::move(values));
  if (!sigmas_.empty()) {
    Json sigmas = Json::array();
    for (const double sigma : sigmas_) sigmas.push(toShown(angular, sigma));
    json.set(angular ? "sigmas_arcsec" : "sigmas_um", std::move(sigmas));
  }
  json.set("interpolation", table_.grid().interpolation == Interpolation::Linear ? "linear" : "cubic");
  if (slot() == Slot::Standing) json.set("frame", "fixed");
  if (!reference_.isZero(0.0)) {
    json.set("reference_mm",
             Json(Json::Array{Json(reference_.x()), Json(reference_.y()), Json(reference_.z())}));
  }
  return json;
}

Result<std::shared_ptr<Effect>> TableEffect::fromJson(JsonReader& reader, const kinematics::Machine& machine,
                                                      int joint, Component component) {
  const bool rotary = machine.isRotary(joint);
  const auto position = [rotary](double value) { return rotary ? radFromDeg(value) : value; };
  const char* key = valuesKey(component.isAngular());
  ErrorTable::Grid grid;
  grid.start = position(reader.number(rotary ? "start_deg" : "start_mm"));
  grid.spacing = position(reader.number(rotary ? "spacing_deg" : "spacing_mm"));
  grid.interpolation = readInterpolation(reader);
  std::vector<double> values = reader.numbers(key);
  const std::size_t given = values.size();
  for (double& value : values) {
    value = fromShown(component.isAngular(), value);
    checkSize(reader, key, component, value);
  }
  if (!reader.failed() && machine.joint(joint).continuous) closeTurn(reader, key, grid, values);
  const std::string frame = reader.stringOr("frame", "moved");
  if (frame != "moved" && frame != "fixed") {
    reader.fail("frame", "model.frame", fmt::format("'frame' is '{}', expected 'moved' or 'fixed'.", frame));
  }
  if (reader.failed()) return reader.error();
  const std::size_t count = values.size();
  Result<ErrorTable> table = ErrorTable::make(grid, std::move(values));
  if (!table) {
    reader.fail(key, table.error().code, table.error().text);
    return reader.error();
  }
  auto effect =
      std::make_shared<TableEffect>(joint, component, std::move(*table), frame == "fixed" && rotary);
  if (reader.has("reference_mm")) {
    const std::vector<double> reference = reader.numbers("reference_mm", 3);
    effect->setReference({reference[0], reference[1], reference[2]});
  }
  const char* sigma_key = component.isAngular() ? "sigmas_arcsec" : "sigmas_um";
  if (reader.has(sigma_key)) {
    effect->setSigmas(readSigmas(reader, sigma_key, component.isAngular(), given, count));
  }
  if (reader.failed()) return reader.error();
  return std::shared_ptr<Effect>(std::move(effect));
}

LocationEffect::LocationEffect(int joint, Component component, double value, std::optional<double> sigma)
    : Effect(joint, component, Slot::Located), value_(value), sigma_(sigma) {}

void LocationEffect::addMotion(const MachineState&, std::span<const double>, SmallMotion& sum) const {
  rowOf(sum, component().row) += value_;
}

std::vector<Parameter> LocationEffect::parameters() const {
  const bool angular = component().isAngular();
  Parameter parameter{"value", angular ? "arcsec" : "um", toShown(angular, value_), std::nullopt};
  if (sigma_) parameter.sigma = toShown(angular, *sigma_);
  return {parameter};
}

Json LocationEffect::toJson(const kinematics::Machine&) const {
  const bool angular = component().isAngular();
  Json json = Json::object();
  json.set("effect", id()).set("component", component().text());
  json.set(angular ? "value_arcsec" : "value_um", toShown(angular, value_));
  if (sigma_) json.set(angular ? "sigma_arcsec" : "sigma_um", toShown(angular, *sigma_));
  return json;
}

Result<std::shared_ptr<Effect>> LocationEffect::fromJson(JsonReader& reader, int joint, Component component) {
  const bool angular = component.isAngular();
  const char* key = angular ? "value_arcsec" : "value_um";
  const double value = fromShown(angular, reader.number(key));
  checkSize(reader, key, component, value, kLargestSetting);
  std::optional<double> sigma;
  const char* sigma_key = angular ? "sigma_arcsec" : "sigma_um";
  if (reader.has(sigma_key)) sigma = fromShown(angular, reader.number(sigma_key));
  if (sigma && *sigma < 0.0) {
    reader.fail(sigma_key, "model.sigma",
                fmt::format("'{}' is {}, expected 0 or more.", sigma_key, toShown(angular, *sigma)));
  }
  if (reader.failed()) return reader.error();
  return std::shared_ptr<Effect>(std::make_shared<LocationEffect>(joint, component, value, sigma));
}

}  // namespace nineline::errors
