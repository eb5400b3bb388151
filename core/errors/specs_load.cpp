#include "core/errors/effect_specs.h"
#include "core/errors/spec_parts.h"

namespace nineline::errors {

namespace {

EffectSpec sag() {
  return {.id = "sag",
          .title = "Sag of a ram or slide",
          .rows = "50",
          .formula = "-k ((q - q_ref)/1000)^2; power 3: cubed (k in um at 1 m)",
          .parameters = {linear("k", Quantity::PerArea, both(0.0, 500.0)), place("q_ref", {0.0, 1.0}, 0.0),
                         choice("power", {2, 3}, 2.0)},
          .sites = kLateral,
          .lookalikes = {{"straightness", "both bend over the travel", "change the mass that is carried"},
                         {"angular", "the ram also tilts", "measure at two arms"}},
          .action_limit = {1.0, 5.0},
          .shop_floor = {"A ram, quill or cross slide bends under its weight the further it reaches out.",
                         "5 to 50 um at full reach.",
                         "Work with less overhang; set the counterweight or hydraulic support; compensate."}};
}

EffectSpec loadDeformation() {
  return {
      .id = "load_deformation",
      .title = "Sinking under the load",
      .kind = EffectKind::Process,
      .rows = "51",
      .formula = "k load",
      .parameters = {linear("k", Quantity::PerLoad, both(0.0, 0.2))},
      .joints = JointChoice::Any,
      .sites = kEachWay | kLocation,
      .covariates = kLoad,
      .lookalikes = {{"load_tilt", "at one place both move the work", "measure at both ends of the table"}},
      .action_limit = {1.0, 5.0},
      .shop_floor = {"Bed, guideway and feet give way under part and fixture.", "0.01 to 0.1 um/kg.",
                     "Set up feet and foundation; state the load and compensate."}};
}

EffectSpec loadTilt() {
  return {.id = "load_tilt",
          .title = "Tilting under the load",
          .kind = EffectKind::Process,
          .rows = "51",
          .formula = "k load, a rotation",
          .parameters = {linear("k", Quantity::PerLoad, both(0.0, 1.0), both(0.0, 0.1))},
          .joints = JointChoice::Any,
          .sites = kTilt | kLocation,
          .covariates = kLoad,
          .lookalikes = {{"load_deformation", "at one place both move the work",
                          "measure at both ends of the table"},
                         {"angular", "at one load the same tilt", "repeat with another load"}},
          .action_limit = {1.0, 5.0},
          .shop_floor = {"The part stands beside the table's centre and tips it.", "0.002 to 0.05 arcsec/kg.",
                         "Set the part over the guideways; state the load and compensate."}};
}

EffectSpec counterweight() {
  ParameterSpec width = linear("width", Quantity::Error, both(0.0, 50.0));
  ParameterSpec k = linear("k", Quantity::PerSpeed, both(0.0, 20.0));
  width.otherwise = k.otherwise = 0.0;
  return {
      .id = "counterweight",
      .title = "Counterweight of a vertical axis",
      .rows = "52",
      .formula = "-(w/2) s + k v",
      .parameters = {width, k},
      .covariates = kApproach | kVelocity,
      .lookalikes = {{"backlash", "at one feed they are the same", "two feeds"},
                     {"servo_lag", "both grow with the speed", "move in steps and hold"}},
      .action_limit = {1.0, 3.0},
      .shop_floor = {"Chain, cylinder or accumulator of the weight compensation pulls unevenly up and down.",
                     "1 to 15 um.", "Check pressure and valves of the cylinder, chain and pulleys."}};
}

EffectSpec wheelWear() {
  return {
      .id = "wheel_wear",
      .title = "Wear of the wheel",
      .kind = EffectKind::Process,
      .rows = "43, 44",
      .formula = "r n; with passes: r passes (1 - exp(-n / passes)), n the pass since dressing",
      .parameters = {linear("rate", Quantity::PerPass, both(0.01, 5.0)),
                     optional(searched("passes", Quantity::Number, both(0.5, 20.0), {1.5, 2.5, 4, 6.5, 12}))},
      .covariates = kPass,
      .lookalikes = {{"wheel_deflection", "later passes also take more force",
                      "vary the infeed at the same number of passes"},
                     {"thermal_workpiece", "both grow from part to part", "measure after cooling down"},
                     {"drift", "passes follow each other in time", "dress between parts"}},
      .action_limit = {0.5, 2.0},
      .shop_floor = {"The wheel loses grain and becomes smaller from pass to pass until it is dressed.",
                     "0.1 to 2 um a pass.",
                     "Dress more often, harder wheel; compensate by the pass number."}};
}

EffectSpec wheelDeflection() {
  return {.id = "wheel_deflection",
          .title = "Wheel and work give way",
          .kind = EffectKind::Process,
          .rows = "45",
          .formula = "k feed (or k times a force)",
          .parameters = {linear("k", Quantity::PerSpeed, both(0.0, 50.0))},
          .covariates = kFeed,
          .sensors = 1,
          .standard_sensor = "feed_mm_min",
          .lookalikes = {{"wheel_wear", "a worn wheel presses harder",
                          "vary the infeed at the same number of passes"}},
          .action_limit = {0.5, 2.0},
          .shop_floor = {"The grinding force pushes wheel spindle and work apart.", "1 to 20 um.",
                         "Smaller infeed, spark out, support the work by a steady rest."}};
}

EffectSpec sparkOut() {
  return {.id = "spark_out",
          .title = "Remainder after sparking out",
          .kind = EffectKind::Process,
          .rows = "47",
          .formula = "k feed exp(-n / passes)",
          .parameters = {linear("k", Quantity::PerSpeed, both(0.0, 50.0)),
                         searched("passes", Quantity::Number, both(0.3, 5.0), {0.5, 1, 2, 4})},
          .covariates = kPass | kFeed,
          .sensors = 1,
          .standard_sensor = "feed_mm_min",
          .lookalikes = {{"wheel_deflection", "after the same passes they are the same",
                          "vary the number of passes without infeed"}},
          .action_limit = {0.5, 2.0},
          .shop_floor = {"The spring of wheel and work has not yet relaxed when grinding ends.",
                         "0.5 to 5 um.", "More passes without infeed."}};
}

EffectSpec workpieceBending() {
  return {
      .id = "workpiece_bending",
      .title = "Bending of the work between centres",
      .kind = EffectKind::Process,
      .rows = "46",
      .formula = "k load 16 z^2 (1 - z)^2, z = 0...1 between the centres",
      .parameters = {linear("k", Quantity::PerLoad, both(0.0, 2.0))},
      .sites = kLateral,
      .covariates = kLoad,
      .lookalikes = {{"straightness", "both bow along the work",
                      "measure with another load, or without work"}},
      .action_limit = {0.5, 2.0},
      .shop_floor = {"A slender part bends between the centres under force or weight: thick in the middle.",
                     "1 to 30 um.", "Steady rest in the middle, smaller infeed, spark out."}};
}

EffectSpec clamping() {
  const ParameterSpec reference{.name = "q_ref",
                                .quantity = Quantity::Length,
                                .role = Role::Given,
                                .linear = both(-10000.0, 10000.0),
                                .otherwise = 0.0};
  return {
      .id = "clamping",
      .title = "Distortion by a three-jaw chuck",
      .kind = EffectKind::Process,
      .rows = "49",
      .formula =
          "EX: a cos(3 C + phase) exp(-z / length), EY: a sin(3 C + phase) exp(-z / length), z from q_ref",
      .parameters = {amplitude(both(0.1, 20.0)),
                     searched("length", Quantity::Length, both(5.0, 100.0), {10, 20, 40, 80}), phase(),
                     reference},
      .joints = JointChoice::Rotary,
      .sites = kRadialPair,
      .lookalikes = {{"lobing", "both have three lobes",
                      "turn the part by 60 degrees; measure at two distances"},
                     {"probe_lobing", "a touch probe reads three lobes on a perfect ring", "turn the probe"}},
      .action_limit = {0.5, 2.0},
      .shop_floor = {"Three jaws press a thin part out of round; less so away from the chuck.",
                     "0.5 to 10 um.",
                     "Clamp more gently, use a collet or soft jaws, grind between centres."}};
}

}  // namespace

std::vector<EffectSpec> loadSpecs() {
  return {sag(),      loadDeformation(),  loadTilt(), counterweight(), wheelWear(), wheelDeflection(),
          sparkOut(), workpieceBending(), clamping()};
}

}  // namespace nineline::errors
