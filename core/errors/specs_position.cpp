#include "core/errors/effect_specs.h"

namespace nineline::errors {

namespace {

constexpr Bounds kTurnOfPhase{-180.0, 180.0};

ParameterSpec phase() {
  ParameterSpec one{.name = "phase", .quantity = Quantity::Phase, .role = Role::Phase};
  one.linear = {kTurnOfPhase, kTurnOfPhase};
  one.otherwise = 0.0;
  return one;
}

EffectSpec table() {
  EffectSpec spec;
  spec.id = "table";
  spec.title = "Error table";
  spec.rows = "-";
  spec.formula = "E(q), interpolated between measured values";
  spec.joints = JointChoice::Any;
  spec.sites = 0;
  spec.shop_floor = {"Everything that was measured of an axis at given positions.", "Whatever was measured.",
                     "None needed: the table is compensated. Measure again after repairs or crashes."};
  return spec;
}

EffectSpec location() {
  EffectSpec spec;
  spec.id = "location";
  spec.title = "Squareness, parallelism or offset of an axis";
  spec.rows = "25-27";
  spec.formula = "a constant small rotation or shift of the joint's place";
  spec.parameters = {{.name = "value",
                      .linear = {{-60.0, 60.0}, {-200.0, 200.0}},
                      .arc = Plausible{{-60.0, 60.0}, {-60.0, 60.0}}}};
  spec.joints = JointChoice::Any;
  spec.sites = kLocation;
  spec.lookalikes = {
      {"servo_lag", "both turn a circle into an ellipse at 45 degrees",
       "run the circle at two feeds in both senses: squareness changes with neither"},
      {"angular", "over a short travel a tilting carriage leans like a skewed axis", "measure at two arms"}};
  spec.action_limit = {0.5, 3.0};
  spec.shop_floor = {
      "The guideways or the axis of rotation were not set square, or the bed has moved on its "
      "feet.",
      "2 to 40 arcsec; new precision machines below 4.",
      "Level the bed first, then align head or column by its set screws or by scraping; "
      "otherwise compensate."};
  return spec;
}

EffectSpec scale() {
  EffectSpec spec;
  spec.id = "scale";
  spec.title = "Scale error";
  spec.rows = "1";
  spec.formula = "k q";
  spec.parameters = {
      {.name = "k", .quantity = Quantity::Ratio, .linear = {{-100.0, 100.0}, {-100.0, 100.0}}}};
  spec.joints = JointChoice::Linear;
  spec.lookalikes = {
      {"cosine", "a skewed laser beam reads short in proportion to the travel",
       "a second instrument on the axis, or the laser aligned anew; cosine only ever shortens"},
      {"material_temperature", "a wrong expansion entered in the laser scales its readings",
       "a second instrument on the axis"},
      {"thermal_screw", "a warm screw is longer in proportion to the travel",
       "two runs with screw temperatures 3 C or more apart"},
      {"angular", "a tilt growing along the travel shifts a point beside the guideway in proportion",
       "measure at two distances from the guideway"}};
  spec.action_limit = {1.0, 3.0};
  spec.shop_floor = {
      "The lead of the screw or the division of the scale differs from the nominal one, or the "
      "control holds a wrong factor.",
      "5 to 50 um/m.", "Enter the factor in the control's pitch compensation, or compensate."};
  return spec;
}

EffectSpec cyclic() {
  EffectSpec spec;
  spec.id = "cyclic";
  spec.title = "Periodic error of screw, worm, gear or rack";
  spec.rows = "2-4, 34";
  spec.formula = "a sin(2 pi q / P + phase)";
  spec.parameters = {{.name = "amplitude",
                      .role = Role::Amplitude,
                      .linear = {{0.1, 15.0}, {0.1, 15.0}},
                      .arc = Plausible{{0.2, 20.0}, {0.2, 20.0}}},
                     {.name = "period",
                      .quantity = Quantity::Position,
                      .role = Role::NonLinear,
                      .linear = {{0.5, 200.0}, {0.5, 200.0}},
                      .arc = Plausible{{1.0, 180.0}, {1.0, 180.0}},
                      .starts = {2, 2.5, 4, 5, 6, 8, 10, 12, 16, 20, 25, 32, 40, 50}},
                     phase()};
  spec.joints = JointChoice::Any;
  spec.sites = kOwn;
  spec.lookalikes = {{"encoder_subdivision", "both are waves of one short period",
                      "the period: a grating's is a fraction of a millimetre, a screw's its lead"},
                     {"axial_runout", "on a thread both repeat once a turn where lead and screw agree",
                      "another lead, or the start of the thread shifted along Z"}};
  spec.action_limit = {0.3, 1.0};
  spec.shop_floor = {
      "The screw wobbles in its bearings or was cut with a periodic lead error; a worm or gear "
      "runs out.",
      "0.5 to 10 um, once or twice a turn of the screw.",
      "Check the bearing seat and coupling for run-out; a worn screw is replaced; what remains "
      "is compensated."};
  return spec;
}

}  // namespace

std::vector<EffectSpec> positionSpecs() { return {table(), location(), scale(), cyclic()}; }

}  // namespace nineline::errors
