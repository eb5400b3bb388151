#include "core/errors/effect_specs.h"

namespace nineline::errors {

namespace {

EffectSpec thermalScrew() {
  EffectSpec spec;
  spec.id = "thermal_screw";
  spec.title = "Growth of the ball screw";
  spec.rows = "6-8";
  spec.formula = "k (T - 20)(q - q_fixed)";
  spec.parameters = {{.name = "k", .quantity = Quantity::Growth, .linear = {{-20.0, 20.0}, {-20.0, 20.0}}},
                     {.name = "q_fixed",
                      .quantity = Quantity::Position,
                      .role = Role::NonLinear,
                      .linear = {{-0.3, 1.3}, {-0.3, 1.3}},
                      .starts = {0.0, 0.5, 1.0},
                      .of_travel = true,
                      .otherwise = 0.0},
                     {.name = "preload",
                      .quantity = Quantity::Temperature,
                      .role = Role::NonLinear,
                      .linear = {{22.0, 40.0}, {22.0, 40.0}},
                      .starts = {24.0, 28.0, 32.0},
                      .optional = true}};
  spec.joints = JointChoice::Linear;
  spec.sites = kOwn;
  spec.sensors = 1;
  spec.standard_sensor = "temp_screw_{}_C";
  spec.lookalikes = {{"scale", "at one temperature both grow with the travel",
                      "needs a run at another temperature, 3 C apart or more"},
                     {"material_temperature", "a wrong material temperature in the laser scales with it",
                      "a second instrument on the axis; screw warm while the material is cool"},
                     {"thermal_scale", "both grow with a temperature", "sensors on screw and scale apart"}};
  spec.action_limit = {1.0, 3.0};
  spec.shop_floor = {"The screw warms by friction in nut and bearings and grows away from its fixed bearing.",
                     "9 to 12 um per metre and degree; 5 to 30 um in the first hour of work.",
                     "Warm the axis up before measuring, cool or stretch the screw, fit a glass scale; or "
                     "compensate by a sensor near the nut."};
  return spec;
}

}  // namespace

std::vector<EffectSpec> thermalSpecs() { return {thermalScrew()}; }

}  // namespace nineline::errors
