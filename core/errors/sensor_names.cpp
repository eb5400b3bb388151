#include "core/errors/sensor_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <vector>

namespace nineline::errors {

namespace {

/// A word in a sensor's name, and the effects that such a sensor drives.
struct SensorWord {
  std::string_view word;
  std::array<std::string_view, 4> effects;
};

constexpr std::array kWords{
    SensorWord{"screw", {"thermal_screw"}},
    SensorWord{"nut", {"thermal_screw"}},
    SensorWord{"motor", {"thermal_screw", "thermal_head", "thermal_tilt"}},
    SensorWord{"scale", {"thermal_scale"}},
    SensorWord{"glass", {"thermal_scale"}},
    SensorWord{"head", {"thermal_head", "thermal_tilt"}},
    SensorWord{"spindle", {"thermal_head", "thermal_tilt"}},
    SensorWord{"bearing", {"thermal_head", "thermal_screw"}},
    SensorWord{"column", {"thermal_head", "thermal_tilt"}},
    SensorWord{"bed", {"thermal_head", "thermal_ambient", "thermal_tilt"}},
    SensorWord{"amb", {"thermal_ambient"}},
    SensorWord{"room", {"thermal_ambient"}},
    SensorWord{"hall", {"thermal_ambient"}},
    SensorWord{"air", {"thermal_ambient", "dead_path", "air_wavelength"}},
    SensorWord{"cool", {"coolant", "thermal_workpiece"}},
    SensorWord{"oil", {"thermal_head", "thermal_screw", "thermal_tilt"}},
    SensorWord{"work", {"thermal_workpiece", "material_temperature"}},
    SensorWord{"part", {"thermal_workpiece", "material_temperature"}},
    SensorWord{"mat", {"material_temperature"}},
};

std::vector<std::string> partsOf(std::string_view column) {
  std::vector<std::string> parts(1);
  for (const char letter : column) {
    if (letter == '_') {
      parts.emplace_back();
    } else {
      parts.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    }
  }
  return parts;
}

/// The axis that a column names by a part of its own ("temp_screw_Z_C"); the unit at the end is none.
std::optional<AxisId> axisOf(std::string_view column) {
  const std::size_t unit = column.rfind('_');
  std::optional<AxisId> found;
  for (const std::string& part : partsOf(column.substr(0, unit))) {
    if (const std::optional<AxisId> axis = parseAxisId(part)) found = axis;
  }
  return found;
}

}  // namespace

bool suitsSensor(const EffectSpec& spec, const AxisId& axis, std::string_view column) {
  const bool temperature = column.starts_with("temp_") && column.ends_with("_C");
  const bool switched = column.ends_with("_1") && column != "pass_1" && !column.starts_with("approach_");
  if (!temperature && !switched) return false;
  const bool follows_switches = spec.id == "coolant" || spec.id == "thermal_head";
  if (switched && !follows_switches) return false;
  if (const std::optional<AxisId> named = axisOf(column); named && (spec.sites & kEachWay) == 0) {
    if (!(*named == axis)) return false;
  }
  bool known = false;
  for (const SensorWord& word : kWords) {
    for (const std::string& part : partsOf(column)) {
      if (!part.starts_with(word.word)) continue;
      known = true;
      if (std::find(word.effects.begin(), word.effects.end(), spec.id) != word.effects.end()) return true;
    }
  }
  if (known) return false;
  return temperature ? spec.id != "coolant" : true;
}

}  // namespace nineline::errors
