#include "tests/support/random_machines.h"

#include "core/base/units.h"
#include "core/errors/table_effects.h"

namespace nineline::test_support {

using errors::Component;
using kinematics::Joint;
using kinematics::JointType;
using kinematics::Machine;

double Random::between(double low, double high) {
  return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1.0p-53);
}

int Random::whole(int low, int high) {
  return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1));
}

Eigen::Vector3d Random::vector(double largest) {
  const double x = between(-largest, largest);
  const double y = between(-largest, largest);
  return {x, y, between(-largest, largest)};
}

Eigen::Vector3d Random::unitVector() {
  Eigen::Vector3d v = vector(1.0);
  while (v.norm() < 0.1 || v.norm() > 1.0) v = vector(1.0);
  return v.normalized();
}

Machine randomMachine(Random& random, int joints) {
  static constexpr std::string_view kLetters = "XYZUVWABC";
  Machine::Description description;
  description.id = "random";
  int rotary = 0;
  for (int i = 0; i < joints; ++i) {
    Joint joint;
    joint.axis = {kLetters[static_cast<std::size_t>(i)], 0};
    const bool turns = rotary < 3 && random.whole(0, 1) == 1;
    joint.type = turns ? JointType::Rotary : JointType::Linear;
    rotary += turns ? 1 : 0;
    const double sense = random.whole(0, 1) == 1 ? 1.0 : -1.0;
    joint.direction = random.whole(0, 1) == 1
                          ? Eigen::Vector3d(sense * Eigen::Vector3d::Unit(random.whole(0, 2)))
                          : random.unitVector();
    joint.offset = random.vector(200.0);
    (random.whole(0, 1) == 1 ? description.workpiece_chain : description.tool_chain).push_back(joint);
  }
  description.tool_tip = random.vector(200.0);
  description.tool_axis = random.unitVector();
  return Machine::make(description).value();
}

kinematics::JointPositions randomPositions(Random& random, const Machine& machine) {
  kinematics::JointPositions q{};
  for (int i = 0; i < machine.jointCount(); ++i) {
    const Joint& joint = machine.joint(i);
    const double reach = joint.type == JointType::Rotary ? 1.0 : 200.0;
    q[static_cast<std::size_t>(i)] =
        joint.travel ? random.between(joint.travel->low, joint.travel->high) : random.between(-reach, reach);
  }
  return q;
}

kinematics::JointDisplacements randomDisplacements(Random& random, const Machine& machine, double angle) {
  kinematics::JointDisplacements displacements;
  for (int i = 0; i < machine.jointCount(); ++i) {
    auto& one = displacements[static_cast<std::size_t>(i)];
    for (kinematics::SmallMotion* motion : {&one.located, &one.standing, &one.moved}) {
      motion->translation = random.vector(0.01);
      motion->rotation = random.vector(angle);
    }
  }
  return displacements;
}

errors::ErrorModel randomModel(Random& random, const Machine& machine) {
  std::vector<errors::EffectPtr> effects;
  for (int joint = 0; joint < machine.jointCount(); ++joint) {
    const bool rotary = machine.isRotary(joint);
    for (int row = 0; row < 6; ++row) {
      const double largest = row < 3 ? 0.01 : 5e-5;
      std::vector<double> values(rotary ? 24U : 21U);
      for (double& value : values) value = random.between(-largest, largest);
      errors::ErrorTable::Grid grid{-500.0, 50.0, errors::Interpolation::Cubic, std::nullopt};
      if (rotary) grid = {0.0, kTurn / 24.0, errors::Interpolation::Cubic, kTurn};
      const AxisId axis = machine.joint(joint).axis;
      effects.push_back(std::make_shared<errors::TableEffect>(
          joint, Component{axis, row, false}, errors::ErrorTable::make(grid, std::move(values)).value(),
          rotary && row % 2 == 1));
      effects.push_back(std::make_shared<errors::LocationEffect>(
          joint, Component{axis, row, true}, random.between(-largest, largest), std::nullopt));
    }
  }
  return errors::ErrorModel::make(machine, std::move(effects)).value();
}

}  // namespace nineline::test_support
