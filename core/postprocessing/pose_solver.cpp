#include "core/postprocessing/pose_solver.h"

#include <Eigen/Dense>
#include <bit>
#include <cmath>
#include <limits>

#include "core/base/units.h"

namespace nineline::postprocessing {

namespace {

using Rows = Eigen::Matrix<double, 5, Eigen::Dynamic, 0, 5, kMaxAxes>;
using Vector5d = Eigen::Matrix<double, 5, 1>;
using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxAxes, 1>;
using Matrix5d = Eigen::Matrix<double, 5, 5>;

constexpr double kSingular = 1e-13;  // smallest share of a pivot that is still divided by
constexpr double kReluctant = 1e5;   // mm: what 1 rad of a rotary joint weighs in a singular pose
constexpr double kNoRank = 1e12;     // condition from which equations count as singular
constexpr int kMostHalvings = 8;

/// Rotation vector that turns the unit vector `from` into `to` (theory.md, 4.2 b).
Vector3d turnBetween(const Vector3d& from, const Vector3d& to) {
  const Vector3d cross = from.cross(to);
  const double squared = cross.squaredNorm();
  // asin(s)/s by its series: exact to a double's last digit below a hundredth of a rad
  if (squared < 1e-4 && from.dot(to) > 0.0)
    return cross * (1.0 + squared * (1.0 / 6.0 + squared * (3.0 / 40.0 + squared * (5.0 / 112.0))));
  const double sine = std::sqrt(squared);
  if (sine > 1e-300) return cross * (std::atan2(sine, from.dot(to)) / sine);
  return from.dot(to) >= 0.0 ? Vector3d(Vector3d::Zero()) : Vector3d(kPi * from.unitOrthogonal());
}

void capTurns(const Machine& machine, double most, JointPositions& step) {
  double largest = 0.0;
  for (int i = 0; i < machine.jointCount(); ++i) {
    if (machine.isRotary(i)) largest = std::max(largest, std::abs(step[static_cast<std::size_t>(i)]));
  }
  if (largest <= most) return;
  for (double& value : step) value *= most / largest;
}

double sizeOf(const TipAxisResidual& r, double rotation_length) {
  return r.tip.squaredNorm() + rotation_length * rotation_length * r.turn.squaredNorm();
}

/// The five equations of five joints with their right side, solved in place by elimination with partial
/// pivoting; false where they are singular. Small and of fixed size: this is the inner loop of every path.
using Augmented = std::array<std::array<double, 6>, 5>;
bool eliminate(Augmented& rows) {
  double largest = 0.0;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < 5; ++c) {
    std::size_t pivot = c;
    for (std::size_t i = c + 1; i < 5; ++i)
      if (std::abs(rows[i][c]) > std::abs(rows[pivot][c])) pivot = i;
    if (pivot != c) std::swap(rows[pivot], rows[c]);
    const double size = std::abs(rows[c][c]);
    largest = std::max(largest, size);
    smallest = std::min(smallest, size);
    if (!(smallest > kSingular * largest)) return false;
    const double inverse = 1.0 / rows[c][c];
    for (std::size_t i = c + 1; i < 5; ++i) {
      const double factor = rows[i][c] * inverse;
      if (factor == 0.0) continue;
      for (std::size_t k = c + 1; k < 6; ++k) rows[i][k] -= factor * rows[c][k];
    }
  }
  for (std::size_t c = 5; c-- > 0;) {
    double sum = rows[c][5];
    for (std::size_t k = c + 1; k < 5; ++k) sum -= rows[c][k] * rows[k][5];
    rows[c][5] = sum / rows[c][c];
  }
  return true;
}

/// The increment of exactly five free joints.
Increment squareIncrement(const Machine& machine, const TipAxisJacobian& jacobian, const Vector3d& axis,
                          const TipAxisResidual& residual, unsigned free, const SolverOptions& options) {
  const Vector3d t1 = axis.unitOrthogonal();
  const Vector3d t2 = axis.cross(t1);
  const double weight = options.rotation_length;
  Augmented rows;
  std::array<std::size_t, 5> joints{};
  std::array<double, 5> scale{};
  for (std::size_t c = 0; c < 5; ++c, free &= free - 1U) {
    const auto k = static_cast<std::size_t>(std::countr_zero(free));
    const bool rotary = machine.isRotary(static_cast<int>(k));
    joints[c] = k;
    scale[c] = rotary ? 1.0 / options.rotary_length : 1.0;
    for (std::size_t i = 0; i < 3; ++i) rows[i][c] = scale[c] * jacobian.tip[k][static_cast<Eigen::Index>(i)];
    rows[3][c] = rotary ? scale[c] * weight * t1.dot(jacobian.turn[k]) : 0.0;
    rows[4][c] = rotary ? scale[c] * weight * t2.dot(jacobian.turn[k]) : 0.0;
  }
  for (std::size_t i = 0; i < 3; ++i) rows[i][5] = residual.tip[static_cast<Eigen::Index>(i)];
  rows[3][5] = weight * t1.dot(residual.turn);
  rows[4][5] = weight * t2.dot(residual.turn);
  Increment result;
  result.solved = eliminate(rows);
  if (!result.solved) return result;
  for (std::size_t c = 0; c < 5; ++c) {
    result.dq[joints[c]] = scale[c] * rows[c][5];
    result.solved = result.solved && std::isfinite(rows[c][5]);
  }
  return result;
}

struct Equations {
  Rows J;  // scaled columns of the joints that move
  std::array<std::size_t, kMaxAxes> joints{};
  std::array<double, kMaxAxes> scale{};  // W^(-1/2)
};

Equations equationsOf(const Machine& machine, const TipAxisJacobian& jacobian, const Vector3d& t1,
                      const Vector3d& t2, unsigned free, const SolverOptions& options) {
  Equations equations;
  equations.J.resize(5, std::popcount(free));
  std::size_t count = 0;
  for (int i = 0; i < machine.jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    if ((free >> k & 1U) == 0) continue;
    const double scale = machine.isRotary(i) ? 1.0 / options.rotary_length : 1.0;
    const auto c = static_cast<Eigen::Index>(count);
    equations.J.col(c).head<3>() = scale * jacobian.tip[k];
    equations.J(3, c) = scale * options.rotation_length * t1.dot(jacobian.turn[k]);
    equations.J(4, c) = scale * options.rotation_length * t2.dot(jacobian.turn[k]);
    equations.joints[count] = k;
    equations.scale[count++] = scale;
  }
  return equations;
}

}  // namespace

