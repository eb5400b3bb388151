#include "core/postprocessing/branches.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace nineline::postprocessing {

namespace {

kinematics::Travel rangeOf(const kinematics::Joint& joint) {
  if (joint.continuous || !joint.travel) return {-kPi, kPi};
  return *joint.travel;
}

/// A start of the sequence with irrational steps, the same every time.
JointPositions startNumber(const PoseSolver& solver, const JointPositions& home, int number) {
  static constexpr std::array<double, kMaxAxes> kSteps = {0.8191725134, 0.6710436067, 0.5497004779,
                                                          0.7548776662, 0.5698402910, 0.6180339887,
                                                          0.8566748838, 0.7338918566, 0.6287067210};
  const Machine& machine = solver.machine();
  JointPositions start = home;
  for (int i = 0; i < machine.jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    if ((solver.free() >> k & 1U) == 0 || (!machine.isRotary(i) && !solver.isRedundant())) continue;
    if (!machine.isRotary(i) && !machine.joint(i).travel) continue;
    const kinematics::Travel range = rangeOf(machine.joint(i));
    start[k] = range.low + std::fmod(0.5 + kSteps[k] * number, 1.0) * (range.high - range.low);
  }
  return start;
}

int rotaryCount(const PoseSolver& solver) {
  int count = 0;
  for (int i = 0; i < solver.machine().jointCount(); ++i)
    count += solver.machine().isRotary(i) && (solver.free() >> i & 1U) != 0 ? 1 : 0;
  return count;
}

/// Gathers solutions that differ.
class Collection {
 public:
  Collection(const PoseSolver& solver, const TipAxis& target, const JointPositions& home, std::size_t most)
      : solver_(solver), target_(target), home_(home), most_(most) {}

  bool isFull() const { return found_.size() >= most_; }
  std::size_t size() const { return found_.size(); }
  void tryFrom(const JointPositions& start) {
    Solution solution = solver_.search(target_, start);
    if (!solution.converged) return;
    centre(solution.q);
    const auto isKnown = [&](const JointPositions& q) { return alike(q, solution.q); };
    if (std::ranges::none_of(found_, isKnown)) found_.push_back(solution.q);
  }
  /// Starts from the mirror images of one solution: each rotary joint as it is, negated, and half a turn on.
  void tryMirrors(std::size_t index) {
    const JointPositions q = found_[index];
    const Machine& machine = solver_.machine();
    std::vector<std::size_t> rotary;
    for (int i = 0; i < machine.jointCount(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (machine.isRotary(i) && (solver_.free() >> k & 1U) != 0) rotary.push_back(k);
    }
    if (rotary.size() > 3) rotary.resize(3);
    const int count = static_cast<int>(std::pow(4.0, static_cast<double>(rotary.size())));
    for (int code = 1; code < count && !isFull(); ++code) {
      JointPositions start = q;
      int rest = code;
      for (const std::size_t k : rotary) {
        if ((rest & 1) != 0) start[k] = -start[k];
        if ((rest & 2) != 0) start[k] += kPi;
        rest >>= 2;
      }
      tryFrom(start);
    }
  }
  std::vector<JointPositions> take() { return std::move(found_); }

 private:
  bool alike(const JointPositions& a, const JointPositions& b) const {
    if (!solver_.isRedundant()) return sameButTurns(solver_.machine(), a, b);
    double distance = 0.0;
    for (int i = 0; i < solver_.machine().jointCount(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      const double d = a[k] - b[k];
      distance += solver_.machine().isRotary(i) ? std::abs(std::remainder(d, kTurn)) : 0.01 * std::abs(d);
    }
    return distance < 0.2;
  }
  /// Rotary joints within half a turn of the home position.
  void centre(JointPositions& q) const {
    for (int i = 0; i < solver_.machine().jointCount(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (solver_.machine().isRotary(i)) q[k] = home_[k] + std::remainder(q[k] - home_[k], kTurn);
    }
  }
  const PoseSolver& solver_;
  TipAxis target_;
  JointPositions home_;
  std::size_t most_;
  std::vector<JointPositions> found_;
};

}  // namespace

JointPositions homeOf(const Machine& machine) {
  JointPositions home{};
  for (int i = 0; i < machine.jointCount(); ++i) {
    const kinematics::Joint& joint = machine.joint(i);
    if (joint.travel && !joint.continuous)
      home[static_cast<std::size_t>(i)] = 0.5 * (joint.travel->low + joint.travel->high);
  }
  return home;
}

bool sameButTurns(const Machine& machine, const JointPositions& a, const JointPositions& b) {
  for (int i = 0; i < machine.jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double d = machine.isRotary(i) ? std::remainder(a[k] - b[k], kTurn) : a[k] - b[k];
    if (std::abs(d) > (machine.isRotary(i) ? 1e-6 : 1e-4)) return false;
  }
  return true;
}

std::vector<JointPositions> findBranches(const PoseSolver& solver, const TipAxis& target,
                                         const JointPositions& home, const BranchOptions& options) {
  Collection collection(solver, target, home, options.most);
  std::size_t mirrored = 0;
  const std::size_t usual = rotaryCount(solver) > 2 ? 4 : 2;
  for (int number = 0; number < options.starts && !collection.isFull(); ++number) {
    collection.tryFrom(startNumber(solver, home, number));
    if (solver.isRedundant()) continue;
    for (; mirrored < collection.size() && !collection.isFull(); ++mirrored) collection.tryMirrors(mirrored);
    if (!options.thorough && number >= 12 && collection.size() >= usual) break;
  }
  return collection.take();
}

}  // namespace nineline::postprocessing
