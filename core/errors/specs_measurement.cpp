#include "core/errors/effect_specs.h"
#include "core/errors/spec_parts.h"

namespace nineline::errors {

namespace {

EffectSpec cosine() {
  ParameterSpec k = linear("k", Quantity::Ratio, both(0.0, 12.5));
  k.sign = 1;
  return {.id = "cosine",
          .title = "Laser beam not parallel to the axis",
          .kind = EffectKind::Measurement,
          .rows = "53",
          .formula = "-k (q - q_start), k = theta^2 / 2",
          .parameters = {k},
          .lookalikes = {{"scale", "both grow with the travel",
                          "align the laser anew; cosine only ever shortens"}},
          .action_limit = {0.5, 0.5},
          .shop_floor = {"The beam runs at an angle to the travel, so the laser reads short.",
                         "1 mm off over 1 m: 0.5 um/m.",
                         "Align by the drift of the spot; no fault of the machine."}};
}

EffectSpec deadPath() {
  return {
      .id = "dead_path",
      .title = "Dead path of the laser",
      .kind = EffectKind::Measurement,
      .rows = "54",
      .formula = "k (0.93 dT - 0.27 dp) 1e-6, changes of air temperature (C) and pressure (hPa) in the run",
      .parameters = {linear("k", Quantity::Length, both(0.0, 2000.0))},
      .sensors = 2,
      .standard_sensor = "temp_air_C",
      .lookalikes = {{"drift", "air changes slowly", "interferometer close to the reflector at zero"}},
      .action_limit = {0.3, 0.3},
      .shop_floor = {"Air between interferometer and zero position is not corrected when it warms.",
                     "1 um per metre and degree.", "Set the interferometer close to the zero position."}};
}

EffectSpec materialTemperature() {
  return {.id = "material_temperature",
          .title = "Wrong material temperature or expansion in the laser",
          .kind = EffectKind::Measurement,
          .rows = "55",
          .formula = "k (T - 20)(q - q_start)",
          .parameters = {linear("k", Quantity::Growth, both(0.0, 15.0))},
          .sensors = 1,
          .standard_sensor = "temp_material_C",
          .lookalikes = {{"thermal_screw", "both grow with travel and temperature",
                          "a second instrument; screw warm while the material is cool"},
                         {"scale", "at one temperature both grow with the travel", "a second instrument"}},
          .action_limit = {0.5, 0.5},
          .shop_floor = {"The laser's material sensor fell off, hangs in the air, or the expansion was typed "
                         "wrong.",
                         "up to 12 um per metre and degree.",
                         "Put the sensor on the scale or screw; check the "
                         "coefficient."}};
}

EffectSpec airWavelength() {
  return {
      .id = "air_wavelength",
      .title = "Wavelength in air not corrected",
      .kind = EffectKind::Measurement,
      .rows = "56",
      .formula = "k (q - q_start)(0.93 (T - 20) - 0.27 (p - 1013.25)) 1e-6; k = 1: no correction at all",
      .parameters = {linear("k", Quantity::Number, both(0.0, 1.5))},
      .sensors = 2,
      .standard_sensor = "temp_air_C",
      .lookalikes = {{"scale", "in one air both grow with the travel", "repeat in other air, or correct it"}},
      .action_limit = {0.5, 0.5},
      .shop_floor = {"The laser's weather station is off or its sensors are wrong.",
                     "1 um/m per degree or per 3.7 hPa.", "Switch it on; enter the pressure by hand."}};
}

EffectSpec probeLobing() {
  return {.id = "probe_lobing",
          .title = "Lobing of a touch probe",
          .kind = EffectKind::Measurement,
          .rows = "57",
          .formula = "a cos(3 theta + phase), theta the direction of approach",
          .parameters = {amplitude(both(0.1, 8.0)), phase()},
          .lookalikes = {{"lobing", "a three-lobed bearing", "turn the probe by 60 degrees"},
                         {"clamping", "a part clamped in three jaws", "turn the probe by 60 degrees"}},
          .action_limit = {0.3, 0.3},
          .shop_floor = {"A probe on three contacts triggers sooner in three directions.", "0.2 to 3 um.",
                         "Calibrate by direction, shorter stylus, strain-gauge probe."}};
}

EffectSpec stylusRadius() {
  return {.id = "stylus_radius",
          .title = "Stylus radius or approach offset",
          .kind = EffectKind::Measurement,
          .rows = "58",
          .formula = "(shift/2) s",
          .parameters = {linear("shift", Quantity::Error, both(0.0, 30.0))},
          .covariates = kApproach,
          .lookalikes = {{"backlash", "reads as play", "measure without the probe, or calibrate it"}},
          .action_limit = {0.3, 0.3},
          .shop_floor = {"The effective radius of the stylus is set wrong.", "1 to 20 um.",
                         "Calibrate the probe on a ring or sphere."}};
}

EffectSpec datumShift() {
  return {.id = "datum_shift",
          .title = "Datum shifted during the measurement",
          .kind = EffectKind::Measurement,
          .rows = "59",
          .formula = "shift from the time on",
          .parameters = {linear("shift", Quantity::Error, both(0.0, 100.0), both(0.0, 60.0)),
                         searched("time", Quantity::Duration, both(0.0, 1e6), {})},
          .covariates = kTime,
          .lookalikes = {{"drift", "both differ early and late", "probe the datum across the instant"},
                         {"thermal_head", "a sudden growth", "probe the datum across the instant"}},
          .action_limit = {0.5, 0.5},
          .shop_floor = {"Gauge, reflector or part was touched or slipped.", "1 to 50 um.",
                         "Fasten it and repeat the run."}};
}

EffectSpec timeShift() {
  return {
      .id = "time_shift",
      .title = "Clock of the instrument off",
      .kind = EffectKind::Measurement,
      .rows = "60",
      .formula = "tau times the reading's rate of change",
      .parameters = {linear("tau", Quantity::Delay, both(0.0, 2000.0))},
      .covariates = kTime,
      .lookalikes = {{"servo_lag", "one lag common to all axes", "move in steps and hold before reading"}},
      .shop_floor = {"Instrument and control do not share a clock.", "0.01 to 2 s.",
                     "Trigger by the control; or read at standstill."}};
}

EffectSpec wrongArm() {
  return {.id = "wrong_arm",
          .title = "Measuring point declared at the wrong place",
          .kind = EffectKind::Measurement,
          .rows = "62",
          .formula = "(rotation x k) along the reading's direction, rotation known from the model",
          .parameters = {linear("k", Quantity::Length, both(0.0, 100.0))},
          .lookalikes = {{"angular", "both act through the arm", "measure the arm"}},
          .shop_floor = {"The distance from guideway to reflector was entered wrong.", "5 to 100 mm.",
                         "Measure where the beam meets the carriage and correct the file's head."}};
}

EffectSpec nonparametric() {
  return {
      .id = "nonparametric",
      .title = "Structure without a name",
      .rows = "-",
      .formula = "a smooth function of the covariates found: a cubic spline, alone or times a second one",
      .joints = JointChoice::Any,
      .sites = 0,
      .shop_floor = {"Something repeatable depends on these quantities, and no known cause explains it.",
                     "As found.",
                     "Look where and when it appears; the correction helps within the measured range only."}};
}

}  // namespace

std::vector<EffectSpec> measurementSpecs() {
  return {cosine(),       deadPath(),   materialTemperature(), airWavelength(), probeLobing(),
          stylusRadius(), datumShift(), timeShift(),           wrongArm(),      nonparametric()};
}

}  // namespace nineline::errors
