// Inverse kinematics and post-processing beside the closed forms, in one interleaved run (performance.md,
// IK-1…4). Usage: nineline_postprocessing_benchmark [POINTS]
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "core/base/units.h"
#include "core/kinematics/machine_file.h"
#include "core/postprocessing/branches.h"
#include "core/postprocessing/cl_reader.h"
#include "core/postprocessing/post_processor.h"

namespace nineline::postprocessing {
namespace {

using Clock = std::chrono::steady_clock;

double secondsOf(const std::function<void()>& work) {
  const auto start = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - start).count();
}
double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

/// The blade surface of theory.md, 4.7, in zig-zag rows of `columns` points.
std::vector<TipAxis> bladePath(int rows, int columns) {
  const auto surface = [](double r, double v) {
    const double th = 0.9 * v + 1.5e-4 * (r - 1200.0) + 8e-8 * (r - 1200.0) * (r - 1200.0);
    return Vector3d(r * std::cos(th), r * std::sin(th),
                    2400.0 * th / kTurn + 0.18 * (r - 1200.0) + 60.0 * (1.0 - 4.0 * v * v));
  };
  std::vector<TipAxis> path;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      const int k = i % 2 == 0 ? j : columns - 1 - j;
      const double r = 700.0 + 1100.0 * i / (rows - 1);
      const double v = -0.5 + static_cast<double>(k) / (columns - 1);
      const Vector3d along = (surface(r, v + 1e-5) - surface(r, v - 1e-5)).normalized();
      const Vector3d out = (surface(r + 1e-2, v) - surface(r - 1e-2, v));
      const Vector3d normal = out.cross(along).normalized();
      const double lean = radFromDeg(15.0);
      path.push_back({surface(r, v), (std::cos(lean) * normal + std::sin(lean) * along).normalized()});
    }
  }
  return path;
}

/// theory.md, 4.7 (12), branch (+,+); the built-in machine turns C2 against the chain of the text.
JointPositions closedPropeller(const TipAxis& pose, double before_c2, double before_c1) {
  constexpr double kTool = 420.0;
  constexpr double kHead = 150.0;
  const double px = pose.tip.x() + kTool * pose.axis.x();
  const double py = pose.tip.y() + kTool * pose.axis.y();
  const double c2 = std::atan2(py, px);
  const double tilt = std::sqrt(pose.axis.x() * pose.axis.x() + pose.axis.y() * pose.axis.y());
  const double c1 = std::atan2(pose.axis.y(), pose.axis.x()) - c2;
  return {before_c2 + std::remainder(c2 - before_c2, kTurn), pose.tip.z() + kTool * pose.axis.z() - kHead,
          std::sqrt(px * px + py * py), before_c1 + std::remainder(c1 - before_c1, kTurn),
          std::atan2(tilt, pose.axis.z())};
}

struct Run {
  std::vector<JointPositions> q;
  double worst_tip = 0.0;
  double worst_axis = 0.0;
  int iterations = 0;
  int failures = 0;
};

void solveAll(const PoseSolver& solver, const std::vector<TipAxis>& path, const JointPositions& start,
              Run& run) {
  JointPositions q = start;
  run.q.resize(path.size());
  run.iterations = run.failures = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Solution solution = solver.follow(path[i == 0 ? 0 : i - 1], q, path[i]);
    run.iterations += solution.iterations;
    run.failures += solution.converged ? 0 : 1;
    run.q[i] = q = solution.q;
  }
}

