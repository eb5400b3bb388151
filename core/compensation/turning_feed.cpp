#include "core/compensation/turning_feed.h"

#include <cmath>

#include "core/base/units.h"
#include "core/compensation/arc_geometry.h"

namespace nineline::compensation {

namespace {

constexpr double kStandstill = 1e-9;  // mm, rad
constexpr double kSlight = 1e-3;      // of the turning speed
constexpr double kSecondsPerMinute = 60.0;

}  // namespace

Travel travelOf(const nc::AxisValues& from, const nc::AxisValues& to, const nc::AxisLayout& layout) {
  double linear = 0.0;
  double turned = 0.0;
  for (int i = 0; i < layout.count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    (layout.axes[k].rotary ? turned : linear) += (to[k] - from[k]) * (to[k] - from[k]);
  }
  return {std::sqrt(linear), std::sqrt(turned)};
}

bool turnsAlone(const nc::Motion& motion, const nc::AxisLayout& layout) {
  if (motion.kind != nc::MotionKind::Linear || motion.tool_centre_point) return false;
  const Travel travel = travelOf(motion.start, motion.end, layout);
  return travel.linear <= kStandstill && travel.turned > kStandstill;
}

TurnWriting turnWritingOf(const nc::Motion& motion, const nc::AxisLayout& layout,
                          std::optional<nc::Dialect> stated, nc::Dialect recognised, TurningFeed wanted) {
  if (!turnsAlone(motion, layout)) return TurnWriting::NoTurn;
  // F states the time of the block; only LinuxCNC moves at 0.1 mm/min at least, too fast for a micrometre.
  if (motion.feed_mode == nc::FeedMode::InverseTime && recognised != nc::Dialect::LinuxCnc &&
      wanted == TurningFeed::Auto)
    return TurnWriting::NoTurn;
  const bool known = motion.feed_mode == nc::FeedMode::PerMinute && motion.feed > 0.0;
  if (wanted == TurningFeed::Alone || !known) return TurnWriting::Alone;
  if (stated == nc::Dialect::Fanuc) return TurnWriting::KeepFeed;
  if (stated == nc::Dialect::LinuxCnc) return TurnWriting::RestateFeed;
  return TurnWriting::Alone;
}

bool isSlight(const Travel& travel, double feed_unit) {
  const double ratio = travel.linear / feed_unit / degFromRad(travel.turned);
  return ratio * ratio <= 2.0 * kSlight;  // √(1 + ratio²) − 1 ≤ ratio²/2
}

double feedWordOf(const nc::Motion& motion, bool degrees) {
  const double per_minute = motion.feed * kSecondsPerMinute;
  return degrees ? degFromRad(per_minute) : per_minute / motion.feed_unit;
}

double restatedFeed(double word, const Travel& travel, double feed_unit) {
  return word * travel.linear / feed_unit / degFromRad(travel.turned);
}

int decimalsOf(double value) {
  constexpr int kMost = 9;
  int decimals = 0;
  while (decimals < kMost && std::abs(roundTo(value, decimals) - value) > 1e-12 * std::abs(value)) ++decimals;
  return decimals;
}

}  // namespace nineline::compensation
