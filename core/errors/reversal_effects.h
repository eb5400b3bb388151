#pragma once

#include "core/errors/parametric_effects.h"

namespace nineline::errors {

/// `backlash` (10, 35): −(w/2) s at an instant; along a program a dead band of width w, in which the joint
/// stands still until the command has crossed it. Memory: the joint's offset, mm or rad.
class BacklashEffect final : public ScalarEffect {
 public:
  explicit BacklashEffect(const EffectParts& parts) : ScalarEffect(parts), width_(parts.value("width")) {}
  [[nodiscard]] std::size_t memorySize() const override { return 1; }
  void start(const MachineState& state, std::span<double> memory) const override;
  void advance(const MachineState& from, const MachineState& to, std::span<double> memory) const override;
  [[nodiscard]] double play() const override;

 protected:
  [[nodiscard]] double amplitude(const MachineState& state, std::span<const double> memory) const override;

 private:
  double width_;  // mm or rad
};

/// Jumps to the other side at each reversal, −(w/2) s: `lateral_play` (15) and `angular_play` (16) by w,
/// `windup` (11) by k q, `lost_motion` (12) by κ load.
class SideEffect final : public ScalarEffect {
 public:
  explicit SideEffect(const EffectParts& parts);
  [[nodiscard]] std::vector<std::string> needs() const override;

 protected:
  [[nodiscard]] double amplitude(const MachineState& state, std::span<const double> memory) const override;
  [[nodiscard]] double amplitudeSlope(const MachineState& state) const override;

 private:
  double width_, per_position_, per_load_;
};

/// `hysteresis` (13): −(w/2) s (1 − 2e^(−d/λ)), d the travel since the reversal. Along a program the offset
/// runs towards −(w/2) s with the travel, e-fold in λ: the same where the reversal before was complete, and
/// without a jump where it was not. Memory: the offset, mm or rad.
class HysteresisEffect final : public ScalarEffect {
 public:
  explicit HysteresisEffect(const EffectParts& parts);
  [[nodiscard]] std::size_t memorySize() const override { return 1; }
  void start(const MachineState& state, std::span<double> memory) const override;
  void advance(const MachineState& from, const MachineState& to, std::span<double> memory) const override;
  [[nodiscard]] double featureLength() const override { return length_; }

 protected:
  [[nodiscard]] double amplitude(const MachineState& state, std::span<const double> memory) const override;

 private:
  double width_, length_;
};

/// `reversal_spike` (14): −h s e^(−d/λ), gone where the machine stands still (every speed known to be 0) and
/// where nothing is known of a reversal.
class SpikeEffect final : public ScalarEffect {
 public:
  explicit SpikeEffect(const EffectParts& parts);
  [[nodiscard]] double featureLength() const override { return length_; }

 protected:
  [[nodiscard]] double amplitude(const MachineState& state, std::span<const double> memory) const override;

 private:
  double height_, length_;
};

/// `friction_speed` (19): −s (w/2 + h e^(−(v/v_s)²)); absent where the speed is not known.
class FrictionEffect final : public ScalarEffect {
 public:
  explicit FrictionEffect(const EffectParts& parts);

 protected:
  [[nodiscard]] double amplitude(const MachineState& state, std::span<const double> memory) const override;

 private:
  double width_, height_, speed_;
};

}  // namespace nineline::errors
