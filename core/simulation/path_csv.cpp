#include <fmt/format.h>

#include <iterator>

#include "core/base/units.h"
#include "core/simulation/simulation.h"

namespace nineline::simulation {

std::string pathCsvHeader(const Machine& machine) {
  std::string head = "block_1,s_mm,t_s,rapid_1";
  for (const kinematics::Joint& joint : machine.joints()) {
    head +=
        fmt::format(",{}_{}", joint.axis.text(), joint.type == kinematics::JointType::Rotary ? "deg" : "mm");
  }
  for (const char* which : {"ideal", "actual"}) {
    for (const char* axis : {"x", "y", "z"}) head += fmt::format(",{}_{}_mm", which, axis);
  }
  for (const char* which : {"ideal", "actual"}) {
    for (const char* axis : {"i", "j", "k"}) head += fmt::format(",{}_{}_1", which, axis);
  }
  head += ",dev_x_um,dev_y_um,dev_z_um";
  for (const kinematics::Joint& joint : machine.joints()) {
    head += fmt::format(",err_{}_{}", joint.axis.text(),
                        joint.type == kinematics::JointType::Rotary ? "arcsec" : "um");
  }
  return head + "\n";
}

void appendPathCsvRow(const Machine& machine, const PathSample& sample, std::string& out) {
  auto to = std::back_inserter(out);
  const auto number = [&](double value, int decimals) { fmt::format_to(to, ",{:.{}f}", value, decimals); };
  fmt::format_to(to, "{}", sample.line);
  number(sample.s, 6);
  number(sample.t, 6);
  fmt::format_to(to, ",{}", sample.rapid ? 1 : 0);
  for (int i = 0; i < machine.jointCount(); ++i) {
    const double q = sample.q[static_cast<std::size_t>(i)];
    number(machine.isRotary(i) ? degFromRad(q) : q, 9);
  }
  for (const ToolPose* pose : {&sample.ideal, &sample.actual}) {
    for (int k = 0; k < 3; ++k) number(pose->tip[k], 9);
  }
  for (const ToolPose* pose : {&sample.ideal, &sample.actual}) {
    for (int k = 0; k < 3; ++k) number(pose->axis[k], 12);
  }
  for (int k = 0; k < 3; ++k) number(umFromMm(sample.deviation.tip[k]), 6);
  for (int i = 0; i < machine.jointCount(); ++i) {
    const double error = sample.deviation.joints[static_cast<std::size_t>(i)];
    number(machine.isRotary(i) ? arcsecFromRad(error) : umFromMm(error), 6);
  }
  out += '\n';
}

}  // namespace nineline::simulation
