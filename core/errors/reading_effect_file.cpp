#include <fmt/format.h>

#include "core/errors/parameter_file.h"
#include "core/errors/reading_effect.h"

namespace nineline::errors {

Json ReadingEffect::toJson(const kinematics::Machine& machine) const {
  Json json = Json::object();
  json.set("effect", id()).set("instrument", placement_.instrument);
  if (placement_.joint >= 0) json.set("joint", machine.joint(placement_.joint).axis.text());
  if (!placement_.file.empty()) json.set("file", placement_.file);
  json.set("parameters", parametersToJson(parameters_));
  if (!placement_.sensor.empty()) json.set("sensor", placement_.sensor);
  if (!placement_.sensor_2.empty()) json.set("sensor_2", placement_.sensor_2);
  if (spec_->id == "wrong_arm") json.set("arm", std::string(1, "xyz"[placement_.row]));
  if (placement_.angular) json.set("angular", true);
  return json;
}

Result<ReadingEffect> ReadingEffect::fromJson(const Json& json, const std::string& source,
                                              const kinematics::Machine& machine) {
  JsonReader reader(json, source, "measurement effect");
  const std::string id = reader.string("effect");
  const EffectSpec* spec = findEffectSpec(id);
  ReadingPlacement placement;
  placement.instrument = reader.stringOr("instrument", "");
  placement.file = reader.stringOr("file", "");
  placement.sensor = reader.stringOr("sensor", "");
  placement.sensor_2 = reader.stringOr("sensor_2", "");
  placement.angular = reader.booleanOr("angular", false);
  const std::string arm = reader.stringOr("arm", "x");
  const std::string joint = reader.stringOr("joint", "");
  if (reader.failed()) return reader.error();
  const std::size_t row = std::string_view("xyz").find(arm);
  const std::optional<AxisId> axis = parseAxisId(joint);
  placement.joint = axis ? machine.find(*axis) : -1;
  if (spec == nullptr || spec->kind != EffectKind::Measurement) {
    reader.fail("effect", "model.effect", fmt::format("'{}' is no error of a measurement.", id));
  } else if (!joint.empty() && placement.joint < 0) {
    reader.fail("joint", "model.joint", fmt::format("the machine '{}' has no axis {}.", machine.id(), joint));
  } else if (arm.size() != 1 || row == std::string_view::npos) {
    reader.fail("arm", "model.arm", fmt::format("'arm' is '{}', expected x, y or z.", arm));
  }
  if (reader.failed()) return reader.error();
  placement.row = static_cast<int>(row);
  Result<std::vector<Parameter>> parameters = readParameters(reader, *spec, unitChoice(placement));
  if (!parameters) return parameters.error();
  Result<ReadingEffect> effect = make(*spec, std::move(placement), *parameters);
  if (effect) return effect;
  reader.fail("parameters", "model.parameter", effect.error().text);
  return reader.error();
}

}  // namespace nineline::errors
