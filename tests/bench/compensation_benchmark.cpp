#include <cstdio>
#include <cstdlib>

#include "core/compensation/point_solver.h"
#include "tests/bench/interleaved.h"
#include "tests/bench/trunnion_reference.h"

// Rows FK-1 and CO-1 of performance.md: forward kinematics with tables of 64 nodes on a trunnion mill, and
// the correction of a point, against a textbook's matrices and against a chain written by hand.

namespace nineline::bench {
namespace {

constexpr int kPoints = 20'000;

kinematics::JointPositions jointsOf(const FiveJoints& q) {
  kinematics::JointPositions joints{};
  std::copy(q.begin(), q.end(), joints.begin());
  return joints;
}

struct Case {
  TrunnionReference reference;
  errors::ErrorModel model = reference.model();
  std::vector<FiveJoints> commands = commandsOfPath(kPoints);
};

const Case& theCase() {
  static const Case one;
  return one;
}

/// Ends the run where the three do not compute the same: a fast wrong result is no result.
void requireSame(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double tolerance) {
  if ((a - b).norm() <= tolerance) return;
  std::fprintf(stderr, "the reference computes something else: %g mm apart\n", (a - b).norm());
  std::abort();
}

void forwardKinematics(benchmark::State& state, bool by_hand, double goal) {
  const Case& c = theCase();
  Eigen::Vector3d axis;
  for (const FiveJoints& q : c.commands) {
    errors::MachineState machine_state;
    machine_state.q = jointsOf(q);
    const Eigen::Vector3d ours = c.model.actualPose(machine_state).tip;
    requireSame(ours, c.reference.textbook(q, axis), 1e-3);
    requireSame(ours, c.reference.byHand(q, axis), 1e-3);
  }
  errors::MachineState machine_state;
  double sum = 0.0;
  const auto ours = [&] {
    for (const FiveJoints& q : c.commands) {
      std::copy(q.begin(), q.end(), machine_state.q.begin());
      sum += c.model.actualPose(machine_state).tip.x();
    }
    benchmark::DoNotOptimize(sum);
  };
  const auto reference = [&] {
    for (const FiveJoints& q : c.commands)
      sum += by_hand ? c.reference.byHand(q, axis).x() : c.reference.textbook(q, axis).x();
    benchmark::DoNotOptimize(sum);
  };
  measureInTurn(state, kPoints, goal, ours, reference);
}

void correctPoint(benchmark::State& state, bool by_hand, double goal) {
  const Case& c = theCase();
  compensation::PointSolver solver(c.model, {});
  compensation::PointSolver::Request request;
  request.free = 0b11111;
  kinematics::JointPositions correction{};
  double sum = 0.0;
  double left = 0.0;
  const auto ours = [&] {
    for (const FiveJoints& q : c.commands) {
      request.ideal = jointsOf(q);
      kinematics::JointPositions guess = request.ideal;
      for (std::size_t k = 0; k < 5; ++k) guess[k] += correction[k];
      const Result<kinematics::JointPositions> solved = solver.solve(request, guess);
      if (!solved) std::abort();
      for (std::size_t k = 0; k < 5; ++k) correction[k] = (*solved)[k] - q[k];
      sum += (*solved)[2];
    }
    benchmark::DoNotOptimize(sum);
  };
  const auto reference = [&] {
    for (const FiveJoints& q : c.commands) sum += c.reference.compensated(q, by_hand)[2];
    benchmark::DoNotOptimize(sum);
  };
  for (const FiveJoints& q : c.commands) {
    request.ideal = jointsOf(q);
    const Result<kinematics::JointPositions> solved = solver.solve(request, request.ideal);
    if (!solved) std::abort();
    errors::MachineState machine_state;
    machine_state.q = *solved;
    const Eigen::Vector3d wanted = forward(c.model.machine(), request.ideal).tip;
    left = std::max(left, (c.model.actualPose(machine_state).tip - wanted).norm());
    Eigen::Vector3d axis;
    requireSame(c.reference.textbook(c.reference.compensated(q, false), axis), wanted, 1e-5);
  }
  measureInTurn(state, kPoints, goal, ours, reference);
  state.counters["residual_mm"] = left;
}

BENCHMARK_CAPTURE(forwardKinematics, FK1_by_hand, true, 0.35)->UseManualTime();
BENCHMARK_CAPTURE(forwardKinematics, FK1_textbook, false, 0.35 * 157.0 / 474.0)->UseManualTime();
BENCHMARK_CAPTURE(correctPoint, CO1_textbook, false, 1.0 / 6.0)->UseManualTime();
BENCHMARK_CAPTURE(correctPoint, CO1_by_hand, true, 2085.0 / 6.0 / 875.0)->UseManualTime();

}  // namespace
}  // namespace nineline::bench

BENCHMARK_MAIN();
