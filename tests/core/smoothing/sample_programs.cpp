#include "tests/core/smoothing/sample_programs.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/base/units.h"
#include "core/kinematics/machine_file.h"

namespace nineline::smoothing::testing {

ReadPath readBack(const Machine& machine, const std::string& text, const nc::InterpreterOptions& setup) {
  nc::MemoryText source("out.nc", text);
  nc::Interpreter interpreter(source, setup);
  ReadPath path;
  while (true) {
    const Result<const nc::ExecutedBlock*> block = interpreter.next();
    if (!block) throw std::runtime_error(block.error().message());
    if (*block == nullptr) return path;
    for (const nc::Motion& motion : (*block)->motions) {
      if (motion.kind != nc::MotionKind::Linear) continue;
      if (path.tips.empty()) {
        path.values.push_back(motion.start);
        path.tips.push_back(tipOf(machine, motion.start, motion.tool_centre_point));
      }
      path.values.push_back(motion.end);
      path.tips.push_back(tipOf(machine, motion.end, motion.tool_centre_point));
    }
  }
}

const Machine& machineNamed(const std::string& id) {
  const Machine* machine = kinematics::findBuiltInMachine(id);
  if (machine == nullptr) throw std::runtime_error(id);
  return *machine;
}

nc::InterpreterOptions setupOf(const Machine& machine) {
  nc::InterpreterOptions setup;
  setup.axes.count = machine.jointCount();
  for (int i = 0; i < machine.jointCount(); ++i)
    setup.axes.axes[static_cast<std::size_t>(i)] = {machine.joint(i).axis, machine.isRotary(i), false};
  return setup;
}

nc::InterpreterOptions impellerSetup() {
  const Machine& machine = machineNamed("trunnion-ac");
  nc::InterpreterOptions setup = setupOf(machine);
  setup.work_offsets["G54"][static_cast<std::size_t>(machine.find({'Z', 0}))] = 85.0;
  return setup;
}

ImpellerPoint impellerAt(double t) {
  const double rho = 25.0 + 20.0 * t + 35.0 * t * t;
  const double psi = 1.1 * t + 0.25 * std::sin(2.2 * t);
  return {{rho * std::cos(psi), rho * std::sin(psi), 60.0 - 75.0 * t + 30.0 * t * t + 85.0},
          radFromDeg(35.0 + 30.0 * t - 12.0 * t * t + 4.0 * std::sin(5.0 * t)),
          radFromDeg(-40.0 + 95.0 * t + 10.0 * std::sin(4.0 * t))};
}

std::string impellerProgram(int points, int decimals) {
  std::string text = "%\nO1000 (IMPELLER)\nG90 G54 G21 G94\nM3 S8000\n";
  for (int i = 0; i < points; ++i) {
    const ImpellerPoint point = impellerAt(static_cast<double>(i) / (points - 1));
    const Vector3d machine = Eigen::AngleAxisd(-point.a, Vector3d::UnitX()) *
                             (Eigen::AngleAxisd(-point.c, Vector3d::UnitZ()) * point.tip);
    text += fmt::format("{} X{:.{}f} Y{:.{}f} Z{:.{}f} A{:.{}f} C{:.{}f}{}\n",
                        i == 0   ? "G0"
                        : i == 1 ? "G1"
                                 : "",
                        machine.x(), decimals, machine.y(), decimals, machine.z() - 85.0, decimals,
                        degFromRad(point.a), decimals, degFromRad(point.c), decimals, i == 1 ? " F3000" : "");
  }
  return text + "M5\nM30\n%\n";
}

double distanceToImpeller(const Vector3d& tip) {
  double best_t = 0.0;
  double best = 1e9;
  for (int i = 0; i <= 400; ++i) {
    const double d = (impellerAt(i / 400.0).tip - tip).norm();
    if (d < best) best = d, best_t = i / 400.0;
  }
  for (double step = 1.0 / 400.0; step > 1e-10; step *= 0.6) {
    for (const double t : {std::max(0.0, best_t - step), std::min(1.0, best_t + step)}) {
      const double d = (impellerAt(t).tip - tip).norm();
      if (d < best) best = d, best_t = t;
    }
  }
  return best;
}

}  // namespace nineline::smoothing::testing
