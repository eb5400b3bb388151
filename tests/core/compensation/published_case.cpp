#include "tests/core/compensation/published_case.h"

#include <cmath>

#include "core/base/units.h"

namespace nineline::test_support {

using Eigen::Vector3d;
using errors::Component;
using errors::EffectPtr;
using errors::Slot;
using kinematics::Joint;
using kinematics::JointType;
using kinematics::Machine;

namespace {

using Formulas = std::array<FormulaEffect::Formula, 6>;

double alongThread(double z) { return -z / 15.0; }
double centred(double z) { return 2.0 * alongThread(z) - 1.0; }

Formulas errorsOfX() {
  return {[](double x) { return -0.040317208 + 1e-4 * (x - 24.0); },
          [](double x) { return -0.002518639 + 2e-5 * (x - 24.0); },
          [](double x) { return -0.0247 - 3e-5 * (x - 24.0); },
          [](double) { return 1e-5; },
          [](double) { return -0.000267231; },
          [](double) { return -5e-6; }};
}

Formulas errorsOfZ() {
  return {[](double z) { return 0.024 + 0.004 * centred(z) + 0.0015 * std::sin(kTurn * alongThread(z)); },
          [](double z) { return 0.0008 * centred(z); },
          [](double z) {
            return 0.079958818 + 0.012 * centred(z) + 0.002 * std::sin(2.0 * kTurn * alongThread(z));
          },
          [](double z) { return -7.711e-6 + 1e-6 * centred(z); },
          [](double z) { return 0.000104099 + 4e-6 * centred(z); },
          [](double z) { return 3e-6 * std::sin(kTurn * alongThread(z)); }};
}

Formulas errorsOfC() {
  return {[](double g) { return 0.0015 * std::cos(2.0 * g); },
          [](double g) { return 0.0010 * std::sin(g); },
          [](double g) { return 0.0012 * std::sin(g); },
          [](double g) { return 8e-6 * std::cos(g); },
          [](double g) { return 6e-6 * std::sin(2.0 * g); },
          [](double g) { return 2.5e-5 * std::sin(2.0 * g); }};
}

Joint jointOf(char letter, JointType type, const Vector3d& direction, const Vector3d& offset) {
  Joint joint;
  joint.axis = {letter, 0};
  joint.type = type;
  joint.direction = direction;
  joint.offset = offset;
  return joint;
}

}  // namespace

void FormulaEffect::addMotion(const errors::MachineState& state, std::span<const double>,
                              errors::SmallMotion& sum) const {
  const double value = formula_(state.q[static_cast<std::size_t>(joint())]);
  if (component().isAngular()) {
    sum.rotation[component().row - 3] += value;
  } else {
    sum.translation[component().row] += value;
  }
}

Machine grinderWith(const GrinderGeometry& geometry) {
  Machine::Description description;
  description.id = "grinder";
  description.workpiece_chain = {jointOf('Z', JointType::Linear, Vector3d::UnitZ(), Vector3d::Zero()),
                                 jointOf('C', JointType::Rotary, Vector3d::UnitZ(), geometry.q2)};
  description.tool_chain = {jointOf('X', JointType::Linear, Vector3d::UnitX(), geometry.q4)};
  description.tool_tip = geometry.t;
  return Machine::make(description).value();
}

GrinderPlace axisErrors(const GrinderGeometry& geometry, const Vector3d& w, const GrinderPlace& command) {
  const double height = geometry.q4.y() + geometry.t.y() - geometry.q2.y();
  const double radius = std::hypot(w.x(), w.y());
  const double origin = geometry.q2.x() - geometry.q4.x() - geometry.t.x();
  double theta = std::asin(height / radius);
  const double near_side = origin + radius * std::cos(theta);
  const double far_side = origin - radius * std::cos(theta);
  const bool far = std::abs(far_side - command.x) < std::abs(near_side - command.x);
  if (far) theta = kPi - theta;
  const double turn = theta - std::atan2(w.y(), w.x()) - command.gamma;
  return {(far ? far_side : near_side) - command.x,
          geometry.q4.z() + geometry.t.z() - geometry.q2.z() - w.z() - command.z,
          turn - kTurn * std::round(turn / kTurn)};
}

GrinderGeometry PublishedCase::geometry() const {
  if (!levers) return {Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()};
  return {{0.0, 0.0, 300.0}, {200.0, 0.0, 300.0}, {-200.0, 0.0, 0.0}};
}

errors::ErrorModel PublishedCase::model() const {
  std::vector<EffectPtr> effects;
  const auto addJoint = [&](char letter, int joint, const Formulas& formulas, double start) {
    for (int row = 0; row < 6; ++row) {
      if (row >= 3 && translations_only) continue;
      const FormulaEffect::Formula formula = formulas[static_cast<std::size_t>(row)];
      const double sign = row >= 3 ? angle_sign : 1.0;
      const bool constant = values_at_the_start;
      effects.push_back(std::make_shared<FormulaEffect>(
          joint, Component{{letter, 0}, row, false},
          letter == 'C' && fixed_frame ? Slot::Standing : Slot::Moved,
          [formula, sign, constant, start](double q) { return sign * formula(constant ? start : q); }));
    }
  };
  const GrinderPlace first = publishedCommand(0);
  addJoint('Z', 0, errorsOfZ(), first.z);
  addJoint('C', 1, errorsOfC(), first.gamma);
  addJoint('X', 2, errorsOfX(), first.x);
  const auto addLocation = [&](char letter, int joint, int row, double value) {
    if (!squareness || translations_only) return;
    effects.push_back(std::make_shared<FormulaEffect>(joint, Component{{letter, 0}, row, true}, Slot::Located,
                                                      [value](double) { return value; }));
  };
  addLocation('C', 1, 3, 6e-6);
  addLocation('C', 1, 4, one_symbol ? -9e-6 : 12e-6);
  addLocation('X', 2, 4, -9e-6);
  return errors::ErrorModel::make(grinderWith(geometry()), std::move(effects)).value();
}

GrinderPlace publishedCommand(int k) {
  const double pitch = 1.5;
  const double radius = 24.0 - 17.0 / 24.0 * std::sqrt(3.0) / 2.0 * pitch;
  return {radius, -pitch * k / 24.0, k * kPi / 12.0};
}

}  // namespace nineline::test_support
