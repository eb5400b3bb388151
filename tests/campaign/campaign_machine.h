#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "tests/support/random_machines.h"

namespace nineline::campaign {

using Eigen::Vector3d;
using test_support::Random;

/// The structures of the campaign.
enum class Structure { Grinder, ThreeAxis, Trunnion };
[[nodiscard]] const char* nameOf(Structure structure);

/// One joint, stated by plain numbers: mm, rad.
struct PlainJoint {
  char letter = 'X';
  bool rotary = false;
  bool on_workpiece = false;
  bool continuous = false;
  bool diameter = false;
  Vector3d direction = Vector3d::UnitX();
  Vector3d offset = Vector3d::Zero();
  double low = -500.0;
  double high = 500.0;
};

/// A table, or a constant (spacing 0), of one of the six components of a joint; mm, rad.
struct PlainTable {
  int joint = 0;
  int row = 0;
  bool location = false;
  bool fixed_frame = false;
  bool periodic = false;
  double start = 0.0;
  double spacing = 0.0;
  std::vector<double> values;
};

/// An effect along a joint's own direction.
struct PlainEffect {
  enum class Kind { Scale, Backlash, Cyclic, ThermalScrew };
  Kind kind = Kind::Scale;
  int joint = 0;
  double size = 0.0;        ///< Scale: 1; Backlash, Cyclic: mm or rad; ThermalScrew: 1/K
  double period = 1.0;      ///< Cyclic: mm or rad
  double phase = 0.0;       ///< Cyclic: rad
  double fixed = 0.0;       ///< ThermalScrew: mm or rad
  double above_20_C = 0.0;  ///< ThermalScrew: temperature above 20 °C
};

/// A machine and its errors, joints in the order workpiece chain, tool chain (each from the bed outward).
struct PlainMachine {
  Structure structure = Structure::ThreeAxis;
  std::vector<PlainJoint> joints;
  Vector3d tool_tip = Vector3d::Zero();
  std::vector<PlainTable> tables;
  std::vector<PlainEffect> effects;
};

/// A structure with random offsets, levers, tables of all six components of every joint, location errors,
/// and, where `more` is set, scale, backlash, cyclic and thermal errors.
[[nodiscard]] PlainMachine drawMachine(Random& random, Structure structure, bool more);

/// The same as a model file of contract.md.
[[nodiscard]] std::string modelText(const PlainMachine& machine);

/// Name of the temperature of a joint's screw in the model file.
[[nodiscard]] std::string sensorOf(const PlainJoint& joint);

}  // namespace nineline::campaign
