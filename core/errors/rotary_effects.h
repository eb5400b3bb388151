#pragma once

#include "core/errors/parametric_effects.h"

namespace nineline::errors {

/// A vector that turns n times as fast as the joint, across its axis: (a cos(nC+φ), a sin(nC+φ)) along (or
/// about) the two axes that follow the joint's own in the order x y z x: `eccentricity` (28, n = 1), `lobing`
/// (30, n ≥ 2), `wobble` (29), and `clamping` (49), n = 3, which fades with the distance of another joint
/// from `q_ref`, e-fold in `length`. Acts in the moved frame as all errors of a joint do (contract.md,
/// convention 2).
class TurningEffect final : public ParametricEffect {
 public:
  explicit TurningEffect(const EffectParts& parts);
  void addMotion(const MachineState& state, std::span<const double> memory, SmallMotion& sum) const override;
  void addSlope(const MachineState& state, SmallMotion& sum) const override;
  [[nodiscard]] double featureLength() const override;

 private:
  void add(double first, double second, SmallMotion& sum) const;
  [[nodiscard]] double size(const MachineState& state) const;  // mm or rad
  double amplitude_, waves_, phase_;
  int first_, second_;  // rows 0…2
  double length_, reference_;
  bool angular_;
};

}  // namespace nineline::errors
