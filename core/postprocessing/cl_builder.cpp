#include "core/postprocessing/cl_builder.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace nineline::postprocessing {

namespace {

constexpr double kOnCircle = 0.01;   // mm: how far the ends of an arc may lie off its circle
constexpr double kPeckRelief = 0.5;  // mm: how far above the bottom before a peck's rapid ends

}  // namespace

void ClBuilder::push(const Vector3d& tip, ClPoint::Kind kind, bool rapid, std::size_t line) {
  ClPoint point;
  point.tip = tip;
  point.axis = axis;
  point.kind = kind;
  point.rapid = rapid;
  point.feed = feed;
  point.feed_kind = feed_kind;
  point.line = line;
  program_->points.push_back(point);
  place_ = tip;
  axis_before_ = axis;
}

void ClBuilder::from(const Vector3d& tip, std::size_t line) { push(tip, ClPoint::Kind::From, true, line); }

std::string ClBuilder::moveTo(const Vector3d& tip, std::size_t line) {
  const bool rapid = std::exchange(rapid_next, false);
  ++program_->goto_count;
  if (cycle) {
    drill(tip, line);
    return {};
  }
  if (arc) {
    std::string fault = addArc(tip, line);
    arc.reset();
    return fault;
  }
  push(tip, ClPoint::Kind::Goto, rapid, line);
  return {};
}

void ClBuilder::drill(const Vector3d& tip, std::size_t line) {
  const std::optional<double> feed_before = feed;
  const ClFeed kind_before = feed_kind;
  if (cycle->feed) {
    feed = cycle->feed;
    feed_kind = cycle->feed_kind;
  }
  const double step = cycle->step > 0.0 ? cycle->step : cycle->depth + cycle->clearance;
  push(tip + cycle->clearance * axis, ClPoint::Kind::Goto, true, line);
  for (double depth = 0.0; depth < cycle->depth;) {
    if (depth > 0.0) {
      push(tip + cycle->clearance * axis, ClPoint::Kind::Cycle, true, line);
      push(tip - std::max(depth - kPeckRelief, 0.0) * axis, ClPoint::Kind::Cycle, true, line);
    }
    depth = std::min(depth + step, cycle->depth);
    push(tip - depth * axis, ClPoint::Kind::Cycle, false, line);
  }
  if (cycle->dwell > 0.0) addEvent({ClEvent::Kind::Dwell, 0, cycle->dwell, 0, {}, line});
  push(tip + cycle->retract.value_or(cycle->clearance) * axis, ClPoint::Kind::Cycle, true, line);
  feed = feed_before;
  feed_kind = kind_before;
}

std::string ClBuilder::addArc(const Vector3d& tip, std::size_t line) {
  const Vector3d n = arc->normal;
  const auto inPlane = [&](const Vector3d& p) -> Vector3d {
    return p - arc->centre - n * n.dot(p - arc->centre);
  };
  if (!place_) return "An arc needs a point to start from, found CIRCLE before any GOTO or FROM.";
  const Vector3d start = *place_;
  const Vector3d u = inPlane(start);
  const Vector3d v = inPlane(tip);
  if (std::abs(u.norm() - arc->radius) > kOnCircle || std::abs(v.norm() - arc->radius) > kOnCircle) {
    return fmt::format(
        "The arc of line {} has the radius {:.4f} mm, but its start lies {:.4f} mm and its end {:.4f} mm "
        "from its axis.",
        arc->line, arc->radius, u.norm(), v.norm());
  }
  double sweep = std::atan2(n.dot(u.cross(v)), u.dot(v));
  if (sweep < 1e-9) sweep += kTurn;  // ends where it starts: a whole turn
  const double rise = n.dot(tip - start);
  const double step = 2.0 * std::acos(std::max(0.0, 1.0 - options_.arc_tolerance / arc->radius));
  const int count = std::max(1, static_cast<int>(std::ceil(sweep / step)));
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(axis_before_, axis);
  const Vector3d axis_start = axis_before_;
  const Vector3d axis_end = axis;
  for (int i = 1; i < count; ++i) {
    const double s = static_cast<double>(i) / count;
    const Vector3d radial = Eigen::AngleAxisd(s * sweep, n) * (u + s * (v.norm() / u.norm() - 1.0) * u);
    axis = (Eigen::Quaterniond::Identity().slerp(s, turn) * axis_start).normalized();
    push(start - u + radial + s * rise * n, ClPoint::Kind::Inner, false, line);
  }
  axis = axis_end;
  push(tip, ClPoint::Kind::Goto, false, line);
  return {};
}

void ClBuilder::addEvent(ClEvent event) {
  event.before = program_->points.size();
  program_->events.push_back(std::move(event));
}

}  // namespace nineline::postprocessing
