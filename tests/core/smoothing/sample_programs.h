#pragma once

#include <string>

#include "core/nc/interpreter.h"
#include "core/smoothing/smoothing.h"

namespace nineline::smoothing::testing {

/// Points of a program's cutting motions, read by our own interpreter: tip in W, first the start of the
/// first.
struct ReadPath {
  std::vector<Vector3d> tips;
  std::vector<nc::AxisValues> values;
};
[[nodiscard]] ReadPath readBack(const Machine& machine, const std::string& text,
                                const nc::InterpreterOptions& setup);

[[nodiscard]] const Machine& machineNamed(const std::string& id);
[[nodiscard]] nc::InterpreterOptions setupOf(const Machine& machine);
/// trunnion-ac with the work zero of theory.md, 5.6: G54 at Z 85.
[[nodiscard]] nc::InterpreterOptions impellerSetup();

/// The curve of theory.md, 5.6: tip in W and A, C in rad at t 0 … 1.
struct ImpellerPoint {
  Vector3d tip;
  double a = 0.0;
  double c = 0.0;
};
[[nodiscard]] ImpellerPoint impellerAt(double t);
/// Its program, `points` points at equal t, rounded to `decimals`.
[[nodiscard]] std::string impellerProgram(int points, int decimals);
/// Distance of a point from the impeller curve, mm.
[[nodiscard]] double distanceToImpeller(const Vector3d& tip);

}  // namespace nineline::smoothing::testing
