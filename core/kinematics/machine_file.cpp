#include "core/kinematics/machine_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/file.h"
#include "core/base/units.h"

namespace nineline::kinematics {

namespace {

constexpr const char* kFormat = "nineline-machine/1";

Vector3d vectorFrom(JsonReader& reader, std::string_view key) {
  const std::vector<double> v = reader.numbers(key, 3);
  return {v[0], v[1], v[2]};
}

Json vectorToJson(const Vector3d& v) { return Json(Json::Array{Json(v.x()), Json(v.y()), Json(v.z())}); }

JointType readType(JsonReader& reader) {
  const std::string type = reader.string("type");
  if (!reader.failed() && type != "linear" && type != "rotary") {
    reader.fail("type", "machine.type", fmt::format("'type' is '{}', expected 'linear' or 'rotary'.", type));
  }
  return type == "rotary" ? JointType::Rotary : JointType::Linear;
}

void readTravel(JsonReader& reader, Joint& joint) {
  const Json* travel = reader.json().find("travel");
  if (travel == nullptr || travel->isNull()) return;
  const std::vector<double> ends = reader.numbers("travel", 2);
  const bool rotary = joint.type == JointType::Rotary;
  joint.travel = rotary ? Travel{radFromDeg(ends[0]), radFromDeg(ends[1])} : Travel{ends[0], ends[1]};
}

void readRapid(JsonReader& reader, Joint& joint) {
  const bool rotary = joint.type == JointType::Rotary;
  const char* key = rotary ? "rapid_deg_min" : "rapid_mm_min";
  if (!reader.has(key)) return;
  const double rapid = reader.number(key);
  if (rapid <= 0.0)
    reader.fail(key, "machine.rapid", fmt::format("'{}' is {}, expected a speed above 0.", key, rapid));
  joint.rapid_speed = perSecondFromPerMinute(rotary ? radFromDeg(rapid) : rapid);
}

/// What Machine::make says of this joint, reported at the member that it speaks of ("machine.travel":
/// travel).
void checkAlone(JsonReader& reader, const Joint& joint) {
  Machine::Description alone;
  alone.tool_chain.push_back(joint);
  const Result<Machine> machine = Machine::make(std::move(alone));
  if (machine) return;
  const std::string& code = machine.error().code;
  reader.fail(std::string_view(code).substr(code.find('.') + 1), code, machine.error().text);
}

void checkToolAxis(JsonReader& reader, const Vector3d& axis) {
  if (std::abs(axis.norm() - 1.0) > 1e-3) {
    reader.fail("axis", "machine.direction",
                fmt::format("'axis' has length {:.6g}, expected a unit vector.", axis.norm()));
  }
}

Result<Joint> readJoint(const Json& json, const std::string& source, std::string_view chain,
                        std::size_t number) {
  JsonReader reader(json, source, fmt::format("{} joint {}", chain, number));
  Joint joint;
  const std::string axis = reader.string("axis");
  if (const std::optional<AxisId> id = parseAxisId(axis)) {
    joint.axis = *id;
  } else if (!reader.failed()) {
    reader.fail(
        "axis", "machine.axis",
        fmt::format("'{}' is no axis name, expected one of X Y Z U V W A B C, with a digit where it repeats.",
                    axis));
  }
  joint.type = readType(reader);
  if (!reader.failed()) joint.direction = vectorFrom(reader, "direction");
  if (!reader.failed() && reader.has("offset_mm")) joint.offset = vectorFrom(reader, "offset_mm");
  if (!reader.failed()) readTravel(reader, joint);
  joint.continuous = reader.booleanOr("continuous", false);
  joint.diameter = reader.booleanOr("diameter", false);
  if (!reader.failed()) readRapid(reader, joint);
  if (!reader.failed()) checkAlone(reader, joint);
  if (reader.failed()) return reader.error();
  return joint;
}

/// Reads a chain behind the joints that are already known, whose names may not come back.
Result<std::vector<Joint>> readChain(JsonReader& reader, std::string_view key,
                                     const std::vector<Joint>& known) {
  std::vector<Joint> chain;
  for (const Json& item : reader.items(key)) {
    Result<Joint> joint = readJoint(item, reader.source(), key, chain.size() + 1);
    if (!joint) return joint.error();
    const auto same = [&joint](const Joint& other) { return other.axis == joint->axis; };
    if (std::any_of(known.begin(), known.end(), same) || std::any_of(chain.begin(), chain.end(), same)) {
      JsonReader place(item, reader.source(), fmt::format("{} joint {}", key, chain.size() + 1));
      place.fail("axis", "machine.axis",
                 fmt::format("Axis {} occurs twice; give one of them a digit.", joint->axis.text()));
      return place.error();
    }
    chain.push_back(*joint);
  }
  if (reader.failed()) return reader.error();
  return chain;
}

Json jointToJson(const Joint& joint) {
  const bool rotary = joint.type == JointType::Rotary;
  Json json = Json::object();
  json.set("axis", joint.axis.text()).set("type", rotary ? "rotary" : "linear");
  json.set("direction", vectorToJson(joint.direction)).set("offset_mm", vectorToJson(joint.offset));
  if (joint.travel) {
    const auto shown = [rotary](double value) { return Json(rotary ? degFromRad(value) : value); };
    json.set("travel", Json(Json::Array{shown(joint.travel->low), shown(joint.travel->high)}));
  }
  if (joint.continuous) json.set("continuous", true);
  if (joint.diameter) json.set("diameter", true);
  if (joint.rapid_speed) {
    const double rapid = perMinuteFromPerSecond(*joint.rapid_speed);
    json.set(rotary ? "rapid_deg_min" : "rapid_mm_min", rotary ? degFromRad(rapid) : rapid);
  }
  return json;
}

}  // namespace

Result<Machine> machineFromJson(const Json& json, const std::string& source) {
  JsonReader reader(json, source, "machine");
  const std::string format = reader.string("format");
  if (!reader.failed() && format != kFormat) {
    reader.fail("format", "machine.format", fmt::format("'format' is '{}', expected '{}'.", format, kFormat));
  }
  Machine::Description description;
  description.id = reader.string("id");
  description.name = reader.stringOr("name", description.id);
  if (reader.failed()) return reader.error();
  Result<std::vector<Joint>> workpiece = readChain(reader, "workpiece_chain", {});
  if (!workpiece) return workpiece.error();
  Result<std::vector<Joint>> tool = readChain(reader, "tool_chain", *workpiece);
  if (!tool) return tool.error();
  description.workpiece_chain = std::move(*workpiece);
  description.tool_chain = std::move(*tool);
  if (const Json* value = json.find("tool")) {
    JsonReader tool_reader(*value, source, "machine tool");
    if (!tool_reader.failed() && tool_reader.has("tip_mm"))
      description.tool_tip = vectorFrom(tool_reader, "tip_mm");
    if (!tool_reader.failed() && tool_reader.has("axis"))
      description.tool_axis = vectorFrom(tool_reader, "axis");
    if (!tool_reader.failed()) checkToolAxis(tool_reader, description.tool_axis);
    if (tool_reader.failed()) return tool_reader.error();
  }
  Result<Machine> machine = Machine::make(std::move(description));
  if (machine) return machine;
  Error error = machine.error();
  error.source = source;
  error.line = json.line();
  error.column = json.column();
  return error;
}

Result<Machine> readMachine(std::string_view text, const std::string& source) {
  const Result<Json> json = parseJson(text, source);
  if (!json) return json.error();
  return machineFromJson(*json, source);
}

Json machineToJson(const Machine& machine) {
  const Machine::Description description = machine.description();
  Json json = Json::object();
  json.set("format", kFormat).set("id", description.id).set("name", description.name);
  Json workpiece = Json::array();
  for (const Joint& joint : description.workpiece_chain) workpiece.push(jointToJson(joint));
  Json tool = Json::array();
  for (const Joint& joint : description.tool_chain) tool.push(jointToJson(joint));
  json.set("workpiece_chain", std::move(workpiece)).set("tool_chain", std::move(tool));
  Json tool_point = Json::object();
  tool_point.set("tip_mm", vectorToJson(description.tool_tip))
      .set("axis", vectorToJson(description.tool_axis));
  return json.set("tool", std::move(tool_point));
}

Result<Machine> loadMachine(const std::string& id_or_path) {
  if (const Machine* machine = findBuiltInMachine(id_or_path)) return *machine;
  const Result<std::string> text = readFile(id_or_path);
  if (!text) {
    Error error = text.error();
    error.text +=
        fmt::format(" '{}' is no built-in machine either; 'nineline-cli machines' lists them.", id_or_path);
    return error;
  }
  return readMachine(*text, id_or_path);
}

}  // namespace nineline::kinematics