void comparePropeller(int rows, int columns, int repeats) {
  const Machine& machine = *kinematics::findBuiltInMachine("propeller-c2zxc1b1");
  const PoseSolver solver(machine);
  const std::vector<TipAxis> path = bladePath(rows, columns);
  const JointPositions start = closedPropeller(path[0], 0.0, 0.0);
  Run run;
  std::vector<JointPositions> closed(path.size());
  std::vector<double> ratio, ours, theirs;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    theirs.push_back(secondsOf([&] {
      for (std::size_t i = 0; i < path.size(); ++i)
        closed[i] =
            closedPropeller(path[i], i == 0 ? 0.0 : closed[i - 1][0], i == 0 ? 0.0 : closed[i - 1][3]);
    }));
    ours.push_back(secondsOf([&] { solveAll(solver, path, start, run); }));
    ratio.push_back(ours.back() / theirs.back());
  }
  double worst = 0.0;
  double worst_turn = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    for (const std::size_t k : {0U, 3U, 4U})
      worst_turn = std::max(worst_turn, std::abs(run.q[i][k] - closed[i][k]));
    for (const std::size_t k : {1U, 2U}) worst = std::max(worst, std::abs(run.q[i][k] - closed[i][k]));
    const TipAxis pose = solver.chain().at(run.q[i]);
    run.worst_tip = std::max(run.worst_tip, (pose.tip - path[i].tip).norm());
    run.worst_axis = std::max(run.worst_axis, angleBetween(pose.axis, path[i].axis));
  }
  const double n = static_cast<double>(path.size());
  fmt::print(
      "propeller {:8d} points: solver {:7.1f} ns, closed form {:6.1f} ns a point, ratio {:.2f}; {:.2f} "
      "iterations, {} failures; residual {:.1e} mm {:.1e} rad; against closed form {:.1e} mm {:.1e} rad\n",
      path.size(), median(ours) / n * 1e9, median(theirs) / n * 1e9, median(ratio), run.iterations / n,
      run.failures, run.worst_tip, run.worst_axis, worst, worst_turn);
}

void singularPasses() {
  const PoseSolver solver(*kinematics::findBuiltInMachine("propeller-c2zxc1b1"));
  int failures = 0;
  int points = 0;
  double seconds = 0.0;
  for (const double closest : {1e-3, 1e-5, 1e-7, 1e-9}) {
    std::vector<TipAxis> path;
    for (int i = -100; i <= 100; ++i)
      path.push_back({{900.0 + i, 40.0, -300.0}, Vector3d(2e-3 * i, closest, 1.0).normalized()});
    const auto branches = findBranches(solver, path[0], {});
    Run run;
    seconds += secondsOf([&] { solveAll(solver, path, branches[0], run); });
    failures += run.failures;
    points += static_cast<int>(path.size());
  }
  fmt::print("singular passes {} points: {:.1f} ns a point, {} failures\n", points, seconds / points * 1e9,
             failures);
}

void wholePost(int rows, int columns) {
  const std::vector<TipAxis> path = bladePath(rows, columns);
  std::string text = "SPINDL/900,RPM,CLW\nRAPID\n";
  for (std::size_t i = 0; i < path.size(); ++i) {
    const auto& [tip, axis] = path[i];
    text += fmt::format("GOTO/{:.6f},{:.6f},{:.6f},{:.9f},{:.9f},{:.9f}\n", tip.x(), tip.y(), tip.z(),
                        axis.x(), axis.y(), axis.z());
    if (i == 0) text += "FEDRAT/1000,MMPM\n";
  }
  const Machine& machine = *kinematics::findBuiltInMachine("propeller-c2zxc1b1");
  std::size_t blocks = 0;
  std::vector<double> times;
  for (int repeat = 0; repeat < 5; ++repeat) {
    times.push_back(secondsOf([&] {
      NoProgress progress;
      const Result<ClProgram> program = readClData(text, "blade.cls");
      PostOptions options;
      const Result<PostResult> result = postProcess(machine, program.value(), options, progress);
      blocks = result.value().report.blocks;
    }));
  }
  fmt::print("post, read to text: {} points, {} blocks in {:.1f} ms\n", path.size(), blocks,
             median(times) * 1e3);
}

}  // namespace
}  // namespace nineline::postprocessing

int main(int argc, char** argv) {
  using namespace nineline::postprocessing;
  const int points = argc > 1 ? std::atoi(argv[1]) : 1'000'000;
  comparePropeller(14, 60, 201);
  comparePropeller(100, std::max(2, points / 100), 5);
  singularPasses();
  wholePost(14, 60);
  wholePost(100, 100);
  return 0;
}
