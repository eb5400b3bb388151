#pragma once

#include "core/postprocessing/tip_axis_chain.h"

namespace nineline::postprocessing {

struct SolverOptions {
  double tip_tolerance = 1e-10;   ///< mm
  double axis_tolerance = 1e-12;  ///< rad
  int most_iterations = 30;
  double largest_turn = 0.3;       ///< rad in one step, theory.md 4.3
  double rotary_length = 100.0;    ///< mm: what one rad of a rotary joint weighs in a minimal motion
  double rotation_length = 100.0;  ///< mm: what one rad of the tool axis weighs
};

/// Target minus pose: mm, and the rotation vector that turns the axis into the wanted one, rad.
struct TipAxisResidual {
  Vector3d tip = Vector3d::Zero();
  Vector3d turn = Vector3d::Zero();
};
[[nodiscard]] TipAxisResidual residualOf(const TipAxis& target, const TipAxis& pose);

struct Solution {
  JointPositions q{};
  int iterations = 0;
  double tip_error = 0.0;   ///< mm
  double axis_error = 0.0;  ///< rad
  bool converged = false;
};

/// One linearised increment of the total-differential method: dq = W⁻¹ Jᵀ (J W⁻¹ Jᵀ + λ² I)⁻¹ r with the five
/// rows of theory.md, 4.2; for five joints and λ = 0 simply J⁻¹ r. `free`: bit i set where joint i may move.
struct Increment {
  JointPositions dq{};
  bool solved = false;  ///< false where the equations are singular
};
[[nodiscard]] Increment increment(const Machine& machine, const TipAxisJacobian& jacobian,
                                  const Vector3d& axis, const TipAxisResidual& residual, unsigned free,
                                  double lambda, const SolverOptions& options);

/// Joint positions for tip and tool axis on a machine of any structure, by linearised increments that are
/// iterated on their own residual (theory.md, 4.3). Knows no closed form of any machine.
class PoseSolver {
 public:
  explicit PoseSolver(const Machine& machine, const SolverOptions& options = {});

  [[nodiscard]] const Machine& machine() const { return machine_; }
  [[nodiscard]] const TipAxisChain& chain() const { return chain_; }
  [[nodiscard]] const SolverOptions& options() const { return options_; }
  /// Joints held where the start has them: bit i for joint i.
  void hold(unsigned mask) { free_ &= ~mask; }
  [[nodiscard]] unsigned free() const { return free_; }
  [[nodiscard]] int freeCount() const;
  [[nodiscard]] bool isRedundant() const { return freeCount() > 5; }

  /// From a start near the answer. A redundant chain moves least, and joints that reach the end of their
  /// travel stay there.
  [[nodiscard]] Solution solve(const TipAxis& target, const JointPositions& start) const;
  /// From any start, damped (Levenberg–Marquardt), then as `solve`.
  [[nodiscard]] Solution search(const TipAxis& target, const JointPositions& start) const;
  /// Follows the straight way from a solved pose to the next; steps of it where one is too far.
  [[nodiscard]] Solution follow(const TipAxis& from, const JointPositions& q, const TipAxis& to) const;
  /// Moves the linear joints alone so that the tip is met; the axis is what the rotary joints make it.
  [[nodiscard]] Solution holdTip(const TipAxis& target, const JointPositions& start) const;
  /// How far from singular a pose is: the inverse of the largest turn of a rotary joint that 1 rad of the
  /// tool axis, or 100 mm of the tip, asks for. The sine of the inner angle on a machine with two rotary
  /// axes; 0 at a singular pose, at most 1.
  [[nodiscard]] double opennessAt(const JointPositions& q) const;

 private:
  [[nodiscard]] Solution damped(const TipAxis& target, const JointPositions& start) const;
  unsigned stopAtTravel(JointPositions& q, unsigned free) const;
  Machine machine_;
  TipAxisChain chain_;
  SolverOptions options_;
  unsigned free_;
};

/// The tip on the straight line, the axis on the great circle between two poses, `s` 0…1.
[[nodiscard]] TipAxis between(const TipAxis& from, const TipAxis& to, double s);
/// Angle between two unit vectors, exact for small ones too.
[[nodiscard]] double angleBetween(const Vector3d& a, const Vector3d& b);

}  // namespace nineline::postprocessing
