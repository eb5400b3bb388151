#include "core/errors/effect_specs.h"
#include "core/errors/spec_parts.h"

namespace nineline::errors {

namespace {

ParameterSpec lag(std::vector<double> starts, double longest) {
  ParameterSpec one = searched("tau", Quantity::Duration, both(0.0, longest), std::move(starts));
  one.otherwise = 0.0;
  return one;
}

EffectSpec thermalScrew() {
  return {
      .id = "thermal_screw",
      .title = "Growth of the ball screw",
      .rows = "6-8",
      .formula =
          "k (T - 20)(q - q_fixed); preload: k max(0, T - preload)(q - q_fixed); two sensors: its "
          "integral along the screw",
      .parameters = {linear("k", Quantity::Growth, both(5.0, 20.0)), place("q_fixed", {0.0, 0.5, 1.0}, 0.0),
                     optional(
                         searched("preload", Quantity::Temperature, both(20.0, 40.0), {22, 25, 28, 32}))},
      .sensors = 1,
      .standard_sensor = "temp_screw_{}_C",
      .lookalikes = {{"scale", "at one temperature both grow with the travel",
                      "needs a run at another temperature, 3 C apart or more"},
                     {"material_temperature", "a wrong material sensor of the laser scales alike",
                      "a second instrument on the axis; screw warm while the material is cool"},
                     {"thermal_scale", "both grow with a temperature", "sensors on screw and scale apart"}},
      .action_limit = {1.0, 3.0},
      .shop_floor = {"The screw warms by friction in nut and bearings and grows away from its fixed bearing.",
                     "9 to 12 um per metre and degree: 5 to 30 um in the first hour of work.",
                     "Warm the axis up before work, cool or stretch the screw, fit a linear scale; or "
                     "compensate by a sensor near the nut."}};
}

EffectSpec thermalScale() {
  return {
      .id = "thermal_scale",
      .title = "Growth of the linear scale",
      .rows = "9",
      .formula = "k (T - 20)(q - q_fixed)",
      .parameters = {linear("k", Quantity::Growth, both(0.0, 12.0)), place("q_fixed", {0.0, 0.5, 1.0}, 0.0)},
      .sensors = 1,
      .standard_sensor = "temp_scale_{}_C",
      .lookalikes = {{"thermal_screw", "both grow with a temperature", "sensors on screw and scale apart"},
                     {"scale", "at one temperature both grow with the travel",
                      "needs a run at another temperature, 3 C apart or more"}},
      .action_limit = {0.5, 2.0},
      .shop_floor = {"Glass or steel scales grow with their temperature, less than cast iron.",
                     "8 um/m/C glass, 11 steel, 0 to 1 glass ceramics.",
                     "Keep coolant mist and chips off the scale; enter its expansion in the control."}};
}

EffectSpec thermalHead() {
  return {.id = "thermal_head",
          .title = "Growth of headstock, spindle or wheel head",
          .rows = "37, 38",
          .formula = "k y, tau dy/dt = T - y; T - 20 of a temperature, or an on/off column",
          .parameters = {linear("k", Quantity::PerTemperature, both(0.0, 60.0), both(0.0, 20.0)),
                         lag({0, 600, 1000, 1500, 2300, 3500}, 8000.0)},
          .joints = JointChoice::Any,
          .sites = kEachWay | kLocation,
          .sensors = 1,
          .standard_sensor = "temp_head_C",
          .lookalikes = {{"drift", "while the machine warms both only rise",
                          "spindle on and off, not in step with the room"},
                         {"thermal_ambient", "the room and the head warm together in the morning",
                          "spindle on and off, not in step with the room"},
                         {"datum_shift", "a shifted datum looks like a sudden growth",
                          "probe a fixed datum every 2 to 3 minutes"}},
          .action_limit = {1.0, 5.0},
          .shop_floor = {"Bearing losses warm the head; centre height and position move over an hour.",
                         "5 to 50 um from cold to warm.",
                         "Warm up, keep the spindle turning in breaks, control the coolant's temperature; or "
                         "compensate by a sensor in the head."}};
}

EffectSpec thermalAmbient() {
  return {.id = "thermal_ambient",
          .title = "Drift with the room's temperature",
          .rows = "39",
          .formula = "k y, tau dy/dt = (T - 20) - y",
          .parameters = {linear("k", Quantity::PerTemperature, both(0.0, 20.0), both(0.0, 10.0)),
                         lag({0, 500, 1200, 2500, 4500, 8000}, 15000.0)},
          .joints = JointChoice::Any,
          .sites = kEachWay | kLocation,
          .sensors = 1,
          .standard_sensor = "temp_ambient_C",
          .lookalikes = {{"thermal_head", "the room and the head warm together in the morning",
                          "spindle on and off, not in step with the room"},
                         {"drift", "over a morning both rise steadily", "a run at another time of day"}},
          .action_limit = {1.0, 5.0},
          .shop_floor = {
              "Bed and column follow the hall with a delay of one to several hours.", "1 to 5 um per degree.",
              "Close doors, no sun or heater on the machine; measure and finish at the same hour."}};
}

EffectSpec coolant() {
  return {.id = "coolant",
          .title = "Coolant on or off",
          .rows = "42",
          .formula = "k y, tau dy/dt = coolant - y",
          .parameters = {linear("k", Quantity::PerTemperature, both(0.0, 60.0), both(0.0, 20.0)),
                         lag({0, 60, 200, 600, 1200}, 1500.0)},
          .joints = JointChoice::Any,
          .sites = kEachWay | kLocation,
          .sensors = 1,
          .standard_sensor = "coolant_1",
          .lookalikes = {{"thermal_head", "coolant and spindle are switched together", "switch them apart"},
                         {"datum_shift", "both begin at one instant", "switch the coolant several times"}},
          .action_limit = {1.0, 5.0},
          .shop_floor = {"Coolant cools (or warms) bed and work once it flows.", "2 to 20 um within minutes.",
                         "Let the coolant run 20 minutes before finishing; control its temperature."}};
}

EffectSpec thermalTilt() {
  return {
      .id = "thermal_tilt",
      .title = "Tilt of column or bed by a temperature difference",
      .rows = "40",
      .formula = "k (T1 - T2), a rotation",
      .parameters = {linear("k", Quantity::PerTemperature, both(0.0, 50.0), both(0.0, 10.5))},
      .sites = kTilt | kLocation,
      .sensors = 2,
      .standard_sensor = "temp_column_front_C",
      .lookalikes = {{"thermal_head", "at one arm both move the tool", "measure at two heights"}},
      .action_limit = {1.0, 3.0},
      .shop_floor = {"One side of the column is warmer than the other (motor, hydraulics, sun), so it bends "
                     "away.",
                     "0.5 to 3 arcsec per degree.",
                     "Remove or shield the source, let air through; measure both sides and compensate."}};
}

EffectSpec thermalWorkpiece() {
  return {
      .id = "thermal_workpiece",
      .title = "Growth of the workpiece in process",
      .kind = EffectKind::Process,
      .rows = "48",
      .formula = "k (T - 20)(q - q_fixed)",
      .parameters = {linear("k", Quantity::Growth, both(5.0, 25.0)), place("q_fixed", {0.0, 0.5, 1.0}, 0.0)},
      .sensors = 1,
      .standard_sensor = "temp_workpiece_C",
      .lookalikes = {{"scale", "parts ground equally warm are all short alike", "measure after cooling down"},
                     {"wheel_wear", "both grow from part to part", "dress between parts"}},
      .action_limit = {0.5, 2.0},
      .shop_floor = {"The part is ground warm and shrinks when it cools: a long thread comes out short.",
                     "11.5 um per metre and degree of steel.",
                     "More coolant, smaller infeed; let the part cool before the last pass."}};
}

EffectSpec drift() {
  return {
      .id = "drift",
      .title = "Steady drift of unknown cause",
      .rows = "41",
      .formula = "r t",
      .parameters = {linear("rate", Quantity::PerHour, both(0.0, 20.0), both(0.0, 10.0))},
      .joints = JointChoice::Any,
      .sites = kEachWay | kLocation,
      .covariates = kTime,
      .lookalikes = {{"thermal_ambient", "over a morning both rise steadily", "a run at another time of day"},
                     {"thermal_head", "while the machine warms both only rise", "spindle on and off"},
                     {"wheel_wear", "passes follow each other in time", "dress the wheel in between"}},
      .action_limit = {1.0, 5.0},
      .shop_floor = {"Something warms, settles or creeps, and no sensor shows it.", "1 to 10 um/h.",
                     "Fit a sensor where the heat may come from and measure again; probe a datum "
                     "regularly."}};
}

}  // namespace

std::vector<EffectSpec> thermalSpecs() {
  return {thermalScrew(), thermalScale(), thermalHead(),      thermalAmbient(),
          coolant(),      thermalTilt(),  thermalWorkpiece(), drift()};
}

}  // namespace nineline::errors
