#pragma once

#include "core/errors/parametric_effects.h"

namespace nineline::errors {

/// k load: `load_deformation` and `load_tilt` (51). `workpiece_bending` (46) is the same times 16 ζ²(1 − ζ)²,
/// ζ = 0…1 over the range between the centres: k is the deflection in the middle; none outside the centres.
class LoadEffect final : public ScalarEffect {
 public:
  explicit LoadEffect(const EffectParts& parts);
  [[nodiscard]] std::vector<std::string> needs() const override { return {"load_kg"}; }
  [[nodiscard]] double featureLength() const override;

 protected:
  [[nodiscard]] double amplitude(const MachineState& state, std::span<const double> memory) const override;
  [[nodiscard]] double amplitudeSlope(const MachineState& state) const override;

 private:
  double k_;
  std::optional<kinematics::Travel> between_;  // the centres
};

/// `wheel_wear` (43, 44): r n at pass n; with `passes` n₀ saturating, r n₀ (1 − e^(−n/n₀)), which begins with
/// the same rate.
class WearEffect final : public ScalarEffect {
 public:
  explicit WearEffect(const EffectParts& parts);
  [[nodiscard]] std::vector<std::string> needs() const override { return {"pass_1"}; }

 protected:
  [[nodiscard]] double amplitude(const MachineState& state, std::span<const double> memory) const override;

 private:
  double rate_;
  std::optional<double> passes_;
};

/// `wheel_deflection` (45): k times the feed, or times the column `sensor` (a force), then k is in um for one
/// of its unit. `spark_out` (47): that times e^(−n/n₀), n the pass, n₀ = `passes`.
class DeflectionEffect final : public ScalarEffect {
 public:
  explicit DeflectionEffect(const EffectParts& parts);
  [[nodiscard]] std::vector<std::string> needs() const override;

 protected:
  [[nodiscard]] double amplitude(const MachineState& state, std::span<const double> memory) const override;

 private:
  double k_;
  std::optional<double> passes_;
};

}  // namespace nineline::errors
