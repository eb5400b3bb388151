#include "core/errors/error_model_file.h"

#include <fmt/format.h>

#include "core/base/file.h"
#include "core/errors/effect_catalogue.h"
#include "core/errors/effect_spec.h"
#include "core/kinematics/machine_file.h"

namespace nineline::errors {

namespace {

constexpr const char* kFormat = "nineline-model/1";

Result<Machine> machineOf(JsonReader& reader) {
  const Json* value = reader.json().find("machine");
  if (value != nullptr && value->members() != nullptr)
    return kinematics::machineFromJson(*value, reader.source());
  const std::string id = reader.string("machine");
  if (reader.failed()) return reader.error();
  if (const Machine* machine = kinematics::findBuiltInMachine(id)) return *machine;
  reader.fail("machine", "model.machine",
              fmt::format("'{}' is no built-in machine, expected an id or a whole machine.", id));
  return reader.error();
}

bool isBuiltIn(const Machine& machine) {
  const Machine* known = kinematics::findBuiltInMachine(machine.id());
  return known != nullptr &&
         writeJson(kinematics::machineToJson(*known)) == writeJson(kinematics::machineToJson(machine));
}

}  // namespace

Result<ErrorModel> errorModelFromJson(const Json& json, const std::string& source) {
  JsonReader reader(json, source, "error model");
  const std::string format = reader.string("format");
  if (!reader.failed() && format != kFormat) {
    reader.fail("format", "model.format", fmt::format("'format' is '{}', expected '{}'.", format, kFormat));
  }
  if (reader.failed()) return reader.error();
  Result<Machine> machine = machineOf(reader);
  if (!machine) return machine.error();
  std::vector<EffectPtr> effects;
  for (const Json& item : reader.items("effects")) {
    Result<EffectPtr> effect = effectFromJson(item, source, effects.size() + 1, *machine);
    if (!effect) return effect.error();
    effects.push_back(std::move(*effect));
  }
  if (reader.failed()) return reader.error();
  Result<ErrorModel> model = ErrorModel::make(std::move(*machine), std::move(effects));
  if (model) return model;
  Error error = model.error();
  const Json* list = json.find("effects");
  error.source = source;
  error.line = list->line();
  error.column = list->column();
  return error;
}

Result<ErrorModel> readErrorModel(std::string_view text, const std::string& source) {
  const Result<Json> json = parseJson(text, source);
  if (!json) return json.error();
  return errorModelFromJson(*json, source);
}

Result<ErrorModel> loadErrorModel(const std::string& path) {
  const Result<std::string> text = readFile(path);
  if (!text) return text.error();
  return readErrorModel(*text, path);
}

Json errorModelToJson(const ErrorModel& model) {
  Json json = Json::object();
  json.set("format", kFormat);
  const Machine& machine = model.machine();
  json.set("machine", isBuiltIn(machine) ? Json(machine.id()) : kinematics::machineToJson(machine));
  Json effects = Json::array();
  for (const EffectPtr& effect : model.effects()) {
    Json entry = effect->toJson(machine);
    const EffectSpec* spec = findEffectSpec(effect->id());
    const bool active = spec == nullptr || spec->isActiveByDefault();
    if (effect->isActive() != active) entry.set("active", effect->isActive());
    if (!effect->provenance().source.empty()) entry.set("source", effect->provenance().source);
    if (!effect->provenance().when.empty()) entry.set("when", effect->provenance().when);
    effects.push(std::move(entry));
  }
  return json.set("effects", std::move(effects));
}

}  // namespace nineline::errors
