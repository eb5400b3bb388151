#include "tests/campaign/campaign_machine.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"

namespace nineline::campaign {

namespace {

/// A few waves of different lengths: smooth, as errors of guides and bearings are.
std::vector<double> drawCurve(Random& random, std::size_t count, bool periodic, double size) {
  std::vector<double> values(count, periodic ? 0.0 : random.between(-size, size));
  for (int wave = 1; wave <= 3; ++wave) {
    const double amplitude = random.between(-size, size) / wave;
    const double turns = periodic ? wave : random.between(0.3, 1.0) * wave;
    const double phase = random.between(0.0, kTurn);
    for (std::size_t i = 0; i < count; ++i)
      values[i] +=
          amplitude * std::sin(turns * kTurn * static_cast<double>(i) / static_cast<double>(count) + phase);
  }
  return values;
}

void drawTables(Random& random, PlainMachine& machine) {
  for (int joint = 0; joint < static_cast<int>(machine.joints.size()); ++joint) {
    const PlainJoint& one = machine.joints[static_cast<std::size_t>(joint)];
    for (int row = 0; row < 6; ++row) {
      const double size = row < 3 ? mmFromUm(6.0) : radFromArcsec(4.0);
      PlainTable table;
      table.joint = joint;
      table.row = row;
      table.periodic = one.continuous;
      table.fixed_frame = one.rotary && random.whole(0, 1) == 1;
      table.start = one.continuous ? 0.0 : one.low;
      const std::size_t count = one.continuous ? 24 : 21;
      table.spacing = one.continuous ? kTurn / 24.0 : (one.high - one.low) / 20.0;
      table.values = drawCurve(random, count, one.continuous, size);
      machine.tables.push_back(table);
      PlainTable location;
      location.joint = joint;
      location.row = row;
      location.location = true;
      location.values = {random.between(-size, size)};
      machine.tables.push_back(location);
    }
  }
}

void drawEffects(Random& random, PlainMachine& machine) {
  for (int joint = 0; joint < static_cast<int>(machine.joints.size()); ++joint) {
    const PlainJoint& one = machine.joints[static_cast<std::size_t>(joint)];
    const double unit = one.rotary ? radFromArcsec(1.0) : mmFromUm(1.0);
    PlainEffect effect;
    effect.joint = joint;
    effect.kind = PlainEffect::Kind::Scale;
    effect.size = one.continuous ? 0.0 : random.between(-3e-5, 3e-5);
    if (!one.rotary) machine.effects.push_back(effect);
    effect.kind = PlainEffect::Kind::Backlash;
    effect.size = random.between(1.0, 6.0) * unit;
    machine.effects.push_back(effect);
    effect.kind = PlainEffect::Kind::Cyclic;
    effect.size = random.between(0.3, 2.0) * unit;
    effect.period = one.rotary ? kTurn / random.whole(4, 36) : random.between(5.0, 20.0);
    effect.phase = random.between(0.0, kTurn);
    machine.effects.push_back(effect);
    if (one.rotary) continue;
    effect.kind = PlainEffect::Kind::ThermalScrew;
    effect.size = random.between(5e-6, 12e-6);
    effect.fixed = random.between(-300.0, 300.0);
    effect.above_20_C = random.between(-3.0, 8.0);
    machine.effects.push_back(effect);
  }
}

PlainJoint linearJoint(char letter, const Vector3d& direction, bool on_workpiece) {
  PlainJoint joint;
  joint.letter = letter;
  joint.direction = direction;
  joint.on_workpiece = on_workpiece;
  return joint;
}

PlainJoint rotaryJoint(char letter, const Vector3d& direction, bool continuous) {
  PlainJoint joint = linearJoint(letter, direction, true);
  joint.rotary = true;
  joint.continuous = continuous;
  joint.low = radFromDeg(-120.0);
  joint.high = radFromDeg(120.0);
  return joint;
}

void drawGrinder(Random& random, PlainMachine& machine) {
  machine.joints = {linearJoint('Z', Vector3d::UnitZ(), true), rotaryJoint('C', Vector3d::UnitZ(), true),
                    linearJoint('X', Vector3d::UnitX(), false)};
  machine.joints[0].low = -400.0;
  machine.joints[0].high = 400.0;
  machine.joints[2].low = -50.0;
  machine.joints[2].high = 350.0;
  machine.joints[2].diameter = random.whole(0, 2) == 0;
  machine.joints[1].offset = {0.0, random.between(-5.0, 5.0), random.between(100.0, 350.0)};
  machine.joints[2].offset = {random.between(150.0, 250.0), random.between(-5.0, 5.0),
                              random.between(100.0, 350.0)};
  machine.tool_tip = {-machine.joints[2].offset.x() + random.between(-20.0, 20.0),
                      machine.joints[1].offset.y() - machine.joints[2].offset.y() + random.between(-3.0, 3.0),
                      random.between(-30.0, 30.0)};
}

void drawMill(Random& random, PlainMachine& machine) {
  // Any of the linear joints may stand under the workpiece: the chain X, Y, Z is cut at a random place.
  const int table_joints = machine.structure == Structure::ThreeAxis ? random.whole(0, 2) : 0;
  for (int axis = 0; axis < 3; ++axis) {
    const bool table = axis < table_joints;
    PlainJoint joint = linearJoint("XYZ"[axis], (table ? -1.0 : 1.0) * Vector3d::Unit(axis), table);
    joint.offset = random.vector(100.0);
    machine.joints.push_back(joint);
  }
  machine.tool_tip = random.vector(20.0) + Vector3d(0.0, 0.0, random.between(-150.0, -50.0));
  if (machine.structure != Structure::Trunnion) return;
  PlainJoint tilt = rotaryJoint('A', -Vector3d::UnitX(), false);
  PlainJoint turn = rotaryJoint('C', -Vector3d::UnitZ(), true);
  tilt.offset = random.vector(60.0);
  turn.offset = random.vector(30.0);
  machine.joints.insert(machine.joints.begin(), {tilt, turn});
}

std::string vectorText(const Vector3d& v) {
  return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", v.x(), v.y(), v.z());
}

std::string jointText(const PlainJoint& joint) {
  std::string text =
      fmt::format(R"({{"axis": "{}", "type": "{}", "direction": {}, "offset_mm": {})", joint.letter,
                  joint.rotary ? "rotary" : "linear", vectorText(joint.direction), vectorText(joint.offset));
  const double unit = joint.rotary ? degFromRad(1.0) : 1.0;
  if (joint.diameter) text += R"(, "diameter": true)";
  text += joint.continuous
              ? std::string(R"(, "continuous": true)")
              : fmt::format(R"(, "travel": [{:.17g}, {:.17g}])", joint.low * unit, joint.high * unit);
  return text + "}";
}

std::string chainText(const PlainMachine& machine, bool workpiece) {
  std::string text;
  for (const PlainJoint& joint : machine.joints) {
    if (joint.on_workpiece != workpiece) continue;
    text += (text.empty() ? "" : ", ") + jointText(joint);
  }
  return "[" + text + "]";
}

std::string tableText(const PlainMachine& machine, const PlainTable& table) {
  const PlainJoint& joint = machine.joints[static_cast<std::size_t>(table.joint)];
  const bool angular = table.row >= 3;
  const char* const unit = angular ? "arcsec" : "um";
  const auto shown = [&](double value) {
    return fmt::format("{:.17g}", angular ? arcsecFromRad(value) : umFromMm(value));
  };
  const char direction = "XYZABC"[table.row];
  if (table.location) {
    return fmt::format(R"({{"effect": "location", "component": "{}0{}", "value_{}": {}}})", direction,
                       joint.letter, unit, shown(table.values.front()));
  }
  std::string values;
  for (const double value : table.values) values += (values.empty() ? "" : ", ") + shown(value);
  const double scale = joint.rotary ? degFromRad(1.0) : 1.0;
  return fmt::format(
      R"({{"effect": "table", "joint": "{0}", "component": "E{1}{0}", "start_{2}": {3:.17g}, "spacing_{2}": {4:.17g}, )"
      R"("values_{5}": [{6}], "interpolation": "cubic"{7}}})",
      joint.letter, direction, joint.rotary ? "deg" : "mm", table.start * scale, table.spacing * scale, unit,
      values, table.fixed_frame ? R"(, "frame": "fixed")" : "");
}

std::string parameterText(const char* name, double value, const char* unit) {
  return fmt::format(R"("{}": {{"value": {:.17g}, "unit": "{}"}})", name, value, unit);
}

std::string effectText(const PlainMachine& machine, const PlainEffect& effect) {
  const PlainJoint& joint = machine.joints[static_cast<std::size_t>(effect.joint)];
  const double error = joint.rotary ? arcsecFromRad(effect.size) : umFromMm(effect.size);
  const char* const error_unit = joint.rotary ? "arcsec" : "um";
  const double period = joint.rotary ? degFromRad(effect.period) : effect.period;
  const char* id = "scale";
  std::string parameters;
  std::string sensor;
  switch (effect.kind) {
    case PlainEffect::Kind::Scale:
      parameters = parameterText("k", effect.size * 1e6, "um/m");
      break;
    case PlainEffect::Kind::Backlash:
      id = "backlash";
      parameters = parameterText("width", error, error_unit);
      break;
    case PlainEffect::Kind::Cyclic:
      id = "cyclic";
      parameters = parameterText("amplitude", error, error_unit) + ", " +
                   parameterText("period", period, joint.rotary ? "deg" : "mm") + ", " +
                   parameterText("phase", degFromRad(effect.phase), "deg");
      break;
    case PlainEffect::Kind::ThermalScrew:
      id = "thermal_screw";
      parameters = parameterText("k", effect.size * 1e6, "um/m/C") + ", " +
                   parameterText("q_fixed", effect.fixed, "mm");
      sensor = fmt::format(R"(, "sensor": "{}")", sensorOf(joint));
      break;
  }
  return fmt::format(R"({{"effect": "{}", "joint": "{}", "parameters": {{{}}}{}}})", id, joint.letter,
                     parameters, sensor);
}

}  // namespace

const char* nameOf(Structure structure) {
  return structure == Structure::Grinder     ? "grinder"
         : structure == Structure::ThreeAxis ? "3-axis"
                                             : "trunnion";
}

std::string sensorOf(const PlainJoint& joint) { return fmt::format("temp_screw_{}_C", joint.letter); }

PlainMachine drawMachine(Random& random, Structure structure, bool more) {
  PlainMachine machine;
  machine.structure = structure;
  if (structure == Structure::Grinder) {
    drawGrinder(random, machine);
  } else {
    drawMill(random, machine);
  }
  drawTables(random, machine);
  if (more) drawEffects(random, machine);
  return machine;
}

std::string modelText(const PlainMachine& machine) {
  std::string effects;
  for (const PlainTable& table : machine.tables)
    effects += (effects.empty() ? "" : ",\n") + tableText(machine, table);
  for (const PlainEffect& effect : machine.effects) effects += ",\n" + effectText(machine, effect);
  return fmt::format(
      R"({{"format": "nineline-model/1", "machine": {{"format": "nineline-machine/1", "id": "campaign", "name": "{}",)"
      "\n"
      R"("workpiece_chain": {}, "tool_chain": {}, "tool": {{"tip_mm": {}, "axis": [0, 0, 1]}}}},)"
      "\n\"effects\": [\n{}]}}\n",
      nameOf(machine.structure), chainText(machine, true), chainText(machine, false),
      vectorText(machine.tool_tip), effects);
}

}  // namespace nineline::campaign
