#include "core/nc/machine_variables.h"

#include "core/base/units.h"
#include "core/nc/characters.h"

namespace nineline::nc {
namespace {

constexpr std::string_view kLinuxCncAxes = "XYZABCUVW";
constexpr std::string_view kFanucAxes = "XYZ";

}  // namespace

std::optional<double> MachineVariables::wordOf(char letter) const {
  Execution& e = *execution_;
  const int axis = e.axis_of_letter[letterIndex(letter)];
  if (axis < 0) return e.dialect == Dialect::LinuxCnc ? std::optional(0.0) : std::nullopt;
  if (e.frame_stale) refreshFrame(e);
  return e.frame.wordsOf(e.position, e.options.axes.count)[index(axis)];
}

std::optional<double> MachineVariables::machineOf(char letter) const {
  Execution& e = *execution_;
  const int axis = e.axis_of_letter[letterIndex(letter)];
  if (axis < 0) return e.dialect == Dialect::LinuxCnc ? std::optional(0.0) : std::nullopt;
  if (e.frame_stale) refreshFrame(e);
  return e.position[index(axis)] / e.frame.factor[index(axis)];
}

std::optional<double> MachineVariables::linuxCncNumber(int id) const {
  Execution& e = *execution_;
  if (id >= 5021 && id <= 5029) return machineOf(kLinuxCncAxes[index(id - 5021)]);
  if (id >= 5420 && id <= 5428) return wordOf(kLinuxCncAxes[index(id - 5420)]);
  if (id == 5220) return e.offsets.active + 1.0;
  if (id == 5400) return static_cast<double>(e.current_tool);
  const auto offset = [&](const AxisValues& values, int k) -> std::optional<double> {
    const int axis = e.axis_of_letter[letterIndex(kLinuxCncAxes[index(k)])];
    if (axis < 0) return 0.0;
    if (e.frame_stale) refreshFrame(e);
    return values[index(axis)] / e.frame.factor[index(axis)];
  };
  if (id >= 5211 && id <= 5219) return offset(e.offsets.suspended, id - 5211);
  if (id >= 5401 && id <= 5409) return offset(e.offsets.tool, id - 5401);
  for (int k = 0; k < 9; ++k) {
    const int first = 5221 + 20 * k;
    if (id >= first && id <= first + 8) return offset(e.offsets.work[index(k)], id - first);
    if (id == first + 9) return degFromRad(e.offsets.work_rotation[index(k)]);
  }
  return std::nullopt;
}

std::optional<double> MachineVariables::number(int id) const {
  if (id < 5000) return std::nullopt;
  if (execution_->dialect == Dialect::LinuxCnc) return linuxCncNumber(id);
  if (execution_->dialect != Dialect::Fanuc) return std::nullopt;
  // The end of the block before and the present position are the same here: nothing runs ahead.
  if ((id >= 5001 && id <= 5003) || (id >= 5041 && id <= 5043))
    return wordOf(kFanucAxes[index((id - 1) % 20)]);
  if (id >= 5021 && id <= 5023) return machineOf(kFanucAxes[index(id - 5021)]);
  return std::nullopt;
}

std::optional<double> MachineVariables::named(std::string_view name) const {
  const Execution& e = *execution_;
  if (e.dialect != Dialect::LinuxCnc || name.empty() || name.front() != '_') return std::nullopt;
  if (name.size() == 2 && kLinuxCncAxes.find(upperOf(name[1])) != std::string_view::npos)
    return wordOf(upperOf(name[1]));
  if (name.size() == 6 && name.starts_with("_abs_") &&
      kLinuxCncAxes.find(upperOf(name[5])) != std::string_view::npos) {
    return machineOf(upperOf(name[5]));
  }
  const auto truth = [](bool is) { return is ? 1.0 : 0.0; };
  if (name == "_metric") return truth(!e.modal.inch);
  if (name == "_imperial") return truth(e.modal.inch);
  if (name == "_absolute") return truth(!e.modal.incremental);
  if (name == "_incremental") return truth(e.modal.incremental);
  if (name == "_lathe_diameter_mode") return truth(e.modal.diameter);
  if (name == "_lathe_radius_mode") return truth(!e.modal.diameter);
  if (name == "_feed") return e.modal.feed_word;
  if (name == "_rpm") return e.modal.spindle_word;
  if (name == "_plane") return e.modal.plane * 10.0;
  if (name == "_motion_mode") return e.modal.cycle != 0 ? e.modal.cycle * 10.0 : e.modal.motion * 10.0;
  if (name == "_current_tool") return static_cast<double>(e.current_tool);
  if (name == "_selected_tool") return static_cast<double>(e.selected_tool);
  if (name == "_coord_system")
    return (e.offsets.active < 6 ? 540.0 + 10.0 * e.offsets.active : 585.0 + e.offsets.active);
  if (name == "_task") return 0.0;
  return std::nullopt;
}

}  // namespace nineline::nc
