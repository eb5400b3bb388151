#include "core/errors/parameter_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/errors/effect_makers.h"

namespace nineline::errors {

namespace {

/// Shapes may be called by name.
const double* shapeNamed(const Json& json) {
  static constexpr std::array<std::pair<std::string_view, double>, 5> kShapes{
      {{"linear", 1.0}, {"bow", 2.0}, {"s", 3.0}, {"S", 3.0}, {"S-shape", 3.0}}};
  const std::string* name = json.string();
  const auto found = std::find_if(kShapes.begin(), kShapes.end(),
                                  [&](const auto& one) { return name != nullptr && one.first == *name; });
  return found == kShapes.end() ? nullptr : &found->second;
}

/// "um/m2" for "um/m²".
bool isSameUnit(std::string stated, std::string_view unit) {
  if (const std::size_t place = unit.find("²"); place != std::string_view::npos) {
    const std::size_t two = std::string_view("²").size();
    if (stated == std::string(unit.substr(0, place)) + "2" + std::string(unit.substr(place + two)))
      return true;
  }
  return stated == unit;
}

/// `all`: the entry's member "parameters". A parameter is a number or an object with value, sigma and unit.
Result<Parameter> readParameter(JsonReader& all, const ParameterSpec& rule, std::string unit) {
  Parameter parameter{std::string(rule.name), std::move(unit), 0.0, std::nullopt};
  const Json& json = *all.json().find(rule.name);
  JsonReader inner(json, all.source(), fmt::format("parameter '{}'", rule.name));
  const bool bare = json.members() == nullptr;
  const Json* value = bare ? &json : json.find("value");
  const double* named = rule.name == "shape" && value != nullptr ? shapeNamed(*value) : nullptr;
  JsonReader& reader = bare ? all : inner;
  const std::string_view key = bare ? rule.name : std::string_view("value");
  parameter.value = named != nullptr ? *named : reader.number(key);
  if (!bare && inner.has("sigma")) parameter.sigma = inner.number("sigma");
  const std::string stated = bare ? parameter.unit : inner.stringOr("unit", parameter.unit);
  if (!reader.failed() && !isSameUnit(stated, parameter.unit)) {
    inner.fail("unit", "model.unit", fmt::format("the unit is '{}', expected '{}'.", stated, parameter.unit));
  }
  if (!reader.failed()) {
    if (const std::string fault = faultOf(rule, parameter); !fault.empty()) {
      const bool of_sigma = fault.starts_with("'sigma'");
      reader.fail(of_sigma ? std::string_view("sigma") : key,
                  of_sigma ? "model.sigma" : (rule.name == "period" ? "model.period" : "model.size"), fault);
    }
  }
  if (reader.failed()) return reader.error();
  return parameter;
}

}  // namespace

Result<std::vector<Parameter>> readParameters(JsonReader& reader, const EffectSpec& spec,
                                              const UnitChoice& units) {
  const Json* given = reader.json().find("parameters");
  if (given == nullptr) {
    reader.fail("parameters", "json.missing", "'parameters' is missing, expected an object.");
    return reader.error();
  }
  JsonReader all(*given, reader.source(), fmt::format("parameters of '{}'", spec.id));
  if (all.failed()) return all.error();
  std::vector<Parameter> parameters;
  for (const ParameterSpec& rule : spec.parameters) {
    std::string unit(unitOf(rule.quantity, units));
    if (!all.has(rule.name)) {
      if (rule.otherwise || rule.optional) continue;
      all.fail(rule.name, "model.parameter",
               fmt::format("'{}' is missing, expected a number in {}.", rule.name, unit));
      return all.error();
    }
    Result<Parameter> parameter = readParameter(all, rule, std::move(unit));
    if (!parameter) return parameter.error();
    parameters.push_back(std::move(*parameter));
  }
  return parameters;
}

Json parametersToJson(const std::vector<Parameter>& parameters) {
  Json all = Json::object();
  for (const Parameter& parameter : parameters) {
    Json one = Json::object();
    one.set("value", parameter.value);
    if (parameter.sigma) one.set("sigma", *parameter.sigma);
    all.set(parameter.name, std::move(one.set("unit", parameter.unit)));
  }
  return all;
}

}  // namespace nineline::errors
