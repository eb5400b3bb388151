#include "core/postprocessing/nc_words.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/base/units.h"
#include "core/nc/number_style.h"

namespace nineline::postprocessing {

WrittenAxes writtenAxes(const Machine& machine, const NcOptions& options, const JointPositions& q,
                        const Vector3d& tip) {
  WrittenAxes axes;
  for (int j = 0; j < machine.jointCount(); ++j) {
    const auto k = static_cast<std::size_t>(j);
    const kinematics::Joint& joint = machine.joint(j);
    if (machine.isRotary(j)) {
      axes.words[k] = nc::writtenValue(degFromRad(q[k]), options.rotary_decimals);
      axes.positions[k] = radFromDeg(axes.words[k]);
      continue;
    }
    const bool is_tip = options.tip_control && joint.axis.digit == 0 && joint.axis.letter >= 'X';
    const double position = is_tip ? tip[joint.axis.letter - 'X'] : q[k];
    const double factor = joint.diameter ? 2.0 : 1.0;
    axes.words[k] = nc::writtenValue(factor * position, options.linear_decimals);
    axes.positions[k] = axes.words[k] / factor;
  }
  return axes;
}

std::string axisNumber(double value, int decimals) {
  std::array<char, nc::kLongestNumber> buffer{};
  const nc::NumberStyle style;
  const std::size_t size = nc::formatNumber(value, decimals, style, buffer);
  return std::string(buffer.data(), size);
}

std::string feedNumber(double value) {
  const int digits = value > 0.0 ? static_cast<int>(std::floor(std::log10(value))) : 0;
  return axisNumber(value, std::clamp(5 - digits, 1, 8));
}

std::string harmless(std::string_view text, Control control) {
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte == '\t') {
      result += ' ';
    } else if (byte < 0x20 || byte > 0x7E) {
      result += '?';
    } else if (control == Control::LinuxCnc && c == ',') {
      result += ' ';  // (MSG,…) and (LOGOPEN,…) are commands there
    } else if (c == '(' || c == '[' || c == '{') {
      result += '<';
    } else if (c == ')' || c == ']' || c == '}') {
      result += '>';
    } else if (c != '%' && c != ';' && c != '~') {
      result += c;
    }
  }
  return control == Control::Fanuc ? upper(result) : result;
}

}  // namespace nineline::postprocessing
