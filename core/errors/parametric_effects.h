#pragma once

#include "core/errors/effect.h"

namespace nineline::errors {

/// What the effects with a few parameters share: the motion is a scalar along one component. The positioning
/// of a joint means along its own `direction`, so that a positive amplitude is motion in the joint's positive
/// sense.
class ScalarEffect : public Effect {
 public:
  void addMotion(const MachineState& state, std::span<const double> memory, SmallMotion& sum) const final;
  void addSlope(const MachineState& state, SmallMotion& sum) const final;
  [[nodiscard]] std::vector<Parameter> parameters() const final { return parameters_; }
  [[nodiscard]] Json toJson(const kinematics::Machine& machine) const override;

 protected:
  ScalarEffect(const kinematics::Machine& machine, int joint, Component component,
               std::vector<Parameter> parameters);
  /// Amplitude in mm or rad, and its derivative with respect to the joint's position.
  [[nodiscard]] virtual double amplitude(const MachineState& state, std::span<const double> memory) const = 0;
  [[nodiscard]] virtual double amplitudeSlope(const MachineState&) const { return 0.0; }
  [[nodiscard]] double position(const MachineState& state) const {
    return state.q[static_cast<std::size_t>(joint())];
  }

 private:
  SmallMotion unit_;
  std::vector<Parameter> parameters_;
};

/// `scale` (1): k q, k in µm/m.
class ScaleEffect final : public ScalarEffect {
 public:
  ScaleEffect(const kinematics::Machine& machine, int joint, Component component,
              std::vector<Parameter> parameters);
  [[nodiscard]] std::string id() const override { return "scale"; }

 protected:
  [[nodiscard]] double amplitude(const MachineState& state, std::span<const double> memory) const override;
  [[nodiscard]] double amplitudeSlope(const MachineState&) const override { return k_; }

 private:
  double k_;  // mm/mm
};

/// `cyclic` (2–4, 34): a sin(2πq/P + φ).
class CyclicEffect final : public ScalarEffect {
 public:
  CyclicEffect(const kinematics::Machine& machine, int joint, Component component,
               std::vector<Parameter> parameters);
  [[nodiscard]] std::string id() const override { return "cyclic"; }
  [[nodiscard]] double featureLength() const override;

 protected:
  [[nodiscard]] double amplitude(const MachineState& state, std::span<const double> memory) const override;
  [[nodiscard]] double amplitudeSlope(const MachineState& state) const override;

 private:
  double amplitude_, wave_number_, phase_;  // mm or rad, rad per mm or rad, rad
};

/// `backlash` (10, 35): −(w/2) s at an instant; along a program a dead band of width w, in which the joint
/// stands still until the command has crossed it. Memory: the joint's offset, mm or rad.
class BacklashEffect final : public ScalarEffect {
 public:
  BacklashEffect(const kinematics::Machine& machine, int joint, Component component,
                 std::vector<Parameter> parameters);
  [[nodiscard]] std::string id() const override { return "backlash"; }
  [[nodiscard]] std::size_t memorySize() const override { return 1; }
  void start(const MachineState& state, std::span<double> memory) const override;
  void advance(const MachineState& from, const MachineState& to, std::span<double> memory) const override;
  [[nodiscard]] double play() const override;

 protected:
  [[nodiscard]] double amplitude(const MachineState& state, std::span<const double> memory) const override;

 private:
  double width_;  // mm or rad
};

/// `thermal_screw` (6): k (T − 20 °C)(q − q_fixed), T the temperature named by `sensor`.
class ThermalScrewEffect final : public ScalarEffect {
 public:
  ThermalScrewEffect(const kinematics::Machine& machine, int joint, Component component,
                     std::vector<Parameter> parameters, std::string sensor);
  [[nodiscard]] std::string id() const override { return "thermal_screw"; }
  [[nodiscard]] std::vector<std::string> needs() const override { return {sensor_}; }
  [[nodiscard]] Json toJson(const kinematics::Machine& machine) const override;

 protected:
  [[nodiscard]] double amplitude(const MachineState& state, std::span<const double> memory) const override;
  [[nodiscard]] double amplitudeSlope(const MachineState& state) const override;

 private:
  double k_, fixed_;  // 1/°C, mm or rad
  std::string sensor_;
};

}  // namespace nineline::errors
