#include "ui/models/component_names.h"

#include <QCoreApplication>
#include <array>
#include <cmath>

#include "ui/models/catalogue_texts.h"

namespace nineline::models {

namespace {

using errors::Component;
using kinematics::Machine;

QString translated(const char* text) { return QCoreApplication::translate("components", text); }

constexpr double kParallel = 0.999;

/// Whether the row of a component lies along the joint's own direction.
bool isAlong(const Component& component, const kinematics::Joint& joint) {
  return std::abs(joint.direction[component.row % 3]) > kParallel;
}

QString locationDescription(const Component& component, const QString& axis, const QString& direction) {
  if (component.isAngular()) {
    return translated(QT_TRANSLATE_NOOP("components", "squareness: axis %1 turned about %2"))
        .arg(axis, direction);
  }
  return translated(QT_TRANSLATE_NOOP("components", "place of axis %1 shifted along %2"))
      .arg(axis, direction);
}

QString linearDescription(const Component& component, bool along, const QString& axis,
                          const QString& direction) {
  if (!component.isAngular()) {
    return along
               ? translated(QT_TRANSLATE_NOOP("components", "positioning error of %1")).arg(axis)
               : translated(QT_TRANSLATE_NOOP("components", "straightness of %1 in %2")).arg(axis, direction);
  }
  return along ? translated(QT_TRANSLATE_NOOP("components", "roll of %1")).arg(axis)
               : translated(QT_TRANSLATE_NOOP("components", "tilt of %1 about %2")).arg(axis, direction);
}

QString rotaryDescription(const Component& component, bool along, const QString& axis,
                          const QString& direction) {
  if (!component.isAngular()) {
    return along ? translated(QT_TRANSLATE_NOOP("components", "axial motion of %1")).arg(axis)
                 : translated(QT_TRANSLATE_NOOP("components", "radial motion of %1 in %2"))
                       .arg(axis, direction);
  }
  return along ? translated(QT_TRANSLATE_NOOP("components", "angular positioning error of %1")).arg(axis)
               : translated(QT_TRANSLATE_NOOP("components", "wobble of %1 about %2")).arg(axis, direction);
}

}  // namespace

std::vector<Component> motionComponents(AxisId axis) {
  std::vector<Component> components;
  for (int row = 0; row < 6; ++row) components.push_back(Component{axis, row, false});
  return components;
}

std::vector<Component> locationComponents(AxisId axis) {
  std::vector<Component> components;
  for (int row = 0; row < 6; ++row) components.push_back(Component{axis, row, true});
  return components;
}

QString descriptionOf(const Component& component, const Machine& machine) {
  const QString axis = QString::fromStdString(component.axis.text());
  const QString direction = QChar::fromLatin1("XYZ"[component.row % 3]);
  if (component.location) return locationDescription(component, axis, direction);
  const int joint = machine.find(component.axis);
  if (joint < 0) return {};
  const bool along = isAlong(component, machine.joint(joint));
  return machine.isRotary(joint) ? rotaryDescription(component, along, axis, direction)
                                 : linearDescription(component, along, axis, direction);
}

QString unitOf(const Component& component) {
  return component.isAngular() ? QStringLiteral("″") : QStringLiteral("µm");
}

QString positionUnitOf(const Machine& machine, int joint) {
  return machine.isRotary(joint) ? QStringLiteral("°") : QStringLiteral("mm");
}

QString machineName(const Machine& machine) {
  struct Name {
    const char* id;
    const char* text;
  };
  static constexpr std::array kNames = {
      Name{"b2-k3032", QT_TRANSLATE_NOOP("components", "B2-K3032 thread grinder")},
      Name{"b2-k3032-example", QT_TRANSLATE_NOOP("components", "B2-K3032 thread grinder (worked example)")},
      Name{"generic-3axis",
           QT_TRANSLATE_NOOP("components", "Three-axis mill, X and Y under the table, Z in the head")},
      Name{"trunnion-ac", QT_TRANSLATE_NOOP("components", "Five-axis mill with a trunnion table A, C")},
      Name{"head-head-bc", QT_TRANSLATE_NOOP("components", "Five-axis mill with a fork head C, B")},
      Name{"table-head-bc",
           QT_TRANSLATE_NOOP("components", "Five-axis mill with a table C and a swivel head B")},
      Name{"propeller-c2zxc1b1",
           QT_TRANSLATE_NOOP("components", "Seven-axis five-linkage propeller machine")},
      Name{"rotary-table", QT_TRANSLATE_NOOP("components", "Rotary table C")},
      Name{"linear-stage", QT_TRANSLATE_NOOP("components", "Linear stage X")},
  };
  for (const Name& name : kNames) {
    // A changed machine that kept the id has its own name.
    if (machine.id() == name.id && machine.name() == name.text) return translated(name.text);
  }
  return QString::fromStdString(machine.name());
}

QString effectName(const std::string& id) {
  struct Name {
    const char* id;
    const char* text;
  };
  static constexpr std::array kNames = {
      Name{"scale", QT_TRANSLATE_NOOP("components", "Scale error")},
      Name{"backlash", QT_TRANSLATE_NOOP("components", "Backlash")},
      Name{"cyclic", QT_TRANSLATE_NOOP("components", "Cyclic error")},
      Name{"thermal_screw", QT_TRANSLATE_NOOP("components", "Thermal growth of the screw")},
      Name{"table", QT_TRANSLATE_NOOP("components", "Error table")},
      Name{"location", QT_TRANSLATE_NOOP("components", "Location error")},
  };
  for (const Name& name : kNames) {
    if (id == name.id) return translated(name.text);
  }
  if (const errors::EffectSpec* spec = errors::findEffectSpec(id)) return catalogueText(spec->title);
  return QString::fromStdString(id);
}

QString parameterName(const std::string& effect, const std::string& parameter) {
  struct Name {
    const char* effect;
    const char* parameter;
    const char* text;
  };
  static constexpr std::array kNames = {
      Name{"scale", "k", QT_TRANSLATE_NOOP("components", "Growth per metre")},
      Name{"backlash", "width", QT_TRANSLATE_NOOP("components", "Width of the play")},
      Name{"cyclic", "amplitude", QT_TRANSLATE_NOOP("components", "Amplitude")},
      Name{"cyclic", "period", QT_TRANSLATE_NOOP("components", "Period")},
      Name{"cyclic", "phase", QT_TRANSLATE_NOOP("components", "Phase")},
      Name{"thermal_screw", "k", QT_TRANSLATE_NOOP("components", "Growth per metre and degree")},
      Name{"thermal_screw", "q_fixed", QT_TRANSLATE_NOOP("components", "Position of the fixed bearing")},
  };
  for (const Name& name : kNames) {
    if (effect == name.effect && parameter == name.parameter) return translated(name.text);
  }
  return QString::fromStdString(parameter);
}

QString shownUnit(const std::string& unit) {
  if (unit == "um") return QStringLiteral("µm");
  if (unit == "um/m") return QStringLiteral("µm/m");
  if (unit == "um/m/C") return QStringLiteral("µm/(m·°C)");
  if (unit == "deg") return QStringLiteral("°");
  if (unit == "arcsec") return QStringLiteral("″");
  return QString::fromStdString(unit);
}

}  // namespace nineline::models
