#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/compensation/arc_geometry.h"
#include "core/compensation/motion_planner.h"
#include "core/simulation/command_path.h"

namespace nineline::compensation {

using Eigen::Vector2d;
using nc::AxisValues;
using nc::Motion;

namespace {

Vector2d inPlane(const Motion& motion, const AxisValues& values) {
  return {values[static_cast<std::size_t>(motion.plane[0])],
          values[static_cast<std::size_t>(motion.plane[1])]};
}

/// Centre of the circle that passes closest to the points, starting from a good guess (one Gauss–Newton step
/// on distances, radius eliminated; the guess is off by micrometres, so that one step is exact to
/// picometres).
Vector2d fittedCentre(const std::vector<Vector2d>& points, const Vector2d& guess) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Vector2d& point : points) {
    const Vector2d arm = point - guess;
    const double distance = arm.norm();
    const Eigen::Vector3d row(arm.x() / distance, arm.y() / distance, 1.0);
    normal += row * row.transpose();
    right += row * distance;
  }
  const Eigen::Vector3d solution = normal.completeOrthogonalDecomposition().solve(right);
  return guess + solution.head<2>();
}

constexpr double kAlmostTurn = kTurn - 0.2;  // rad: from here on the way to the end decides how far it goes
constexpr double kShortArc = 0.05;           // mm
constexpr double kMostShift = 0.1;           // of the radius: what errors may move a centre by

void setInPlane(const Motion& motion, const Vector2d& point, AxisValues& values) {
  values[static_cast<std::size_t>(motion.plane[0])] = point.x();
  values[static_cast<std::size_t>(motion.plane[1])] = point.y();
}

double sweepAbout(const Vector2d& centre, const Vector2d& a, const Vector2d& b, double like) {
  const Vector2d from = a - centre;
  const Vector2d to = b - centre;
  const double angle = std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
  return angle + kTurn * std::round((like - angle) / kTurn);
}

}  // namespace

Result<bool> MotionPlanner::arcFits(const Motion& motion, const Node& a, const Node& b, Piece& piece) {
  const double part = b.fraction - a.fraction;
  const int inner = std::max(innerSamples(motion, a, b),
                             2 + static_cast<int>(std::abs(motion.sweep) * part / (0.25 * kPi)));
  const AxisValues from = simulation::valuesOf(machine_, a.corrected, motion.tool_centre_point);
  // A whole turn must end where it starts, and an arc of a few increments must not turn about: these keep the
  // way from start to end that the program states. The start may be off by its rounding.
  const Vector2d ideal_start = inPlane(motion, positionAt(motion, machine_.jointCount(), a.fraction));
  const Vector2d ideal_end = inPlane(motion, positionAt(motion, machine_.jointCount(), b.fraction));
  const Vector2d way = ideal_end - ideal_start;
  const double bend = (inPlane(motion, piece.end) - inPlane(motion, from) - way).norm();
  const double turn = std::abs(motion.sweep) * part;
  const double arc_length = turn * (ideal_start - Vector2d(motion.centre[0], motion.centre[1])).norm();
  if (turn > kAlmostTurn && bend > options_.tolerance && scope_.may_split) return false;
  piece.closes = turn > kAlmostTurn || (arc_length < kShortArc && bend > 0.25 * way.norm());
  if (piece.closes) setInPlane(motion, inPlane(motion, from) + way, piece.end);
  std::vector<Node> nodes;
  std::vector<Vector2d> points = {inPlane(motion, from), inPlane(motion, piece.end)};
  for (int i = 1; i <= inner; ++i) {
    const Result<Node> node = solveAt(motion, a.fraction + part * i / (inner + 1));
    if (!node) return node.error();
    nodes.push_back(*node);
    points.push_back(
        inPlane(motion, simulation::valuesOf(machine_, node->corrected, motion.tool_centre_point)));
  }
  const Vector2d nominal(motion.centre[0], motion.centre[1]);
  const Vector2d guess =
      nominal + points[0] - inPlane(motion, positionAt(motion, machine_.jointCount(), a.fraction));
  // A short arc says little about its centre: what the words round must not carry it away.
  Vector2d fitted = fittedCentre(points, guess);
  const double radius = (ideal_start - nominal).norm();
  if (!((fitted - guess).norm() <= kMostShift * radius)) fitted = guess;
  const Vector2d centre = centreBetween(points[0], points[1], fitted);
  piece.arc = true;
  piece.centre = {centre.x(), centre.y()};
  piece.sweep = sweepAbout(centre, points[0], points[1], motion.sweep * part);

  Motion arc = motion;
  arc.start = from;
  arc.end = piece.end;
  arc.centre = piece.centre;
  arc.sweep = piece.sweep;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double u = static_cast<double>(i + 1) / (inner + 1);
    const Result<JointPositions> on_arc =
        simulation::jointsOf(machine_, positionAt(arc, machine_.jointCount(), u), motion.tool_centre_point);
    if (!on_arc) return on_arc.error();
    double tilt = 0.0;
    const double off = distance(*on_arc, nodes[i].corrected, tilt);
    if (off > options_.tolerance || tilt > options_.angle_tolerance) return false;
  }
  return true;
}

}  // namespace nineline::compensation
