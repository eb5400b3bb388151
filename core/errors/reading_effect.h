#pragma once

#include <Eigen/Core>
#include <memory>

#include "core/base/json.h"
#include "core/errors/effect.h"
#include "core/errors/effect_placement.h"

namespace nineline::errors {

/// What one reading came from, as far as an error of the measurement depends on it.
struct ReadingContext {
  const MachineState& state;     ///< at the sample
  const MachineState& start;     ///< at the first sample of the run
  double predicted = 0.0;        ///< what the model says that the instrument reads, mm or rad
  std::optional<double> rate{};  ///< its change in time, mm/s or rad/s
  /// Direction in which a probe touches, or polar angle on a circle, rad.
  std::optional<double> direction{};
  Eigen::Vector3d rotation = Eigen::Vector3d::Zero();    ///< actual − ideal of what is measured, rad, in M
  Eigen::Vector3d sensitive = Eigen::Vector3d::UnitX();  ///< unit vector of a positive reading, in M
};

/// Which readings an error of the measurement belongs to.
struct ReadingPlacement {
  std::string instrument{};  ///< as in contract.md: "laser-linear"
  int joint = -1;            ///< the axis that is measured; −1: none
  std::string file{};        ///< where only one file has it
  std::string sensor{};      ///< column of a temperature
  std::string sensor_2{};    ///< column of the air pressure, hPa
  int row = 0;               ///< wrong_arm: direction of the wrong distance, 0 1 2: x y z
  bool angular = false;      ///< the reading is an angle
};

/// One named cause of a wrong reading: no motion of the machine, so it is reported and never compensated, and
/// an ErrorModel has no place for it. Constant; shared between threads.
class ReadingEffect {
 public:
  /// Parameters as for makeEffect. Fails on an effect that is none of a measurement, or on values without
  /// meaning.
  [[nodiscard]] static Result<ReadingEffect> make(const EffectSpec& spec, ReadingPlacement placement,
                                                  std::span<const Parameter> values);
  [[nodiscard]] static Result<ReadingEffect> fromJson(const Json& json, const std::string& source,
                                                      const kinematics::Machine& machine);

  [[nodiscard]] std::string id() const { return std::string(spec_->id); }
  [[nodiscard]] const EffectSpec& spec() const { return *spec_; }
  [[nodiscard]] const ReadingPlacement& placement() const { return placement_; }
  [[nodiscard]] const std::vector<Parameter>& parameters() const { return parameters_; }
  /// What it adds to the reading, mm or rad; 0 where a condition is not known.
  [[nodiscard]] double addition(const ReadingContext& context) const;
  /// Conditions of the state without which it is not known.
  [[nodiscard]] std::vector<std::string> needs() const;
  [[nodiscard]] Json toJson(const kinematics::Machine& machine) const;

 private:
  using Formula = double (*)(const ReadingEffect&, const ReadingContext&);
  struct Formulas;
  ReadingEffect(const EffectSpec& spec, ReadingPlacement placement, std::vector<Parameter> parameters);
  /// In the program's units.
  [[nodiscard]] double value(std::string_view name) const;
  /// Way of the measured axis since the start of the run, mm or rad.
  [[nodiscard]] double travel(const ReadingContext& context) const;
  const EffectSpec* spec_;
  ReadingPlacement placement_;
  std::vector<Parameter> parameters_;
  Formula formula_;
};

/// See linearBasis; parametersOf(spec, unitChoice(placement), …) turns the coefficients back.
[[nodiscard]] Result<std::vector<ReadingEffect>> readingBasis(const EffectSpec& spec,
                                                              const ReadingPlacement& placement,
                                                              std::span<const Parameter> nonlinear);
[[nodiscard]] UnitChoice unitChoice(const ReadingPlacement& placement);

/// An error that the readings of an instrument may have.
struct ReadingCandidate {
  const EffectSpec* spec = nullptr;
  ReadingPlacement placement;
  std::vector<SearchRange> nonlinear;
  std::size_t columns = 1;
};

/// `placement` names the instrument and its axis; which sensors and parameters come with it is found here.
[[nodiscard]] std::vector<ReadingCandidate> readingCandidates(const kinematics::Machine& machine,
                                                              const ReadingPlacement& placement,
                                                              const AvailableData& data);

}  // namespace nineline::errors
