#include "core/postprocessing/axis_moves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace nineline::postprocessing {

namespace {

constexpr int kDeepest = 16;  // halvings of one step
constexpr double kStray =
    0.02;  // rad that a solved middle may lie off the mean of its ends beyond their half
constexpr double kStanding = 1e-9;  // mm

class MoveMaker {
 public:
  MoveMaker(const PoseSolver& solver, const ClProgram& program, const PathPlan& plan,
            const MoveOptions& options)
      : solver_(solver), machine_(solver.machine()), program_(program), plan_(plan), options_(options) {}

  Result<AxisMoves> run() {
    std::size_t event = 0;
    for (std::size_t i = 0; i < program_.points.size(); ++i) {
      for (; event < program_.events.size() && program_.events[event].before <= i; ++event) {
        if (program_.events[event].kind == ClEvent::Kind::SpindleOn)
          spindle_ = program_.events[event].value / 60.0;
      }
      if (i > 0) last_target_ = target(i - 1);
      if (program_.points[i].kind == ClPoint::Kind::From) continue;
      if (Result<void> added = addStep(i); !added) return added.error();
    }
    return std::move(out_);
  }

 private:
  TipAxis target(std::size_t i) const { return {program_.points[i].tip, program_.points[i].axis}; }

  Result<void> addStep(std::size_t i) {
    const ClPoint& point = program_.points[i];
    const Result<double> feed = feedOf(point);
    if (!feed) return feed.error();
    AxisMove move;
    move.point = i;
    move.rapid = point.rapid;
    move.feed = point.rapid ? 0.0 : *feed;
    move.starts_known = i > 0;
    if (i > 0 && !point.rapid) {
      const Result<void> split_up =
          split(plan_.points[i - 1].q, target(i - 1), i, plan_.points[i].q, target(i), 0);
      if (!split_up) return split_up;
    }
    addMove(move, plan_.points[i].q, target(i));
    return {};
  }

  void addMove(AxisMove move, const JointPositions& q, const TipAxis& to) {
    move.q = q;
    if (move.starts_known) {
      const JointPositions& before =
          out_.moves.empty() ? plan_.points[move.point - 1].q : out_.moves.back().q;
      move.length = (to.tip - last_target_.tip).norm();
      if (!move.rapid) setTime(before, move);
    }
    last_target_ = to;
    out_.moves.push_back(move);
  }

  /// Feed along the tip's way; where the tip stands, F counts degrees of the fastest rotary axis.
  void setTime(const JointPositions& before, AxisMove& move) {
    double turn = 0.0;
    double slowest = 0.0;
    for (int j = 0; j < machine_.jointCount(); ++j) {
      const auto k = static_cast<std::size_t>(j);
      const double way = std::abs(move.q[k] - before[k]);
      if (machine_.isRotary(j)) turn = std::max(turn, way);
      if (const auto& speed = machine_.joint(j).rapid_speed; speed && *speed > 0.0)
        slowest = std::max(slowest, way / *speed);
    }
    move.time = move.length > kStanding ? move.length / move.feed : degFromRad(turn) / move.feed;
    if (slowest > move.time * (1.0 + 1e-9)) {
      move.time = slowest;
      ++out_.slowed;
    }
    out_.time += move.time;
  }

  Result<double> feedOf(const ClPoint& point) const {
    if (point.rapid) return 0.0;
    if (point.feed_kind == ClFeed::PerMinute) return *point.feed;
    if (spindle_ > 0.0) return *point.feed * spindle_;
    return badInput("post.feed", "A feed per turn needs the speed of the spindle, expected SPINDL before.",
                    {}, point.line);
  }

  /// Largest deviations of the axes' straight line from the way between two poses.
  bool isStraight(const JointPositions& q0, const TipAxis& from, const JointPositions& q1, const TipAxis& to,
                  bool axis_free) {
    double tip = 0.0;
    double axis = 0.0;
    for (const double s : {0.5, 0.25, 0.75, 0.375, 0.625, 0.125, 0.875}) {  // the worst places first
      JointPositions q{};
      for (std::size_t k = 0; k < kMaxAxes; ++k) q[k] = q0[k] + s * (q1[k] - q0[k]);
      const TipAxis pose = solver_.chain().at(q);
      const TipAxis wanted = between(from, to, s);
      tip = std::max(tip, (pose.tip - wanted.tip).norm());
      axis = std::max(axis, angleBetween(pose.axis, wanted.axis));
      if (!options_.tip_control && tip > options_.chord_tolerance) return false;
      if (!axis_free && axis > options_.axis_deviation) return false;
    }
    if (!options_.tip_control) out_.largest_chord = std::max(out_.largest_chord, tip);
    return true;
  }

  Result<void> split(const JointPositions& q0, const TipAxis& from, std::size_t i, const JointPositions& q1,
                     const TipAxis& to, int depth) {
    const bool held = plan_.points[i].turned;
    if (isStraight(q0, from, q1, to, held)) return {};
    const std::size_t line = program_.points[i].line;
    if (depth == kDeepest || out_.moves.size() >= options_.most_moves)
      return noAnswer("post.chord",
                      "The axes cannot follow the way to this point within the chord tolerance.", {}, line);
    JointPositions mean{};
    for (std::size_t k = 0; k < kMaxAxes; ++k) mean[k] = 0.5 * (q0[k] + q1[k]);
    const TipAxis middle = between(from, to, 0.5);
    const Solution solution = held ? solver_.holdTip(middle, mean) : solver_.solve(middle, mean);
    if (!solution.converged || strays(q0, q1, mean, solution.q) ||
        machine_.firstOutsideTravel(solution.q) >= 0)
      return noAnswer(
          "post.chord",
          "Between the point before and this one the axes would have to leave their branch or travel.", {},
          line);
    if (Result<void> first = split(q0, from, i, solution.q, middle, depth + 1); !first) return first;
    AxisMove move;
    move.point = i;
    move.inserted = true;
    move.feed = *feedOf(program_.points[i]);
    addMove(move, solution.q, middle);
    ++out_.inserted;
    return split(solution.q, middle, i, q1, to, depth + 1);
  }
  bool strays(const JointPositions& q0, const JointPositions& q1, const JointPositions& mean,
              const JointPositions& q) const {
    for (int j = 0; j < machine_.jointCount(); ++j) {
      const auto k = static_cast<std::size_t>(j);
      if (machine_.isRotary(j) && std::abs(q[k] - mean[k]) > 0.5 * std::abs(q1[k] - q0[k]) + kStray)
        return true;
    }
    return false;
  }

  const PoseSolver& solver_;
  const Machine& machine_;
  const ClProgram& program_;
  const PathPlan& plan_;
  MoveOptions options_;
  AxisMoves out_;
  TipAxis last_target_;   // where the motion before ends
  double spindle_ = 0.0;  // turns a second
};

}  // namespace

Result<AxisMoves> makeMoves(const PoseSolver& solver, const ClProgram& program, const PathPlan& plan,
                            const MoveOptions& options) {
  NL_EXPECTS(plan.points.size() == program.points.size());
  return MoveMaker(solver, program, plan, options).run();
}

}  // namespace nineline::postprocessing
