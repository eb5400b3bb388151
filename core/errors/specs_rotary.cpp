#include "core/errors/effect_specs.h"
#include "core/errors/spec_parts.h"

namespace nineline::errors {

namespace {

EffectSpec eccentricity() {
  return {
      .id = "eccentricity",
      .title = "Eccentricity of a rotary axis",
      .rows = "28",
      .formula = "EX: a cos(C + phase), EY: a sin(C + phase)",
      .parameters = {amplitude(both(0.1, 50.0)), choice("n", {1}, 1.0), phase()},
      .joints = JointChoice::Rotary,
      .sites = kRadialPair,
      .lookalikes = {{"wobble", "at one distance from the head both are once a turn",
                      "measure at two distances, 1 : 3 or more"},
                     {"encoder_eccentricity", "both repeat once a turn",
                      "a face measurement, or two leads: the encoder scales with the lead"}},
      .action_limit = {0.3, 2.0},
      .shop_floor = {"The spindle's nose, a centre or the chuck sits beside the axis of rotation; a bearing "
                     "ring was mounted off centre.",
                     "1 to 20 um; good spindles below 1.",
                     "Clean and indicate the nose, turn the chuck by half a turn and compare; regrind the "
                     "centre in place."}};
}

EffectSpec lobing() {
  return {.id = "lobing",
          .title = "Two-, three- or more-lobed run-out",
          .rows = "30",
          .formula = "EX: a cos(n C + phase), EY: a sin(n C + phase), n = 2, 3, ...",
          .parameters = {amplitude(both(0.05, 10.0)), choice("n", {2, 3, 4}), phase()},
          .joints = JointChoice::Rotary,
          .sites = kRadialPair,
          .lookalikes = {{"probe_lobing", "a touch probe reads three lobes on a perfect ring",
                          "turn the probe by 60 degrees"},
                         {"clamping", "a part clamped in three jaws has three lobes",
                          "turn the part in the chuck by 60 degrees, or measure at two distances"}},
          .action_limit = {0.2, 1.0},
          .shop_floor = {
              "A bearing seat or ring is out of round, or the ring is pinched by its screws.", "0.1 to 3 um.",
              "Loosen and retighten the bearing's clamping crosswise; check the seat's roundness."}};
}

EffectSpec wobble() {
  return {
      .id = "wobble",
      .title = "Wobble of a rotary axis",
      .rows = "29",
      .formula = "EA: a cos(C + phase), EB: a sin(C + phase)",
      .parameters = {amplitude(both(0.1, 21.0)), phase()},
      .joints = JointChoice::Rotary,
      .sites = kTiltPair,
      .lookalikes = {{"eccentricity", "at one distance from the head both are once a turn",
                      "measure at two distances, 1 : 3 or more"}},
      .action_limit = {0.3, 2.0},
      .shop_floor = {"The body is mounted askew on the spindle, or the bearings' shoulders are not square "
                     "to the axis: the tilt turns with the work.",
                     "0.5 to 10 arcsec.",
                     "Clean the faces, look for chips; regrind the face plate on the machine."}};
}

EffectSpec axialRunout() {
  return {.id = "axial_runout",
          .title = "Axial run-out, camming",
          .rows = "31",
          .formula = "EZ: a sin(C + phase), along the axis",
          .parameters = {amplitude(both(0.05, 10.0)), phase()},
          .joints = JointChoice::Rotary,
          .sites = kAxial,
          .lookalikes = {{"encoder_eccentricity", "both make a drunken thread",
                          "two leads, or a measurement on the face: there is no lead on a face"},
                         {"cyclic", "on a thread both repeat once a turn where lead and screw agree",
                          "another lead, or the start shifted along Z"}},
          .action_limit = {0.2, 1.0},
          .shop_floor = {"The thrust bearing's face is not square to the axis: the spindle moves to and fro "
                         "once a turn and the thread is drunken.",
                         "0.2 to 3 um.",
                         "Check shoulder and spacer rings for parallelism; renew the thrust bearing."}};
}

EffectSpec encoderEccentricity() {
  return {
      .id = "encoder_eccentricity",
      .title = "Eccentric encoder disc",
      .rows = "32",
      .formula = "positioning: a sin(n C + phase), n = 1",
      .parameters = {amplitude(both(0.1, 50.0), both(0.2, 42.0)), choice("n", {1}, 1.0), phase()},
      .joints = JointChoice::Rotary,
      .lookalikes = {{"axial_runout", "both make a drunken thread", "two leads, or a face measurement"},
                     {"cyclic", "a worm with one start a turn of the table is the same wave",
                      "the worm's period"}},
      .action_limit = {0.2, 1.0},
      .shop_floor = {"The encoder's disc sits beside the axis: it reads the angle once a turn too far and "
                     "once too short.",
                     "1 to 20 arcsec; 1 um of eccentricity at 50 mm radius is 4 arcsec.",
                     "Centre the disc, or fit a second reading head opposite the first."}};
}

EffectSpec encoderSubdivision() {
  ParameterSpec lines = optional(choice("n", {18, 24, 32, 36, 48, 64, 72, 90, 128, 180, 256, 360}));
  lines.joints = JointChoice::Rotary;
  ParameterSpec period = optional(searched("period", Quantity::Position, both(0.001, 2.0),
                                           {0.02, 0.04, 0.1, 0.2, 1.0, 2.0}, both(0.01, 20.0)));
  period.joints = JointChoice::Linear;
  return {
      .id = "encoder_subdivision",
      .title = "Interpolation error of a scale or encoder",
      .rows = "5, 33",
      .formula =
          "positioning: a sin(n C + phase) or a sin(2 pi q / P + phase), n, P: the division, its "
          "half and its quarter",
      .parameters = {amplitude(both(0.02, 1.0), both(0.04, 4.2)), lines, period, phase()},
      .joints = JointChoice::Any,
      .lookalikes = {{"cyclic", "both are waves of one short period", "the period"}},
      .action_limit = {0.1, 0.5},
      .shop_floor = {"Signals of the reading head are unequal or not square to each other, mostly by dirt "
                     "or a wrong gap.",
                     "0.05 to 0.5 um; 0.1 to 2 arcsec.",
                     "Clean scale and head, set the gap, adjust signals with the maker's instrument."}};
}

}  // namespace

std::vector<EffectSpec> rotarySpecs() {
  return {eccentricity(), lobing(), wobble(), axialRunout(), encoderEccentricity(), encoderSubdivision()};
}

}  // namespace nineline::errors
