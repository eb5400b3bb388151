#pragma once

#include "core/errors/parametric_effects.h"

namespace nineline::errors {

/// −τ v: `servo_lag` (17) and `sync_delay` (36); 0 where the speed is not known.
class DelayEffect final : public ScalarEffect {
 public:
  explicit DelayEffect(const EffectParts& parts) : ScalarEffect(parts), tau_(parts.value("tau")) {}

 protected:
  [[nodiscard]] double amplitude(const MachineState& state, std::span<const double>) const override {
    return -tau_ * velocity(state).value_or(0.0);
  }

 private:
  double tau_;  // s
};

/// `acceleration` (18): k a; 0 where the acceleration is not known.
class AccelerationEffect final : public ScalarEffect {
 public:
  explicit AccelerationEffect(const EffectParts& parts) : ScalarEffect(parts), k_(parts.value("k")) {}

 protected:
  [[nodiscard]] double amplitude(const MachineState& state, std::span<const double> memory) const override;

 private:
  double k_;  // s²
};

/// `counterweight` (52): −(w/2) s + k v of a vertical axis; the second part 0 where the speed is not known.
class CounterweightEffect final : public ScalarEffect {
 public:
  explicit CounterweightEffect(const EffectParts& parts);

 protected:
  [[nodiscard]] double amplitude(const MachineState& state, std::span<const double> memory) const override;

 private:
  double width_, k_;  // mm, s
};

/// `vibration` (61): a sin(2πft + φ), t in the file's time.
class VibrationEffect final : public ScalarEffect {
 public:
  explicit VibrationEffect(const EffectParts& parts);
  [[nodiscard]] std::vector<std::string> needs() const override { return {"t_s"}; }

 protected:
  [[nodiscard]] double amplitude(const MachineState& state, std::span<const double> memory) const override;

 private:
  double amplitude_, rate_, phase_;  // mm or rad, rad/s, rad
};

}  // namespace nineline::errors
