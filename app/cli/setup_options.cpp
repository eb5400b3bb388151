#include "app/cli/setup_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>

#include "app/cli/option_values.h"
#include "core/base/text.h"
#include "core/base/units.h"

namespace nineline::cli {

namespace {

using kinematics::JointPositions;
using kinematics::Machine;
using simulation::ProgramSetup;

constexpr std::array<std::string_view, 9> kUnitEndings{"_mm", "_um", "_deg",    "_arcsec", "_s",
                                                       "_C",  "_1",  "_mm_min", "_kg"};

bool hasUnit(std::string_view name) {
  return std::any_of(kUnitEndings.begin(), kUnitEndings.end(), [name](std::string_view ending) {
    return name.size() > ending.size() && name.ends_with(ending);
  });
}

Result<void> setState(errors::MachineState& state, std::string_view key, double value) {
  if (!hasUnit(key)) {
    return usageError("usage.state", fmt::format("--state: '{}' ends in no unit, expected the name of a "
                                                 "column such as temp_screw_Z_C, pass_1, load_kg or t_s.",
                                                 printable(key)));
  }
  if (key == "pass_1") {
    state.pass = value;
  } else if (key == "load_kg") {
    state.load = value;
  } else if (key == "t_s") {
    state.time = value;
  } else if (key == "feed_mm_min") {
    state.feed = perSecondFromPerMinute(value);
  } else {
    state.conditions.emplace_back(key, value);
  }
  return {};
}

/// "X=10,C=90" (mm, deg) into joint positions.
Result<void> setAxes(std::string_view option, std::string_view text, const Machine& machine,
                     JointPositions& positions) {
  return forEachAssignment(option, text, [&](std::string_view key, double value) -> Result<void> {
    const std::optional<AxisId> axis = parseAxisId(key);
    const int joint = axis ? machine.find(*axis) : -1;
    if (joint < 0) {
      return usageError("usage.axis", fmt::format("{}: '{}' is no axis of the machine '{}'.", option,
                                                  printable(key), machine.id()));
    }
    positions[static_cast<std::size_t>(joint)] = machine.isRotary(joint) ? radFromDeg(value) : value;
    return {};
  });
}

Result<void> setWorkOffset(std::string_view text, const Machine& machine, ProgramSetup& setup) {
  const std::size_t colon = text.find(':');
  const std::string name = upper(trimmed(text.substr(0, colon)));
  if (colon == std::string_view::npos || !name.starts_with('G')) {
    return usageError("usage.work_offset",
                      fmt::format("--work-offset: '{}' stands there, expected for example G54:X=10,Z=300.",
                                  printable(text)));
  }
  return setAxes("--work-offset", text.substr(colon + 1), machine, setup.work_offsets[name]);
}

Result<void> setToolLength(std::string_view text, ProgramSetup& setup) {
  return forEachAssignment("--tool-length", text, [&](std::string_view key, double value) -> Result<void> {
    const bool has_letter = key.starts_with('H') || key.starts_with('h') || key.starts_with('T');
    const std::optional<long long> number = parseInteger(has_letter ? key.substr(1) : key);
    if (!number || *number < 0 || *number > 99999) {
      return usageError(
          "usage.tool_length",
          fmt::format("--tool-length: '{}' stands there, expected for example H1=120.", printable(text)));
    }
    setup.tool_lengths[static_cast<int>(*number)] = value;
    return {};
  });
}

std::optional<nc::Dialect> dialectNamed(const std::string& name) {
  if (name == "fanuc") return nc::Dialect::Fanuc;
  if (name == "siemens") return nc::Dialect::Siemens;
  if (name == "linuxcnc") return nc::Dialect::LinuxCnc;
  return std::nullopt;
}

}  // namespace

void addSetupOptions(CLI::App& app, SetupOptions& options) {
  const auto many = [&app](const char* name, std::vector<std::string>& target, const char* what,
                           const char* type) {
    app.add_option(name, target, what)->allow_extra_args(false)->type_name(type);
  };
  many("--state", options.states, "What holds while the program runs, for example temp_screw_Z_C=21.5",
       "KEY=VALUE");
  many("--work-offset", options.work_offsets, "Zero of a work coordinate system, mm and deg",
       "G54:X=10,Z=300");
  many("--tool-length", options.tool_lengths, "Length of a tool, mm", "H1=120");
  many("--start", options.starts, "Machine position before the first block, mm and deg", "X=1,Z=2");
  app.add_option("--dialect", options.dialect, "How to read the program; by itself it is recognised")
      ->check(CLI::IsMember({"fanuc", "siemens", "linuxcnc"}))
      ->type_name("fanuc|siemens|linuxcnc");
  app.add_flag("--block-skip", options.block_skip, "Leave out the blocks that begin with '/'");
}

Result<ProgramSetup> setupFrom(const SetupOptions& options, const Machine& machine) {
  ProgramSetup setup;
  setup.dialect = dialectNamed(options.dialect);
  setup.block_skip = options.block_skip;
  const auto state = [&setup](std::string_view key, double value) {
    return setState(setup.state, key, value);
  };
  for (const std::string& text : options.states) {
    if (Result<void> set = forEachAssignment("--state", text, state); !set) return set.error();
  }
  for (const std::string& text : options.starts) {
    if (Result<void> set = setAxes("--start", text, machine, setup.start); !set) return set.error();
  }
  for (const std::string& text : options.work_offsets) {
    if (Result<void> set = setWorkOffset(text, machine, setup); !set) return set.error();
  }
  for (const std::string& text : options.tool_lengths) {
    if (Result<void> set = setToolLength(text, setup); !set) return set.error();
  }
  return setup;
}

}  // namespace nineline::cli
