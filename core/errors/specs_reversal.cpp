#include "core/errors/effect_specs.h"
#include "core/errors/spec_parts.h"

namespace nineline::errors {

namespace {

EffectSpec backlash() {
  return {
      .id = "backlash",
      .title = "Backlash",
      .rows = "10, 35",
      .formula = "-(w/2) s; along a program a dead band of width w",
      .parameters = {linear("width", Quantity::Error, both(0.3, 100.0), both(0.2, 104.0))},
      .joints = JointChoice::Any,
      .covariates = kApproach,
      .lookalikes = {{"reversal_spike", "both show right after a reversal",
                      "let the axis stand after the reversal: a spike goes, play stays"},
                     {"hysteresis", "both differ by the sense of motion",
                      "sample from 0.01 to 50 mm after the reversal"},
                     {"lost_motion", "at one load they are the same", "repeat with another load"},
                     {"stylus_radius", "a wrong stylus radius reads as play",
                      "measure without the probe, or calibrate it"}},
      .action_limit = {0.5, 3.0},
      .shop_floor = {"Play in the nut, the coupling, the thrust bearing or the worm.",
                     "1 to 10 um on a ball screw, up to 50 on a worn one; 2 to 60 arcsec on a worm.",
                     "Check the axial play of the thrust bearing and the preload of the nut; set the worm "
                     "closer. What remains goes into the control's backlash value or is compensated."}};
}

EffectSpec lateralPlay() {
  return {
      .id = "lateral_play",
      .title = "Sideways play of a carriage",
      .rows = "15",
      .formula = "-(w/2) s, across the axis",
      .parameters = {linear("width", Quantity::Error, both(0.3, 30.0))},
      .sites = kLateral,
      .covariates = kApproach,
      .lookalikes = {{"angular_play", "at one arm both jump sideways", "measure at two arms"}},
      .action_limit = {0.5, 3.0},
      .shop_floor = {"The carriage changes sides in its guideway at each reversal: gib too loose, drive "
                     "beside the centre.",
                     "0.5 to 5 um.",
                     "Set the gib or the shoes' preload; check that the screw is parallel to the guideway."}};
}

EffectSpec angularPlay() {
  return {.id = "angular_play",
          .title = "Tilting play of a carriage",
          .rows = "16",
          .formula = "-(w/2) s, a rotation",
          .parameters = {linear("width", Quantity::Error, both(0.1, 100.0), both(0.1, 21.0))},
          .sites = kTilt,
          .covariates = kApproach,
          .lookalikes = {{"backlash", "at one arm both jump along the axis", "measure at two arms"},
                         {"lateral_play", "at one arm both jump sideways", "measure at two arms"}},
          .action_limit = {0.5, 2.0},
          .shop_floor = {"The drive pulls beside the carriage's centre and tips it to the other side at each "
                         "reversal.",
                         "0.2 to 5 arcsec.", "Set the gib or renew the shoes; check lubrication."}};
}

EffectSpec windup() {
  return {
      .id = "windup",
      .title = "Wind-up: play that grows along the travel",
      .rows = "11",
      .formula = "-(k q)/2 s",
      .parameters = {linear("k", Quantity::Ratio, both(0.0, 100.0))},
      .covariates = kApproach,
      .lookalikes = {{"backlash", "at one place they are the same", "measure at both ends of the travel"}},
      .action_limit = {0.5, 3.0},
      .shop_floor = {"The screw twists under friction; the free length between motor and nut grows.",
                     "1 to 20 um over a metre.",
                     "Reduce friction (gib, wipers, lubrication); a thicker screw or a linear scale helps "
                     "for good."}};
}

EffectSpec lostMotion() {
  return {
      .id = "lost_motion",
      .title = "Lost motion that grows with the load",
      .rows = "12",
      .formula = "-(kappa load)/2 s",
      .parameters = {linear("kappa", Quantity::PerLoad, both(0.0, 0.1))},
      .covariates = kApproach | kLoad,
      .lookalikes = {{"backlash", "at one load they are the same", "repeat with another load"}},
      .action_limit = {0.5, 3.0},
      .shop_floor = {"Friction grows with the load and stretches the drive before the table moves.",
                     "0.005 to 0.05 um/kg.", "Lubricate, check the guideways; stiffen the thrust bearing."}};
}

EffectSpec hysteresis() {
  return {
      .id = "hysteresis",
      .title = "Hysteresis with a long transition",
      .rows = "13",
      .formula = "-(w/2) s (1 - 2 exp(-d / length)), d the travel since the reversal",
      .parameters = {linear("width", Quantity::Error, both(0.3, 100.0), both(0.2, 104.0)),
                     searched("length", Quantity::Position, both(0.004, 150.0),
                              {0.05, 0.5, 3, 10, 20, 40, 80}, both(0.001, 60.0))},
      .joints = JointChoice::Any,
      .covariates = kApproach | kSinceReversal,
      .lookalikes = {{"backlash", "far from the reversal they are the same",
                      "sample from 0.01 to 50 mm after the reversal"},
                     {"reversal_spike", "both fade after the reversal", "stand still after the reversal"}},
      .action_limit = {0.5, 3.0},
      .shop_floor = {
          "Friction holds the carriage while drive, seals and cables stretch; the play is taken up "
          "over millimetres.",
          "1 to 20 um, over 0.1 to 50 mm.",
          "Look for a stiff wiper, hose or cable chain, a dry guideway, a soft coupling."}};
}

EffectSpec reversalSpike() {
  return {
      .id = "reversal_spike",
      .title = "Reversal spike, quadrant glitch",
      .rows = "14",
      .formula = "-h s exp(-d / length), while moving",
      .parameters = {linear("height", Quantity::Error, both(0.5, 50.0), both(0.2, 60.0)),
                     searched("length", Quantity::Position, both(0.3, 20.0), {0.5, 1, 2, 4, 8},
                              both(0.05, 20.0))},
      .joints = JointChoice::Any,
      .covariates = kApproach | kSinceReversal,
      .lookalikes = {{"backlash", "both show right after a reversal",
                      "let the axis stand after the reversal: a spike goes, play stays"},
                     {"friction_speed", "both appear near standstill", "two feeds"}},
      .action_limit = {1.0, 4.0},
      .shop_floor = {"Static friction at standstill: the axis hangs until the controller has built up force.",
                     "1 to 15 um on circles at the quadrants.",
                     "Switch on or tune the control's friction compensation; oil the guideway."}};
}

EffectSpec frictionSpeed() {
  return {.id = "friction_speed",
          .title = "Friction that falls with the speed",
          .rows = "19",
          .formula = "-s (w/2 + h exp(-(v / v_s)^2))",
          .parameters = {[] {
                           ParameterSpec width = linear("width", Quantity::Error, both(0.0, 50.0));
                           width.otherwise = 0.0;
                           return width;
                         }(),
                         linear("height", Quantity::Error, both(0.3, 50.0), both(0.2, 60.0)),
                         searched("speed", Quantity::Speed, both(0.1, 20.0), {0.3, 1, 3, 10})},
          .covariates = kApproach | kVelocity,
          .lookalikes = {{"reversal_spike", "both appear near standstill", "two feeds"},
                         {"backlash", "at one feed they are the same", "two feeds"}},
          .action_limit = {0.5, 3.0},
          .shop_floor = {"Oil film on a sliding guideway: sticky when slow, floating when fast.",
                         "1 to 10 um below 5 mm/s.",
                         "Use slideway oil of the right grade; raise the controller's integral gain; avoid "
                         "creeping feeds."}};
}

}  // namespace

std::vector<EffectSpec> reversalSpecs() {
  return {backlash(),   lateralPlay(), angularPlay(),   windup(),
          lostMotion(), hysteresis(),  reversalSpike(), frictionSpeed()};
}

}  // namespace nineline::errors
