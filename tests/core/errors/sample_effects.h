#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "core/errors/error_model_file.h"

namespace nineline::errors {

/// One entry of a model file for each kind of effect that moves a machine, on b2-k3032 (Z, C carry the work,
/// X the tool).
struct SampleEffect {
  std::string id;
  std::string json;
};

inline const std::vector<SampleEffect>& sampleEffects() {
  static const auto entry = [](const std::string& id, const std::string& component,
                               const std::string& parameters, const std::string& more = "") {
    return SampleEffect{id, R"({"effect": ")" + id + R"(", "joint": ")" + component.substr(2) +
                                R"(", "component": ")" + component + R"(", "parameters": {)" + parameters +
                                "}" + more + "}"};
  };
  static const std::vector<SampleEffect> kAll = {
      {"location", R"({"effect": "location", "component": "B0C", "value_arcsec": 20.5})"},
      entry("scale", "EXX", R"("k": {"value": 20, "sigma": 0.5, "unit": "um/m"})"),
      entry("cyclic", "EZZ", R"("amplitude": 3, "period": 10, "phase": 30)"),
      entry("straightness", "EXZ", R"("amplitude": 12, "shape": 3)"),
      entry("angular", "EBZ", R"("amplitude": 20, "shape": 1)"),
      entry("periodic_tilt", "EAX", R"("amplitude": 4, "period": 40, "phase": -20)"),
      entry("eccentricity", "EXC", R"("amplitude": 8, "phase": 40)"),
      entry("lobing", "EXC", R"("amplitude": 2, "n": 3, "phase": 10)", R"(, "frame": "fixed")"),
      entry("wobble", "EAC", R"("amplitude": 9, "phase": -70)"),
      entry("axial_runout", "EZC", R"("amplitude": 1.5, "phase": 15)"),
      entry("encoder_eccentricity", "ECC", R"("amplitude": 12, "phase": 100)"),
      entry("encoder_subdivision", "ECC", R"("amplitude": 1, "n": 36, "phase": 5)"),
      entry("backlash", "EXX", R"("width": 4)"),
      entry("lateral_play", "EYX", R"("width": 3)"),
      entry("angular_play", "ECX", R"("width": 5)"),
      entry("windup", "EZZ", R"("k": 10)"),
      entry("lost_motion", "EXX", R"("kappa": 0.02)"),
      entry("hysteresis", "EZZ", R"("width": 6, "length": 12)"),
      entry("reversal_spike", "EXX", R"("height": 7, "length": 2)"),
      entry("friction_speed", "EXX", R"("height": 3, "speed": 4, "width": 2)"),
      entry("servo_lag", "EXX", R"("tau": 0.4)"),
      entry("acceleration", "EZZ", R"j("k": {"value": 50, "unit": "um/(m/s²)"})j"),
      entry("sync_delay", "ECC", R"("tau": 1.5)"),
      entry("vibration", "EYX", R"("amplitude": 2, "frequency": 0.05, "phase": 60)"),
      entry("thermal_screw", "EZZ", R"("k": 11, "q_fixed": -400)", R"(, "sensor": "temp_screw_Z_C")"),
      entry("thermal_scale", "EXX", R"("k": 8, "q_fixed": 0)", R"(, "sensor": "temp_scale_X_C")"),
      entry("thermal_head", "EXX", R"("k": 3, "tau": 900)", R"(, "sensor": "temp_head_C")"),
      entry("thermal_ambient", "Y0C", R"("k": 1.5, "tau": 3000)", R"(, "sensor": "temp_ambient_C")"),
      entry("coolant", "EZZ", R"("k": 6, "tau": 100)", R"(, "sensor": "coolant_1")"),
      entry("thermal_tilt", "EBX", R"("k": 2)", R"(, "sensor": "temp_front_C", "sensor_2": "temp_back_C")"),
      entry("thermal_workpiece", "EZZ", R"("k": 11.5, "q_fixed": 50)", R"(, "sensor": "temp_workpiece_C")"),
      entry("drift", "EXX", R"("rate": 4)"),
      entry("sag", "EZX", R"("k": 100, "q_ref": -50)"),
      entry("load_deformation", "EXX", R"("k": 0.05)"),
      entry("load_tilt", "EBZ", R"("k": 0.03)"),
      entry("counterweight", "EXX", R"("width": 2, "k": 5)"),
      entry("wheel_wear", "EXX", R"("rate": 0.4, "passes": 5)"),
      entry("wheel_deflection", "EXX", R"("k": 10)"),
      entry("spark_out", "EXX", R"("k": 10, "passes": 2)"),
      entry("workpiece_bending", "EXZ", R"("k": 0.2)", R"(, "range_mm": [-100, 300])"),
      entry("clamping", "EXC", R"("amplitude": 4, "length": 30, "q_ref": -100)", R"(, "along": "Z")"),
      {"nonparametric",
       R"({"effect": "nonparametric", "joint": "Z", "component": "EZZ", "covariates": ["Z_mm", "temp_bed_C"],
           "start": -400, "spacing": 200, "centre": 20, "range_second": [18, 26],
           "values_um": [0.1, 2, -1, 3, 0.7, 1, -2]})"}};
  return kAll;
}

inline ErrorModel modelOf(const std::string& machine, const std::string& effects) {
  const Result<ErrorModel> model = readErrorModel(
      R"({"format": "nineline-model/1", "machine": ")" + machine + R"(", "effects": [)" + effects + "]}",
      "test");
  if (!model) throw std::runtime_error(model.error().message());
  return *model;
}

/// A state in which everything is known and nothing is 0.
inline MachineState richState() {
  MachineState state;
  state.q = {100.0, 0.7, 60.0};
  state.approach = {1, -1, 1};
  state.velocity = JointPositions{3.0, 1.1, 2.0};
  state.acceleration = JointPositions{40.0, 2.0, -30.0};
  state.since_reversal = JointPositions{8.0, 0.5, 1.0};
  state.feed = 5.0;
  state.time = 1000.0;
  state.pass = 3.0;
  state.load = 120.0;
  state.conditions = {{"temp_screw_Z_C", 24.0}, {"temp_scale_X_C", 22.5}, {"temp_head_C", 31.0},
                      {"temp_ambient_C", 23.0}, {"coolant_1", 1.0},       {"temp_front_C", 25.0},
                      {"temp_back_C", 22.0},    {"temp_bed_C", 22.5},     {"temp_workpiece_C", 27.0}};
  return state;
}

}  // namespace nineline::errors
