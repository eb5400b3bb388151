#pragma once

#include "core/errors/parametric_effects.h"

namespace nineline::errors {

/// k (T − T0)(q − q_f): `thermal_screw` (6–8), `thermal_scale` (9), `thermal_workpiece` (48). T0 is 20 °C;
/// with `preload` it is that temperature, below which a stretched screw keeps its length. With a second
/// sensor T runs linearly from the first at the low end of the travel to the second at the high end, and the
/// growth is its integral from q_f to q.
class GrowthEffect final : public ScalarEffect {
 public:
  explicit GrowthEffect(const EffectParts& parts);
  [[nodiscard]] std::vector<std::string> needs() const override;
  [[nodiscard]] double featureLength() const override;

 protected:
  [[nodiscard]] double amplitude(const MachineState& state, std::span<const double> memory) const override;
  [[nodiscard]] double amplitudeSlope(const MachineState& state) const override;

 private:
  /// Excess of the temperature at the ends of the travel; nothing where one is not known.
  [[nodiscard]] std::optional<std::pair<double, double>> excess(const MachineState& state) const;
  double k_, fixed_;  // 1/°C, mm or rad
  std::optional<double> preload_;
  kinematics::Travel range_;  // of the gradient
};

/// k y, y a first-order lag of a column, τ ẏ = T − y: `thermal_head` (37, 38), `thermal_ambient` (39),
/// `coolant` (42). Temperatures count from 20 °C, other columns from 0. At rest, and at a single instant, y
/// is the column's value. Between two states the column runs linearly and the solution is exact; without
/// time, or with τ = 0, y is the column's value. Memory: y.
class LagEffect final : public ScalarEffect {
 public:
  explicit LagEffect(const EffectParts& parts);
  [[nodiscard]] std::size_t memorySize() const override { return 1; }
  void start(const MachineState& state, std::span<double> memory) const override;
  void advance(const MachineState& from, const MachineState& to, std::span<double> memory) const override;
  void advanceSampled(const MachineState& from, const MachineState& to,
                      std::span<double> memory) const override {
    advance(from, to, memory);
  }
  [[nodiscard]] std::vector<std::string> needs() const override { return {placement().sensor}; }

 protected:
  [[nodiscard]] double amplitude(const MachineState& state, std::span<const double> memory) const override;

 private:
  [[nodiscard]] std::optional<double> input(const MachineState& state) const;
  double k_, tau_, zero_;
};

/// `thermal_tilt` (40): k (T₁ − T₂); with one sensor k (T₁ − 20 °C).
class DifferenceEffect final : public ScalarEffect {
 public:
  explicit DifferenceEffect(const EffectParts& parts) : ScalarEffect(parts), k_(parts.value("k")) {}
  [[nodiscard]] std::vector<std::string> needs() const override;

 protected:
  [[nodiscard]] double amplitude(const MachineState& state, std::span<const double> memory) const override;

 private:
  double k_;
};

/// `drift` (41): r t.
class DriftEffect final : public ScalarEffect {
 public:
  explicit DriftEffect(const EffectParts& parts) : ScalarEffect(parts), rate_(parts.value("rate")) {}
  [[nodiscard]] std::vector<std::string> needs() const override { return {"t_s"}; }

 protected:
  [[nodiscard]] double amplitude(const MachineState& state, std::span<const double>) const override {
    return rate_ * state.time.value_or(0.0);
  }

 private:
  double rate_;
};

}  // namespace nineline::errors
