#pragma once

#include "core/errors/parametric_effects.h"

namespace nineline::errors {

/// `scale` (1): k q.
class ScaleEffect final : public ScalarEffect {
 public:
  explicit ScaleEffect(const EffectParts& parts) : ScalarEffect(parts), k_(parts.value("k")) {}

 protected:
  [[nodiscard]] double amplitude(const MachineState& state, std::span<const double>) const override {
    return k_ * position(state);
  }
  [[nodiscard]] double amplitudeSlope(const MachineState&) const override { return k_; }

 private:
  double k_;  // mm/mm
};

/// A wave over the position, a sin(w q + φ): `cyclic`, `periodic_tilt`, `encoder_eccentricity`,
/// `encoder_subdivision`, `axial_runout`. w = 2π/P, or n waves a turn, or one where neither is stated.
class WaveEffect final : public ScalarEffect {
 public:
  explicit WaveEffect(const EffectParts& parts);
  [[nodiscard]] double featureLength() const override;

 protected:
  [[nodiscard]] double amplitude(const MachineState& state, std::span<const double> memory) const override;
  [[nodiscard]] double amplitudeSlope(const MachineState& state) const override;

 private:
  double amplitude_, wave_number_, phase_;  // mm or rad; rad per mm or rad; rad
};

/// `straightness` (20–22) and `angular` (23): a p(x), x = −1…1 over the travel; p by `shape`: 1 x, 2 x² − 1/3
/// (bow), 3 x³ − 0.6 x (S), 4 to 6 Legendre's polynomials.
class BendEffect final : public ScalarEffect {
 public:
  explicit BendEffect(const EffectParts& parts);
  [[nodiscard]] double featureLength() const override;

 protected:
  [[nodiscard]] double amplitude(const MachineState& state, std::span<const double> memory) const override;
  [[nodiscard]] double amplitudeSlope(const MachineState& state) const override;

 private:
  double amplitude_, middle_, half_;
  std::span<const double> polynomial_;  // coefficients of x⁰, x¹, …
};

/// `sag` (50): −k ((q − q_ref)/1000)^power, power 2 or 3, mm in the bracket: metres.
class SagEffect final : public ScalarEffect {
 public:
  explicit SagEffect(const EffectParts& parts);
  [[nodiscard]] double featureLength() const override;

 protected:
  [[nodiscard]] double amplitude(const MachineState& state, std::span<const double> memory) const override;
  [[nodiscard]] double amplitudeSlope(const MachineState& state) const override;

 private:
  double k_, reference_;
  bool cubed_;
};

}  // namespace nineline::errors
