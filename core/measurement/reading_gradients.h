#pragma once

#include "core/measurement/prediction.h"

namespace nineline::measurement {

/// For every row of a measurement (rowsOf) the derivative of the reading with respect to the six small
/// displacements of every joint and slot. To first order an effect adds
///     reading contribution = along(row, joint, slot, motion)
/// so this is what Jacobians of an identification and the dictionary of a discovery are made of. Flat:
/// 18 numbers for each row and joint, in the order Located, Standing, Moved × dx dy dz rx ry rz.
class ReadingGradients {
 public:
  using Six = Eigen::Map<const Eigen::Matrix<double, 6, 1>>;

  ReadingGradients(std::size_t rows, int joints);

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] int joints() const { return static_cast<int>(joints_); }
  /// mm per mm (0…2), mm per rad (3…5); rad for angular channels.
  [[nodiscard]] Six at(std::size_t row, int joint, errors::Slot slot) const {
    return Six(values_.data() + (row * joints_ + static_cast<std::size_t>(joint)) * kGradientPerJoint +
               6 * static_cast<std::size_t>(slot));
  }
  /// gradient · motion.
  [[nodiscard]] double along(std::size_t row, int joint, errors::Slot slot,
                             const errors::SmallMotion& motion) const {
    const Six six = at(row, joint, slot);
    return six.head<3>().dot(motion.translation) + six.tail<3>().dot(motion.rotation);
  }
  /// The numbers of one row, for writing.
  [[nodiscard]] std::span<double> row(std::size_t row) {
    return std::span(values_).subspan(row * joints_ * kGradientPerJoint, joints_ * kGradientPerJoint);
  }

 private:
  std::size_t rows_;
  std::size_t joints_;
  std::vector<double> values_;
};

/// Gradients about the ideal machine. Requires requireInstrument.
[[nodiscard]] ReadingGradients gradientsOf(const Machine& machine, const Measurement& measurement);

/// Gradients about the machine as `model` knows it, for an exact Gauss-Newton iteration; `states` as
/// statesOf(measurement, machine) gives them. Requires requireInstrument.
[[nodiscard]] ReadingGradients gradientsOf(const ErrorModel& model, const Measurement& measurement,
                                           const std::vector<MachineState>& states);

/// What one effect adds to every row to first order: the effect's motion at each sample, its memory carried
/// along the file from equilibrium, times the gradient. `context` is the model that the effect stands in or
/// is to be added to (ErrorModel(machine) where there is none): it names the joint's reference point, which
/// rotations turn about. For the instrument `joint` only the joint's own positioning counts. mm or rad by
/// row.
[[nodiscard]] Eigen::VectorXd effectColumn(const ErrorModel& context, const errors::EffectPtr& effect,
                                           const Measurement& measurement,
                                           const std::vector<MachineState>& states,
                                           const ReadingGradients& gradients);

/// The same for a motion that the caller computes: `motion(state)` at one joint and slot. For candidates that
/// are no Effect yet and for basis functions of tables.
template <typename Motion>
[[nodiscard]] Eigen::VectorXd motionColumn(int joint, errors::Slot slot, const Measurement& measurement,
                                           const std::vector<MachineState>& states,
                                           const ReadingGradients& gradients, const Motion& motion) {
  Eigen::VectorXd column(static_cast<Eigen::Index>(gradients.rows()));
  const std::size_t channels = measurement.channels.size();
  std::size_t row = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (!measurement.samples[i].has_positions) continue;
    const errors::SmallMotion at = motion(states[i]);
    for (std::size_t k = 0; k < channels; ++k, ++row) {
      column[static_cast<Eigen::Index>(row)] = gradients.along(row, joint, slot, at);
    }
  }
  return column;
}

}  // namespace nineline::measurement
