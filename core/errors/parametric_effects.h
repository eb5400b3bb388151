#pragma once

#include "core/errors/effect.h"
#include "core/errors/effect_placement.h"

namespace nineline::errors {

/// What a parametric effect is made of: its kind, its place, and those parameters that are set, in the
/// catalogue's order and units.
struct EffectParts {
  const EffectSpec& spec;
  const kinematics::Machine& machine;
  Placement placement;
  std::vector<Parameter> parameters;

  [[nodiscard]] const kinematics::Joint& joint() const { return machine.joint(placement.joint); }
  [[nodiscard]] bool has(std::string_view name) const;
  /// In the program's units (mm, rad, s, °C). Requires `has`.
  [[nodiscard]] double value(std::string_view name) const;
  [[nodiscard]] double valueOr(std::string_view name, double otherwise) const;
};

/// An effect of the catalogue with a few parameters. It acts in the moved frame of its joint, in the standing
/// one where the placement says so, and before the motion where its component is a place of the joint (X0C).
class ParametricEffect : public Effect {
 public:
  [[nodiscard]] std::string id() const final { return std::string(spec_.id); }
  [[nodiscard]] const EffectSpec& spec() const { return spec_; }
  [[nodiscard]] const Placement& placement() const { return placement_; }
  [[nodiscard]] std::vector<Parameter> parameters() const final { return parameters_; }
  [[nodiscard]] Json toJson(const kinematics::Machine& machine) const final;
  [[nodiscard]] bool followsSense() const final { return (spec_.covariates & kApproach) != 0; }

 protected:
  explicit ParametricEffect(EffectParts parts);
  [[nodiscard]] double position(const MachineState& state) const {
    return state.q[static_cast<std::size_t>(joint())];
  }
  /// Sense of the joint's last motion: −1, +1; 0 unknown.
  [[nodiscard]] double approach(const MachineState& state) const {
    return state.approach[static_cast<std::size_t>(joint())];
  }
  /// Speed of the joint, mm/s or rad/s; absent where the state has none.
  [[nodiscard]] std::optional<double> velocity(const MachineState& state) const;

 private:
  const EffectSpec& spec_;
  Placement placement_;
  std::vector<Parameter> parameters_;
};

/// What most of them share: the motion is a scalar along one component. The positioning of a joint means
/// along its own `direction`, so that a positive amplitude is motion in the joint's positive sense.
class ScalarEffect : public ParametricEffect {
 public:
  void addMotion(const MachineState& state, std::span<const double> memory, SmallMotion& sum) const final;
  void addSlope(const MachineState& state, SmallMotion& sum) const final;

 protected:
  explicit ScalarEffect(EffectParts parts);
  /// Amplitude in mm or rad, and its derivative with respect to the joint's position.
  [[nodiscard]] virtual double amplitude(const MachineState& state, std::span<const double> memory) const = 0;
  [[nodiscard]] virtual double amplitudeSlope(const MachineState&) const { return 0.0; }

 private:
  SmallMotion unit_;
};

}  // namespace nineline::errors
