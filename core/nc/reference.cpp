#include <fmt/format.h>

#include <cmath>

#include "core/nc/execution.h"
#include "core/nc/nc_error.h"

namespace nineline::nc {

bool executeReferenceReturn(Execution& e) {
  const bool second = e.words.non_modal_code == 300;
  const double p = second ? e.words.of('P', 2.0) : 1.0;
  if (second && !(p >= 2.0 && p <= 4.0))
    return failAt(e, code::kBadValue, 'P', fmt::format("There is no reference point {}", p));
  const int point = static_cast<int>(p);
  if (e.words.axes == 0 && e.dialect != Dialect::LinuxCnc) {
    return failAt(e, code::kMissingWord, 'G', "G28 needs the axes that shall return");
  }
  const auto known = e.options.reference_points.find(point);
  if (known == e.options.reference_points.end() && second) {
    warnOnce(e, code::kAssumed,
             fmt::format("The reference point {} is not given; it is taken as zero", point));
  }
  const AxisValues home = known != e.options.reference_points.end() ? known->second : AxisValues{};
  e.motions.clear();
  WordFrame frame = e.frame;
  frame.incremental = static_cast<AxisMask>(frame.incremental | e.words.increments);
  if (e.words.axes != 0) {
    const AxisValues between = endOfWords(e, frame);
    if (between != e.position) appendStraight(e, MotionKind::Rapid, MotionRole::Machine, between);
  }
  AxisValues end = e.position;
  for (int i = 0; i < e.options.axes.count; ++i) {
    if (e.words.axes != 0 && !contains(e.words.axes, i)) continue;
    end[index(i)] = home[index(i)];
    e.established |= axisBit(i);
  }
  appendStraight(e, MotionKind::Rapid, MotionRole::Machine, end);
  e.executed.motions = e.motions;
  return true;
}

}  // namespace nineline::nc
