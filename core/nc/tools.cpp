#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"
#include "core/nc/execution.h"
#include "core/nc/nc_error.h"

namespace nineline::nc {
namespace {

constexpr double kMostOffsets = 100'000.0;

bool findTool(Execution& e, AxisValues& offset) {
  const bool linux_cnc = e.dialect == Dialect::LinuxCnc;
  if (!e.words.has('H') && !linux_cnc)
    return failAt(e, code::kMissingWord, 'G', "G43 needs H, the number of the length offset");
  const double h = e.words.of('H', static_cast<double>(e.current_tool));
  if (!(h >= 0.0 && h <= kMostOffsets) || h != std::floor(h))
    return failAt(e, code::kBadValue, 'H', fmt::format("There is no length offset {}", h));
  const auto found = e.offsets.tools.find(static_cast<int>(h));
  offset = found != e.offsets.tools.end() ? found->second : AxisValues{};
  if (found == e.offsets.tools.end() && h != 0.0) {
    warnOnce(e, code::kAssumed, fmt::format("The length offset H{} is not given; it is taken as zero", h));
  }
  return true;
}

}  // namespace

bool applyToolLength(Execution& e, CodeAction action) {
  AxisValues offset{};
  e.frame_stale = true;
  if (action == CodeAction::LengthOff) {
    e.offsets.tool = {};
    e.modal.tip_control = false;
    return true;
  }
  if (action == CodeAction::LengthDynamic) {
    if (e.words.axes == 0) return failAt(e, code::kMissingWord, 'G', "G43.1 needs axis words");
    for (int i = 0; i < e.options.axes.count; ++i) {
      if (contains(e.words.axes, i))
        e.offsets.tool[index(i)] = e.words.value[index(i)] * e.frame.factor[index(i)];
    }
    return true;
  }
  if (action == CodeAction::TipControl) {
    e.modal.tip_control = true;
    if (!e.words.has('H')) return true;
  }
  if (!findTool(e, offset)) return false;
  for (int i = 0; i < e.options.axes.count; ++i) {
    double& active = e.offsets.tool[index(i)];
    if (action == CodeAction::LengthMinus) {
      active = -offset[index(i)];
    } else if (action == CodeAction::LengthAdd) {
      active += offset[index(i)];
    } else {
      active = offset[index(i)];
    }
  }
  return true;
}

void changeTool(Execution& e) { e.current_tool = e.selected_tool; }

}  // namespace nineline::nc