double angleBetween(const Vector3d& a, const Vector3d& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

TipAxis between(const TipAxis& from, const TipAxis& to, double s) {
  TipAxis pose;
  pose.tip = from.tip + s * (to.tip - from.tip);
  const Vector3d turn = turnBetween(from.axis, to.axis);
  const double angle = turn.norm();
  if (angle == 0.0) return pose.axis = from.axis, pose;
  pose.axis = (Eigen::AngleAxisd(s * angle, turn / angle) * from.axis).normalized();
  return pose;
}

TipAxisResidual residualOf(const TipAxis& target, const TipAxis& pose) {
  return {target.tip - pose.tip, turnBetween(pose.axis, target.axis)};
}

Increment increment(const Machine& machine, const TipAxisJacobian& jacobian, const Vector3d& axis,
                    const TipAxisResidual& residual, unsigned free, double lambda,
                    const SolverOptions& options) {
  if (lambda == 0.0 && std::popcount(free) == 5)
    return squareIncrement(machine, jacobian, axis, residual, free, options);
  const Vector3d t1 = axis.unitOrthogonal();
  const Vector3d t2 = axis.cross(t1);
  const Equations equations = equationsOf(machine, jacobian, t1, t2, free, options);
  const Rows& J = equations.J;
  Vector5d r;
  r << residual.tip, options.rotation_length * t1.dot(residual.turn),
      options.rotation_length * t2.dot(residual.turn);
  Increment result;
  Column x(J.cols());
  if (J.cols() >= 5) {
    Matrix5d A = J * J.transpose();
    A.diagonal().array() += lambda * lambda;
    const Eigen::PartialPivLU<Matrix5d> lu(A);
    const auto pivots = lu.matrixLU().diagonal().cwiseAbs();
    result.solved = pivots.minCoeff() > kSingular * kSingular * pivots.maxCoeff();
    x = J.transpose() * lu.solve(r);
  } else {
    Eigen::MatrixXd A = J.transpose() * J;
    A.diagonal().array() += std::max(lambda * lambda, 1e-14);
    x = A.ldlt().solve(J.transpose() * r);
    result.solved = true;
  }
  if (!result.solved || !x.allFinite()) return result.solved = false, result;
  for (Eigen::Index c = 0; c < J.cols(); ++c) {
    const auto k = static_cast<std::size_t>(c);
    result.dq[equations.joints[k]] = equations.scale[k] * x[c];
  }
  return result;
}

PoseSolver::PoseSolver(const Machine& machine, const SolverOptions& options)
    : machine_(machine), chain_(machine), options_(options), free_((1U << machine.jointCount()) - 1U) {}

int PoseSolver::freeCount() const { return std::popcount(free_); }

/// Brings joints that left their travel back to its end and takes them out of the free ones, as long as five
/// remain.
unsigned PoseSolver::stopAtTravel(JointPositions& q, unsigned free) const {
  for (int i = 0; i < machine_.jointCount() && std::popcount(free) > 5; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const auto& travel = machine_.joint(i).travel;
    if ((free >> k & 1U) == 0 || !travel || machine_.joint(i).continuous) continue;
    if (q[k] >= travel->low && q[k] <= travel->high) continue;
    q[k] = q[k] < travel->low ? travel->low : travel->high;
    free &= ~(1U << k);
  }
  return free;
}

Solution PoseSolver::solve(const TipAxis& target, const JointPositions& start) const {
  Solution solution;
  solution.q = start;
  unsigned free = free_;
  TipAxisJacobian jacobian;
  for (;; ++solution.iterations) {
    const TipAxis pose = chain_.at(solution.q, jacobian);
    const TipAxisResidual r = residualOf(target, pose);
    solution.tip_error = r.tip.norm();
    solution.axis_error = r.turn.norm();
    solution.converged =
        solution.tip_error < options_.tip_tolerance && solution.axis_error < options_.axis_tolerance;
    if (solution.converged || solution.iterations == options_.most_iterations) return solution;
    Increment step = increment(machine_, jacobian, pose.axis, r, free, 0.0, options_);
    if (!step.solved) {  // singular: rotary joints stand still unless the tool axis needs them
      SolverOptions reluctant = options_;
      reluctant.rotary_length = kReluctant;
      step = increment(machine_, jacobian, pose.axis, r, free, 1e-6, reluctant);
    }
    if (!step.solved) return solution;
    capTurns(machine_, options_.largest_turn, step.dq);
    for (std::size_t k = 0; k < kMaxAxes; ++k) solution.q[k] += step.dq[k];
    if (isRedundant()) free = stopAtTravel(solution.q, free);
  }
}

Solution PoseSolver::damped(const TipAxis& target, const JointPositions& start) const {
  Solution solution;
  solution.q = start;
  double lambda = 0.1;
  TipAxisJacobian jacobian;
  TipAxis pose = chain_.at(solution.q, jacobian);
  TipAxisResidual r = residualOf(target, pose);
  for (; solution.iterations < 100; ++solution.iterations) {
    const double before = sizeOf(r, options_.rotation_length);
    if (before < 1e-8) break;
    Increment step = increment(machine_, jacobian, pose.axis, r, free_, lambda, options_);
    if (!step.solved) break;
    capTurns(machine_, 2.0 * options_.largest_turn, step.dq);
    JointPositions next = solution.q;
    for (std::size_t k = 0; k < kMaxAxes; ++k) next[k] += step.dq[k];
    if (isRedundant()) stopAtTravel(next, free_);
    TipAxisJacobian next_jacobian;
    const TipAxis next_pose = chain_.at(next, next_jacobian);
    const TipAxisResidual next_r = residualOf(target, next_pose);
    if (sizeOf(next_r, options_.rotation_length) < before) {
      solution.q = next;
      jacobian = next_jacobian;
      pose = next_pose;
      r = next_r;
      lambda = std::max(0.2 * lambda, 1e-6);
    } else {
      lambda *= 5.0;
      if (lambda > 1e6) break;
    }
  }
  return solution;
}

Solution PoseSolver::search(const TipAxis& target, const JointPositions& start) const {
  const Solution rough = damped(target, start);
  Solution fine = solve(target, rough.q);
  fine.iterations += rough.iterations;
  return fine;
}

Solution PoseSolver::follow(const TipAxis& from, const JointPositions& q, const TipAxis& to) const {
  Solution solution = solve(to, q);
  for (int halving = 1; halving <= kMostHalvings && !solution.converged; ++halving) {
    const int steps = 1 << halving;
    Solution part;
    part.q = q;
    int iterations = 0;
    for (int i = 1; i <= steps; ++i) {
      part = solve(i == steps ? to : between(from, to, static_cast<double>(i) / steps), part.q);
      iterations += part.iterations;
      if (!part.converged) break;
    }
    solution = part;
    solution.iterations = iterations;
  }
  return solution.converged ? solution : search(to, q);
}

Solution PoseSolver::holdTip(const TipAxis& target, const JointPositions& start) const {
  Solution solution;
  solution.q = start;
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, kMaxAxes> J(3, 0);
  std::array<std::size_t, kMaxAxes> joints{};
  TipAxisJacobian jacobian;
  TipAxis pose = chain_.at(solution.q, jacobian);
  for (int i = 0; i < machine_.jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (machine_.isRotary(i) || (free_ >> k & 1U) == 0) continue;
    joints[static_cast<std::size_t>(J.cols())] = k;
    J.conservativeResize(3, J.cols() + 1);
    J.col(J.cols() - 1) = jacobian.tip[k];
  }
  for (int repeat = 0; repeat < 2 && J.cols() > 0;
       ++repeat, ++solution.iterations) {  // linear: the second cleans
    const Eigen::VectorXd step = J.colPivHouseholderQr().solve(target.tip - pose.tip);
    for (Eigen::Index c = 0; c < J.cols(); ++c) solution.q[joints[static_cast<std::size_t>(c)]] += step[c];
    pose = chain_.at(solution.q);
  }
  const TipAxisResidual r = residualOf(target, pose);
  solution.tip_error = r.tip.norm();
  solution.axis_error = r.turn.norm();
  solution.converged = solution.tip_error < options_.tip_tolerance;
  return solution;
}

double PoseSolver::opennessAt(const JointPositions& q) const {
  TipAxisJacobian jacobian;
  const Vector3d axis = chain_.at(q, jacobian).axis;
  const Vector3d t1 = axis.unitOrthogonal();
  const Equations equations = equationsOf(machine_, jacobian, t1, axis.cross(t1), free_, options_);
  Eigen::Matrix<double, Eigen::Dynamic, 5, 0, kMaxAxes, 5> gain;
  if (equations.J.cols() == 5) {
    const Matrix5d square = equations.J;
    gain = square.inverse();
  } else if (equations.J.cols() > 5) {
    const Matrix5d A = equations.J * equations.J.transpose();
    gain = equations.J.transpose() * A.inverse();
  } else {
    return 1.0;  // fewer joints: the poses that they reach are reached in one way
  }
  if (!gain.allFinite() || gain.norm() * equations.J.norm() > kNoRank) return 0.0;
  double most = 1.0;
  for (Eigen::Index c = 0; c < gain.rows(); ++c) {
    const auto k = static_cast<std::size_t>(c);
    if (!machine_.isRotary(static_cast<int>(equations.joints[k]))) continue;
    const double to_turn = equations.scale[k] * options_.rotation_length;
    most = std::max({most, gain.row(c).tail<2>().norm() * to_turn,
                     gain.row(c).head<3>().norm() * equations.scale[k] * 100.0});
  }
  return 1.0 / most;
}

}  // namespace nineline::postprocessing
