#include "core/errors/effect_specs.h"
#include "core/errors/spec_parts.h"

namespace nineline::errors {

namespace {

EffectSpec servoLag() {
  return {.id = "servo_lag",
          .title = "Servo lag, mismatched gains",
          .rows = "17",
          .formula = "-tau v",
          .parameters = {linear("tau", Quantity::Delay, both(0.0, 2.0))},
          .covariates = kVelocity,
          .lookalikes = {{"location", "both turn a circle into an ellipse at 45 degrees",
                          "the other sense of rotation and another feed: lag follows both"},
                         {"time_shift", "a late clock of the instrument delays all axes alike",
                          "move in steps and hold before reading"}},
          .action_limit = {1.0, 5.0},
          .shop_floor = {"One axis follows its command later than the others.",
                         "0.05 to 1 ms of difference: 1 to 15 um at 1 m/min.",
                         "Set equal position gains and feed-forward on all axes of the path."}};
}

EffectSpec acceleration() {
  return {
      .id = "acceleration",
      .title = "Yielding under acceleration, contraction of circles",
      .rows = "18",
      .formula = "k a",
      .parameters = {linear("k", Quantity::PerAcceleration, both(0.0, 1000.0))},
      .covariates = kAcceleration,
      .lookalikes = {{"scale", "on circles at one feed both change the radius", "two feeds"}},
      .action_limit = {1.0, 5.0},
      .shop_floor = {"The drive yields under inertia, or the control's smoothing cuts corners and shrinks "
                     "circles.",
                     "1 to 100 um at 1 m/s2.",
                     "Lower jerk and acceleration for finishing, tune acceleration feed-forward."}};
}

EffectSpec syncDelay() {
  return {
      .id = "sync_delay",
      .title = "Rotary axis late against the linear ones",
      .rows = "36",
      .formula = "-tau v, of one joint against the others",
      .parameters = {linear("tau", Quantity::Delay, both(0.0, 5.0))},
      .joints = JointChoice::Rotary,
      .covariates = kVelocity,
      .lookalikes = {{"location", "at one speed a late C is a constant angle", "two speeds, both senses"},
                     {"time_shift", "a late clock of the instrument", "move in steps and hold"}},
      .action_limit = {0.3, 1.0},
      .shop_floor = {"Work spindle and slide are coupled with a delay: the thread starts late by an angle "
                     "that grows with the speed.",
                     "0.1 to 3 ms.",
                     "Set the coupling's dead time or the gains alike; cut at one speed throughout."}};
}

EffectSpec vibration() {
  return {.id = "vibration",
          .title = "Vibration",
          .rows = "61",
          .formula = "a sin(2 pi f t + phase)",
          .parameters = {amplitude(both(0.05, 20.0), both(0.02, 10.0)),
                         searched("frequency", Quantity::Frequency, both(0.01, 500.0), {}), phase()},
          .joints = JointChoice::Any,
          .covariates = kTime,
          .lookalikes = {{"cyclic", "at one feed a wave in time is a wave along the path", "two feeds"}},
          .action_limit = {0.3, 1.0},
          .shop_floor = {"An unbalanced wheel, a pump, a hydraulic unit or the floor.", "0.1 to 5 um.",
                         "Balance the wheel; find the source by switching units off one by one. Vibration is "
                         "not compensated by a program."}};
}

}  // namespace

std::vector<EffectSpec> dynamicSpecs() { return {servoLag(), acceleration(), syncDelay(), vibration()}; }

}  // namespace nineline::errors
