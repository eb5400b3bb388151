#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/errors/effect.h"
#include "core/errors/table_bundle.h"

namespace nineline::errors {

using kinematics::JointDisplacements;
using kinematics::Machine;
using kinematics::RotationModel;
using kinematics::ToolPose;

/// The past of a model's effects along one path; see Effect. Made by ErrorModel::startMemory.
using EffectMemory = std::vector<double>;

/// Everything known about a machine: its structure and an ordered list of effects on its joints. A value;
/// cheap to copy, because effects are shared.
class ErrorModel {
 public:
  /// Fails when two tables of one joint name different reference points.
  [[nodiscard]] static Result<ErrorModel> make(Machine machine, std::vector<EffectPtr> effects);
  /// The ideal machine.
  explicit ErrorModel(Machine machine);

  [[nodiscard]] const Machine& machine() const { return machine_; }
  /// The same model with another form of its small rotations. FirstOrder reproduces the literature
  /// (theory.md, 1.3); everything else uses Exact, the default.
  [[nodiscard]] ErrorModel withRotationModel(RotationModel form) const;
  [[nodiscard]] RotationModel rotationModel() const { return rotation_model_; }
  [[nodiscard]] const std::vector<EffectPtr>& effects() const { return effects_; }
  /// The model that compensation inverts: without the effects that are not active.
  [[nodiscard]] ErrorModel onlyActive() const;
  /// The model without the effects for which `leave_out` is true.
  [[nodiscard]] ErrorModel without(const std::function<bool(const Effect&)>& leave_out) const;

  /// Displacement of every joint at a state; `memory` empty for a single instant.
  void displacements(const MachineState& state, std::span<const double> memory,
                     JointDisplacements& out) const;
  /// Their derivatives with respect to the joints' own positions.
  void slopes(const MachineState& state, const JointDisplacements& displacements,
              kinematics::DisplacementSlopes& out) const;

  /// Pose of the actual tool in the workpiece frame.
  [[nodiscard]] ToolPose actualPose(const MachineState& state, std::span<const double> memory = {}) const;
  /// Pose of the ideal tool: no errors.
  [[nodiscard]] ToolPose idealPose(const MachineState& state) const { return forward(machine_, state.q); }
  /// Actual pose and Jacobian with respect to the joint positions, the slopes of the errors included.
  [[nodiscard]] ToolPose actualPoseWithJacobian(const MachineState& state, std::span<const double> memory,
                                                kinematics::PoseJacobian& jacobian) const;

  [[nodiscard]] std::size_t memorySize() const { return memory_size_; }
  [[nodiscard]] EffectMemory startMemory(const MachineState& state) const;
  void advance(const MachineState& from, const MachineState& to, std::span<double> memory) const;

  /// Conditions that effects need and the state lacks, each once.
  [[nodiscard]] std::vector<std::string> missingConditions(const MachineState& state) const;
  /// The first effect whose data do not cover the state, −1 when all do.
  [[nodiscard]] int firstUncovered(const MachineState& state) const;
  /// Shortest distance of a joint over which its errors can bend (mm, rad); infinite where they are straight.
  [[nodiscard]] double featureLength(int joint) const {
    return feature_lengths_[static_cast<std::size_t>(joint)];
  }
  /// True where an error of a joint differs by the sense in which it arrives.
  [[nodiscard]] bool followsSense(int joint) const { return follows_sense_[static_cast<std::size_t>(joint)]; }
  /// Take-up of a joint at a reversal, the sum over its effects (mm, rad).
  [[nodiscard]] double play(int joint) const { return plays_[static_cast<std::size_t>(joint)]; }

 private:
  struct Reference {
    int joint;
    Slot slot;
    Eigen::Vector3d point;  // in the moved frame
  };
  /// Where the point stands in the frame of its slot.
  [[nodiscard]] Eigen::Vector3d referencePoint(const MachineState& state, const Reference& reference) const;
  [[nodiscard]] Result<void> collectReferences();
  void prepare();
  Machine machine_;
  std::vector<EffectPtr> effects_;
  std::vector<TableBundle> bundles_;
  std::vector<EffectPtr> others_;  // effects that are no tables, in order
  std::vector<Reference> references_;
  std::size_t memory_size_ = 0;
  RotationModel rotation_model_ = RotationModel::Exact;
  JointPositions feature_lengths_{};
  JointPositions plays_{};
  std::array<bool, kMaxAxes> follows_sense_{};
};

}  // namespace nineline::errors
