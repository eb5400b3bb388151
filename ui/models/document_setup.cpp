#include <fmt/format.h>

#include "core/base/text.h"
#include "core/base/units.h"
#include "ui/models/document.h"

namespace nineline::models {

namespace {

using kinematics::JointPositions;
using kinematics::Machine;

/// {"X": 12.5, "C": 90}: mm and deg by axis name.
Result<JointPositions> positionsOf(const Json& json, const Machine& machine, const std::string& what) {
  JointPositions q{};
  if (json.members() == nullptr) return q;
  for (const auto& [name, value] : *json.members()) {
    const std::optional<AxisId> axis = parseAxisId(name);
    const int joint = axis ? machine.find(*axis) : -1;
    if (joint < 0) continue;  // of a machine chosen before
    if (value.number() == nullptr) {
      return badInput("setup.number",
                      fmt::format("{} of {} is {}, expected a number.", what, name, value.describe()));
    }
    q[static_cast<std::size_t>(joint)] =
        machine.isRotary(joint) ? radFromDeg(*value.number()) : *value.number();
  }
  return q;
}

Result<void> readWorkOffsets(const Json& json, const Machine& machine, simulation::ProgramSetup& setup) {
  const Json* offsets = json.find("work_offsets");
  if (offsets == nullptr || offsets->members() == nullptr) return {};
  for (const auto& [name, values] : *offsets->members()) {
    const Result<JointPositions> q = positionsOf(values, machine, name);
    if (!q) return q.error();
    setup.work_offsets[name] = *q;
  }
  return {};
}

Result<void> readToolLengths(const Json& json, simulation::ProgramSetup& setup) {
  const Json* lengths = json.find("tool_lengths");
  if (lengths == nullptr || lengths->members() == nullptr) return {};
  for (const auto& [name, value] : *lengths->members()) {
    const std::optional<long long> number = parseInteger(name);
    if (!number || value.number() == nullptr) {
      return badInput("setup.tool",
                      fmt::format("tool length '{}' is {}, expected a number in mm for a whole H number.",
                                  name, value.describe()));
    }
    setup.tool_lengths[static_cast<int>(*number)] = *value.number();
  }
  return {};
}

Result<void> readConditions(const Json& json, errors::MachineState& state) {
  const Json* conditions = json.find("conditions");
  if (conditions == nullptr || conditions->members() == nullptr) return {};
  for (const auto& [name, value] : *conditions->members()) {
    if (value.isNull()) continue;
    if (value.number() == nullptr) {
      return badInput("setup.condition",
                      fmt::format("'{}' is {}, expected a number.", name, value.describe()));
    }
    if (name == "pass_1") state.pass = *value.number();
    if (name == "load_kg") state.load = *value.number();
    state.conditions.emplace_back(name, *value.number());
  }
  return {};
}

}  // namespace

Result<simulation::ProgramSetup> setupOf(const Document& document, const Machine& machine) {
  simulation::ProgramSetup setup;
  JsonReader reader(document.setup, "", "machine state");
  const std::string dialect = reader.stringOr("dialect", "auto");
  if (dialect == "fanuc") setup.dialect = nc::Dialect::Fanuc;
  if (dialect == "siemens") setup.dialect = nc::Dialect::Siemens;
  if (dialect == "linuxcnc") setup.dialect = nc::Dialect::LinuxCnc;
  setup.block_skip = reader.booleanOr("block_skip", false);
  if (reader.failed()) return reader.error();
  if (const Json* start = document.setup.find("start")) {
    const Result<JointPositions> q = positionsOf(*start, machine, "the start position");
    if (!q) return q.error();
    setup.start = *q;
  }
  if (const Result<void> read = readWorkOffsets(document.setup, machine, setup); !read) return read.error();
  if (const Result<void> read = readToolLengths(document.setup, setup); !read) return read.error();
  if (const Result<void> read = readConditions(document.setup, setup.state); !read) return read.error();
  return setup;
}

Result<compensation::CompensationOptions> optionsOf(const Document& document) {
  compensation::CompensationOptions options;
  JsonReader reader(document.options, "", "compensation options");
  const auto positive = [&reader](const char* key, double otherwise) {
    const double value = reader.numberOr(key, otherwise);
    if (!reader.failed() && value <= 0.0) {
      reader.fail(key, "options.positive", fmt::format("'{}' is {}, expected a number above 0.", key, value));
    }
    return value;
  };
  options.tolerance = mmFromUm(positive("tolerance_um", umFromMm(options.tolerance)));
  options.angle_tolerance =
      radFromArcsec(positive("angle_tolerance_arcsec", arcsecFromRad(options.angle_tolerance)));
  options.largest_correction = positive("largest_correction_mm", options.largest_correction);
  options.largest_angle_correction =
      radFromDeg(positive("largest_correction_deg", degFromRad(options.largest_angle_correction)));
  options.keep_block_count = reader.booleanOr("keep_block_count", options.keep_block_count);
  options.correct_rapids = reader.booleanOr("correct_rapids", options.correct_rapids);
  const std::string mode = reader.stringOr("mode", "auto");
  if (mode == "tip") options.mode = compensation::Mode::TipOnly;
  if (mode == "thread") options.mode = compensation::Mode::Thread;
  const auto decimals = [&reader](const char* key) -> std::optional<int> {
    const Json* value = reader.json().find(key);
    if (value == nullptr || value->isNull()) return std::nullopt;
    const double number = reader.number(key);
    if (reader.failed()) return std::nullopt;
    if (number < 0.0 || number > 9.0 || number != static_cast<double>(static_cast<int>(number))) {
      reader.fail(key, "options.decimals", fmt::format("'{}' is {}, expected 0 to 9.", key, number));
      return std::nullopt;
    }
    return static_cast<int>(number);
  };
  options.linear_decimals = decimals("linear_decimals");
  options.rotary_decimals = decimals("rotary_decimals");
  if (reader.failed()) return reader.error();
  return options;
}

}  // namespace nineline::models
