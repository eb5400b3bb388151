#include "core/errors/error_model.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/errors/table_effects.h"

namespace nineline::errors {

using kinematics::exponential;

namespace {

SmallMotion& slotOf(kinematics::JointDisplacement& displacement, Slot slot) {
  switch (slot) {
    case Slot::Located:
      return displacement.located;
    case Slot::Standing:
      return displacement.standing;
    case Slot::Moved:
      break;
  }
  return displacement.moved;
}

}  // namespace

ErrorModel::ErrorModel(Machine machine) : machine_(std::move(machine)) { prepare(); }

Result<ErrorModel> ErrorModel::make(Machine machine, std::vector<EffectPtr> effects) {
  ErrorModel model(std::move(machine));
  model.effects_ = std::move(effects);
  for (const EffectPtr& effect : model.effects_) {
    NL_EXPECTS(effect->joint() >= 0 && effect->joint() < model.machine_.jointCount(), effect->joint());
  }
  if (Result<void> fine = model.collectReferences(); !fine) return fine.error();
  model.prepare();
  return model;
}

ErrorModel ErrorModel::withRotationModel(RotationModel form) const {
  ErrorModel model = *this;
  model.rotation_model_ = form;
  return model;
}

ErrorModel ErrorModel::onlyActive() const {
  return without([](const Effect& effect) { return !effect.isActive(); });
}

ErrorModel ErrorModel::without(const std::function<bool(const Effect&)>& leave_out) const {
  ErrorModel model = *this;
  std::erase_if(model.effects_, [&](const EffectPtr& effect) { return leave_out(*effect); });
  model.references_.clear();
  NL_EXPECTS(model.collectReferences().has_value());  // they agreed in the whole model
  model.prepare();
  return model;
}

Result<void> ErrorModel::collectReferences() {
  for (const EffectPtr& effect : effects_) {
    const auto* table = dynamic_cast<const TableEffect*>(effect.get());
    if (table == nullptr) continue;
    // Translations without a point refer to the origin; rotations without one say nothing about it.
    if (effect->component().isAngular() && table->reference().isZero(0.0)) continue;
    const auto known = std::find_if(references_.begin(), references_.end(), [&](const Reference& one) {
      return one.joint == effect->joint() && one.slot == effect->slot();
    });
    if (known == references_.end()) {
      references_.push_back({effect->joint(), effect->slot(), table->reference()});
    } else if (!known->point.isApprox(table->reference(), 1e-12) &&
               (known->point - table->reference()).norm() > 1e-9) {
      return badInput(
          "model.reference",
          fmt::format("The error tables of axis {} name different reference points; they need one.",
                      machine_.joint(effect->joint()).axis.text()));
    }
  }
  std::erase_if(references_, [](const Reference& one) { return one.point.isZero(0.0); });
  return {};
}

Eigen::Vector3d ErrorModel::referencePoint(const MachineState& state, const Reference& reference) const {
  if (reference.slot == Slot::Moved) return reference.point;
  const double angle = state.q[static_cast<std::size_t>(reference.joint)];
  return kinematics::rotationAbout(machine_.joint(reference.joint).direction, angle) * reference.point;
}

void ErrorModel::prepare() {
  bundles_ = TableBundle::group(effects_);
  others_.clear();
  memory_size_ = 0;
  feature_lengths_.fill(std::numeric_limits<double>::infinity());
  plays_.fill(0.0);
  follows_sense_.fill(false);
  for (const EffectPtr& effect : effects_) {
    const auto joint = static_cast<std::size_t>(effect->joint());
    feature_lengths_[joint] = std::min(feature_lengths_[joint], effect->featureLength());
    plays_[joint] += effect->play();
    follows_sense_[joint] = follows_sense_[joint] || effect->followsSense();
    memory_size_ += effect->memorySize();
    if (effect->table() == nullptr) others_.push_back(effect);
  }
}

void ErrorModel::displacements(const MachineState& state, std::span<const double> memory,
                               JointDisplacements& out) const {
  NL_EXPECTS(memory.empty() || memory.size() == memory_size_, memory.size());
  for (int i = 0; i < machine_.jointCount(); ++i) out[static_cast<std::size_t>(i)] = {};
  for (const TableBundle& bundle : bundles_) {
    const auto joint = static_cast<std::size_t>(bundle.joint());
    bundle.addMotion(state.q[joint], slotOf(out[joint], bundle.slot()));
  }
  std::size_t used = 0;
  for (const EffectPtr& effect : others_) {
    const std::size_t size = memory.empty() ? 0 : effect->memorySize();
    effect->addMotion(state, memory.subspan(used, size),
                      slotOf(out[static_cast<std::size_t>(effect->joint())], effect->slot()));
    used += size;
  }
  for (const Reference& reference : references_) {
    const Eigen::Vector3d point = referencePoint(state, reference);
    SmallMotion& motion = slotOf(out[static_cast<std::size_t>(reference.joint)], reference.slot);
    motion.translation += rotation_model_ == RotationModel::Exact
                              ? Eigen::Vector3d(point - exponential(motion.rotation) * point)
                              : Eigen::Vector3d(point.cross(motion.rotation));
  }
}

void ErrorModel::slopes(const MachineState& state, const JointDisplacements& displacements,
                        kinematics::DisplacementSlopes& out) const {
  out.fill({});
  for (const TableBundle& bundle : bundles_) {
    const auto joint = static_cast<std::size_t>(bundle.joint());
    if (bundle.slot() == Slot::Located) continue;
    bundle.addSlope(state.q[joint], bundle.slot() == Slot::Moved ? out[joint].moved : out[joint].standing);
  }
  for (const EffectPtr& effect : others_) {
    if (effect->slot() == Slot::Located) continue;
    auto& slope = out[static_cast<std::size_t>(effect->joint())];
    effect->addSlope(state, effect->slot() == Slot::Moved ? slope.moved : slope.standing);
  }
  for (const Reference& reference : references_) {
    const auto joint = static_cast<std::size_t>(reference.joint);
    const bool moves = reference.slot == Slot::Moved;
    SmallMotion& slope = moves ? out[joint].moved : out[joint].standing;
    const Eigen::Vector3d& rotation =
        (moves ? displacements[joint].moved : displacements[joint].standing).rotation;
    const Eigen::Vector3d point = referencePoint(state, reference);
    const Eigen::Matrix3d R = exponential(rotation);
    slope.translation -= (kinematics::leftJacobian(rotation) * slope.rotation).cross(R * point);
    if (moves) continue;
    const Eigen::Vector3d velocity = machine_.joint(reference.joint).direction.cross(point);
    slope.translation += velocity - R * velocity;
  }
}

ToolPose ErrorModel::actualPose(const MachineState& state, std::span<const double> memory) const {
  JointDisplacements deviation;
  displacements(state, memory, deviation);
  return forward(machine_, state.q, deviation, rotation_model_);
}

ToolPose ErrorModel::actualPoseWithJacobian(const MachineState& state, std::span<const double> memory,
                                            kinematics::PoseJacobian& jacobian) const {
  JointDisplacements deviation;
  displacements(state, memory, deviation);
  const ToolPose pose = forwardWithJacobian(machine_, state.q, deviation, jacobian, rotation_model_);
  kinematics::DisplacementSlopes slope;
  slopes(state, deviation, slope);
  addSlopes(machine_, state.q, deviation, slope, jacobian);
  return pose;
}

EffectMemory ErrorModel::startMemory(const MachineState& state) const {
  EffectMemory memory(memory_size_);
  std::size_t used = 0;
  for (const EffectPtr& effect : others_) {
    effect->start(state, std::span(memory).subspan(used, effect->memorySize()));
    used += effect->memorySize();
  }
  return memory;
}

void ErrorModel::advance(const MachineState& from, const MachineState& to, std::span<double> memory) const {
  std::size_t used = 0;
  for (const EffectPtr& effect : others_) {
    if (effect->memorySize() == 0) continue;
    effect->advance(from, to, memory.subspan(used, effect->memorySize()));
    used += effect->memorySize();
  }
}

std::vector<std::string> ErrorModel::missingConditions(const MachineState& state) const {
  std::vector<std::string> missing;
  for (const EffectPtr& effect : effects_) {
    for (std::string& name : effect->needs()) {
      const bool known = state.condition(name).has_value() ||
                         std::find(missing.begin(), missing.end(), name) != missing.end();
      if (!known) missing.push_back(std::move(name));
    }
  }
  return missing;
}

int ErrorModel::firstUncovered(const MachineState& state) const {
  for (std::size_t i = 0; i < effects_.size(); ++i) {
    if (!effects_[i]->covers(state)) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace nineline::errors
