#include "core/errors/effect_specs.h"
#include "core/errors/spec_parts.h"

namespace nineline::errors {

namespace {

EffectSpec table() {
  return {.id = "table",
          .title = "Error table",
          .rows = "-",
          .formula = "E(q), interpolated between measured values",
          .joints = JointChoice::Any,
          .sites = 0,
          .shop_floor = {"Everything that was measured of an axis at given positions.", "Whatever was found.",
                         "Nothing to repair: the table is compensated. Measure anew after a repair or a "
                         "crash."}};
}

EffectSpec location() {
  return {
      .id = "location",
      .title = "Squareness, parallelism or offset of an axis",
      .rows = "25-27",
      .formula = "a constant small turn or shift of the joint's place",
      .parameters = {linear("value", Quantity::Error, both(0.0, 1000.0), both(0.0, 62.0))},
      .joints = JointChoice::Any,
      .sites = kLocation,
      .lookalikes = {{"servo_lag", "both turn a circle into an ellipse at 45 degrees",
                      "run the circle at two feeds and in both senses: squareness follows neither"},
                     {"angular", "over a short travel a tilting carriage looks like a skewed axis",
                      "measure at two distances from the guideway"}},
      .action_limit = {0.5, 3.0},
      .shop_floor = {"Guideways or an axis of rotation were not set square or in line, or the bed has moved "
                     "on its feet.",
                     "2 to 40 arcsec, on new precision machines below 4; offsets up to 0.1 mm.",
                     "Level the bed first; then align column or head by its set screws or by scraping. "
                     "What remains is compensated."}};
}

EffectSpec scale() {
  return {
      .id = "scale",
      .title = "Scale error",
      .rows = "1",
      .formula = "k q",
      .parameters = {linear("k", Quantity::Ratio, both(0.0, 100.0))},
      .lookalikes = {{"cosine", "a skewed laser beam reads short in proportion to the travel",
                      "a second instrument on the axis, or the laser aligned anew; cosine only shortens"},
                     {"material_temperature", "a wrong expansion set in the laser scales its readings",
                      "a second instrument on the axis"},
                     {"thermal_screw", "a warm screw is longer in proportion to the travel",
                      "needs a run at another screw temperature, 3 C apart or more"},
                     {"angular",
                      "a tilt growing along the travel moves a point beside the guideway in "
                      "proportion",
                      "measure at two distances from the guideway"}},
      .action_limit = {1.0, 3.0},
      .shop_floor = {"The lead of the screw or the division of the scale differs from the nominal one, or "
                     "the control holds a wrong factor.",
                     "5 to 50 um/m.",
                     "Correct the factor or the pitch table of the control; otherwise compensate."}};
}

EffectSpec cyclic() {
  return {.id = "cyclic",
          .title = "Periodic error of screw, worm, gear or rack",
          .rows = "2-4, 34",
          .formula = "a sin(2 pi q / P + phase)",
          .parameters = {amplitude(both(0.1, 15.0), both(0.2, 21.0)),
                         searched("period", Quantity::Position, both(0.5, 200.0),
                                  {2, 2.5, 4, 5, 6, 8, 10, 12, 16, 20, 25, 32, 40, 50}, both(1.0, 180.0)),
                         phase()},
          .joints = JointChoice::Any,
          .lookalikes = {{"encoder_subdivision", "both are waves of one short period",
                          "the period: a grating's is a fraction of a millimetre, a screw's its lead"},
                         {"axial_runout", "on a thread both repeat once a turn where lead and screw agree",
                          "another lead, or the start of the thread shifted along Z"}},
          .action_limit = {0.3, 1.0},
          .shop_floor = {"The screw runs out in its bearings or was cut with a periodic lead error; a worm, "
                         "gear or coupling runs out.",
                         "0.5 to 10 um, once or twice a turn of the screw.",
                         "Check bearing seat, nut alignment and coupling for run-out; replace a worn screw. "
                         "What remains is compensated."}};
}

EffectSpec straightness() {
  return {.id = "straightness",
          .title = "Bow or S-shape of a guideway",
          .rows = "20-22",
          .formula = "a p(x), x = -1...1 over the travel; shape 2: x^2 - 1/3, 3: x^3 - 0.6 x, 4-6: Legendre",
          .parameters = {linear("amplitude", Quantity::Error, both(0.2, 50.0)),
                         choice("shape", {2, 3, 4, 5, 6}, 2.0)},
          .sites = kLateral,
          .lookalikes = {{"angular", "a carriage on a bowed guideway also tilts in proportion",
                          "measure at two distances from the guideway; the two have one cause"},
                         {"sag", "both bend over the travel", "change the mass that is carried"}},
          .action_limit = {0.5, 3.0},
          .shop_floor = {"The guideway was ground or has settled with a bow; the bed is not level or was "
                         "clamped under stress.",
                         "1 to 20 um over the travel.",
                         "Level the bed and loosen foundation bolts that pull; then scrape or shim the rail. "
                         "What remains is compensated."}};
}

EffectSpec angular() {
  return {
      .id = "angular",
      .title = "Pitch, yaw or roll of a carriage",
      .rows = "23",
      .formula = "a p(x), x = -1...1 over the travel; shape 1: x, 2: x^2 - 1/3, 3: x^3 - 0.6 x",
      .parameters = {linear("amplitude", Quantity::Error, both(0.1, 200.0), both(0.1, 42.0)),
                     choice("shape", {1, 2, 3, 4, 5, 6}, 1.0)},
      .sites = kTilt,
      .lookalikes = {{"straightness", "a tilt shows at one arm as a bow", "two arms"},
                     {"scale", "at one height a growing pitch reads as a scale error",
                      "two heights above the guideway, both directions"},
                     {"angular_play", "both act through the arm", "approach from both directions"}},
      .action_limit = {0.5, 2.0},
      .shop_floor = {"A bowed or twisted guideway tilts the carriage as it travels; through its arm the "
                     "tilt becomes an error at the tool.",
                     "1 to 15 arcsec.",
                     "Level the bed, check gib and shoe clearance; shorten the arm between scale and work. "
                     "What remains is compensated."}};
}

EffectSpec periodicTilt() {
  return {
      .id = "periodic_tilt",
      .title = "Periodic tilt of a carriage",
      .rows = "24",
      .formula = "a sin(2 pi q / P + phase), a rotation",
      .parameters = {amplitude(both(0.1, 20.0), both(0.1, 4.2)),
                     searched("period", Quantity::Position, both(0.5, 200.0),
                              {4, 5, 8, 10, 16, 20, 32, 40, 60}, both(1.0, 180.0)),
                     phase()},
      .sites = kTilt,
      .lookalikes = {{"cyclic", "at one arm both are waves of the screw's period", "two arms"}},
      .action_limit = {0.3, 1.0},
      .shop_floor = {"Balls or rollers entering a guideway shoe, or a bent screw that pushes the carriage "
                     "sideways once a turn.",
                     "0.2 to 3 arcsec.",
                     "Check the screw for run-out and the nut's mounting; renew guideway shoes."}};
}

}  // namespace

std::vector<EffectSpec> positionSpecs() {
  return {table(), location(), scale(), cyclic(), straightness(), angular(), periodicTilt()};
}

}  // namespace nineline::errors
