#include "ui/models/path_curves.h"

#include "core/base/units.h"

namespace nineline::models {

namespace {

constexpr std::size_t kMostPoints = 20000;

double shown(bool rotary, double value) { return rotary ? degFromRad(value) : value; }

}  // namespace

PathCurve pathCurve(const kinematics::Machine& machine, const std::vector<simulation::PathSample>& samples,
                    const std::vector<simulation::PathSample>& commands, int joint, Abscissa abscissa) {
  PathCurve curve;
  const bool rotary = joint >= 0 && machine.isRotary(joint);
  const auto j = static_cast<std::size_t>(joint < 0 ? 0 : joint);
  const std::size_t stride = samples.size() / kMostPoints + 1;
  for (std::size_t i = 0; i < samples.size() && i < commands.size(); i += stride) {
    const simulation::PathSample& sample = samples[i];
    if (sample.rapid) continue;
    switch (abscissa) {
      case Abscissa::Length:
        curve.x.push_back(sample.s);
        break;
      case Abscissa::Time:
        curve.x.push_back(sample.t);
        break;
      case Abscissa::Position:
        curve.x.push_back(shown(machine.isRotary(static_cast<int>(j)), commands[i].q[j]));
        break;
    }
    const double error = joint < 0 ? sample.deviation.tip.norm() : sample.deviation.joints[j];
    curve.y.push_back(rotary ? arcsecFromRad(error) : umFromMm(error));
  }
  return curve;
}

}  // namespace nineline::models
