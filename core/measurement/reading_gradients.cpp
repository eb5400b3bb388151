#include "core/measurement/reading_gradients.h"

#include <algorithm>

#include "core/errors/table_effects.h"
#include "core/kinematics/rotation.h"

namespace nineline::measurement {

using errors::Slot;
using errors::SmallMotion;
using kinematics::JointDisplacements;

namespace {

/// Fills the gradients row by row; `displace` gives the displacements at a state.
template <typename Displace>
ReadingGradients gradientsAt(const Machine& machine, const Measurement& measurement,
                             const std::vector<MachineState>& states, const Displace& displace) {
  const ReadingFunction reading(machine, measurement.instrument, measurement.channels);
  std::size_t samples = 0;
  for (const Sample& sample : measurement.samples) samples += sample.has_positions ? 1 : 0;
  const std::size_t channels = measurement.channels.size();
  ReadingGradients gradients(samples * channels, machine.jointCount());
  std::vector<double> readings(channels);
  std::vector<double> block(channels * reading.gradientSize());
  std::size_t row = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (!measurement.samples[i].has_positions) continue;
    reading.readWithGradient(states[i].q, displace(states[i]), readings, block);
    for (std::size_t k = 0; k < channels; ++k, ++row) {
      const auto part = std::span(block).subspan(k * reading.gradientSize(), reading.gradientSize());
      std::copy(part.begin(), part.end(), gradients.row(row).begin());
    }
  }
  return gradients;
}

/// The point in the moved frame that a joint's rotations turn about; the origin where no table names one.
Eigen::Vector3d referenceOf(const ErrorModel& context, const errors::EffectPtr& effect) {
  std::vector<errors::EffectPtr> all = context.effects();
  all.push_back(effect);
  for (const errors::EffectPtr& one : all) {
    const auto* table = dynamic_cast<const errors::TableEffect*>(one.get());
    if (table == nullptr || one->joint() != effect->joint() || one->slot() != effect->slot()) continue;
    if (!table->reference().isZero(0.0)) return table->reference();
  }
  return Eigen::Vector3d::Zero();
}

}  // namespace

ReadingGradients::ReadingGradients(std::size_t rows, int joints)
    : rows_(rows),
      joints_(static_cast<std::size_t>(joints)),
      values_(rows * static_cast<std::size_t>(joints) * kGradientPerJoint) {}

ReadingGradients gradientsOf(const Machine& machine, const Measurement& measurement) {
  std::vector<MachineState> states(measurement.samples.size());
  for (std::size_t i = 0; i < states.size(); ++i) states[i].q = measurement.samples[i].q;
  const JointDisplacements none{};
  return gradientsAt(machine, measurement, states,
                     [&none](const MachineState&) -> const JointDisplacements& { return none; });
}

ReadingGradients gradientsOf(const ErrorModel& model, const Measurement& measurement,
                             const std::vector<MachineState>& states) {
  MemoryWalk walk(model.effects());
  JointDisplacements displacements;
  return gradientsAt(model.machine(), measurement, states,
                     [&](const MachineState& state) -> const JointDisplacements& {
                       model.displacements(state, walk.to(state), displacements);
                       return displacements;
                     });
}

Eigen::VectorXd effectColumn(const ErrorModel& context, const errors::EffectPtr& effect,
                             const Measurement& measurement, const std::vector<MachineState>& states,
                             const ReadingGradients& gradients) {
  const kinematics::Joint& joint = context.machine().joint(effect->joint());
  const Eigen::Vector3d reference = measurement.instrument.kind == InstrumentKind::Joint
                                        ? Eigen::Vector3d(Eigen::Vector3d::Zero())
                                        : referenceOf(context, effect);
  MemoryWalk walk({effect});
  const auto motionAt = [&](const MachineState& state) {
    SmallMotion motion;
    effect->addMotion(state, walk.to(state), motion);
    if (reference.isZero(0.0)) return motion;
    const bool turns = effect->slot() == Slot::Standing;
    const double angle = turns ? state.q[static_cast<std::size_t>(effect->joint())] : 0.0;
    const Eigen::Vector3d point =
        turns ? Eigen::Vector3d(kinematics::rotationAbout(joint.direction, angle) * reference) : reference;
    motion.translation += point.cross(motion.rotation);
    return motion;
  };
  return motionColumn(effect->joint(), effect->slot(), measurement, states, gradients, motionAt);
}

}  // namespace nineline::measurement
