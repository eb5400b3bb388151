#include "core/postprocessing/path_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/units.h"
#include "core/postprocessing/branch_tracker.h"

namespace nineline::postprocessing {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kSwitchCost = 1e3;        // mm of motion that a change of branch in a rapid is worth
constexpr double kSingularTurnCost = 1e5;  // the same for a turn in a singular pose within a cut
constexpr double kTravelSlack = 1e-9;
constexpr std::size_t kMostWound = 3;  // rotary joints whose whole turns are chosen

bool isLimited(const kinematics::Joint& joint) { return joint.travel.has_value() && !joint.continuous; }

/// An alternative with its whole turns chosen.
struct State {
  int alternative = 0;
  int track = 0;
  std::array<int, kMostWound> turns{};
  JointPositions q{};
  double cost = kInfinite;
  int parent = -1;
  bool switched = false;
  bool turned = false;
};

/// What is kept of a point for the way back.
struct Step {
  JointPositions q{};
  std::int32_t parent = -1;
  std::int16_t iterations = 0;
  bool switched = false;
  bool turned = false;
};

class Planner {
 public:
  Planner(const PoseSolver& solver, const std::vector<ClPoint>& points, const JointPositions& home,
          const PlanOptions& options)
      : solver_(solver),
        machine_(solver.machine()),
        points_(points),
        home_(home),
        options_(options),
        tracker_(solver, home) {
    for (int i = 0; i < machine_.jointCount(); ++i) {
      if (machine_.isRotary(i) && isLimited(machine_.joint(i)) && wound_.size() < kMostWound &&
          (solver.free() >> i & 1) != 0)
        wound_.push_back(static_cast<std::size_t>(i));
    }
  }

  Result<PathPlan> run(Progress& progress) {
    steps_.reserve(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (i % 1024 == 0) {
        progress.report(static_cast<double>(i) / static_cast<double>(points_.size()), "Solving the axes");
        if (progress.isCancelled()) return cancelled();
      }
      const TipAxis target{points_[i].tip, points_[i].axis};
      i == 0 ? tracker_.start(target) : tracker_.advance(target);
      std::vector<State> states = statesOf(tracker_.alternatives());
      if (states.empty() && i == 0) {
        tracker_.searchThoroughly();
        states = statesOf(tracker_.alternatives());
      }
      if (states.empty()) return unreachable(i);
      relax(i, states);
      std::erase_if(states, [](const State& state) { return state.cost == kInfinite; });
      if (states.empty()) return noWay(i);
      keep(states);
      states_ = std::move(states);
    }
    return wayBack();
  }

 private:
  /// The alternatives inside the travel, with all whole turns that the travel allows.
  std::vector<State> statesOf(const std::vector<Alternative>& alternatives) const {
    std::vector<State> states;
    for (std::size_t a = 0; a < alternatives.size(); ++a) {
      State state;
      state.alternative = static_cast<int>(a);
      state.track = alternatives[a].track;
      state.q = alternatives[a].q;
      addTurns(state, 0, states);
    }
    return states;
  }
  void addTurns(State& state, std::size_t which, std::vector<State>& states) const {
    if (states.size() >= options_.most_states) return;
    if (which == wound_.size()) {
      if (machine_.firstOutsideTravel(state.q) < 0) states.push_back(state);
      return;
    }
    const std::size_t k = wound_[which];
    const kinematics::Travel travel = *machine_.joint(static_cast<int>(k)).travel;
    const double q = state.q[k];
    const int last = static_cast<int>(std::floor((travel.high - q + kTravelSlack) / kTurn));
    for (int m = static_cast<int>(std::ceil((travel.low - q - kTravelSlack) / kTurn)); m <= last; ++m) {
      state.turns[which] = m;
      state.q[k] = q + m * kTurn;
      addTurns(state, which + 1, states);
    }
    state.q[k] = q;
    state.turns[which] = 0;
  }

  /// Way of the joints in mm, rotary ones by their length; of joints without end the shorter way.
  double motion(const JointPositions& a, const JointPositions& b) const {
    double sum = 0.0;
    for (int i = 0; i < machine_.jointCount(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      double d = b[k] - a[k];
      if (machine_.isRotary(i)) {
        if (!isLimited(machine_.joint(i))) d = std::remainder(d, kTurn);
        d *= solver_.options().rotary_length;
      }
      sum += std::abs(d);
    }
    return sum;
  }

  void relax(std::size_t i, std::vector<State>& states) const {
    if (i == 0) {
      for (State& state : states) state.cost = 1e-3 * motion(home_, state.q);
      return;
    }
    for (State& state : states) {
      for (const bool going_on : {true, false}) {  // the likely way first: it spares looking at the others
        for (std::size_t p = 0; p < states_.size(); ++p) {
          if (goesOn(states_[p], state) == going_on) tryWay(i, static_cast<int>(p), state);
        }
      }
    }
  }
  static bool goesOn(const State& before, const State& state) {
    return before.track == state.track && before.turns == state.turns;
  }
  void tryWay(std::size_t i, int parent, State& state) const {
    const State& before = states_[static_cast<std::size_t>(parent)];
    const bool goes_on = goesOn(before, state);
    double cost = before.cost + motion(before.q, state.q);
    bool turned = false;
    if (!goes_on) {
      turned = !points_[i].rapid;
      cost += turned ? kSingularTurnCost : kSwitchCost;
      if (cost >= state.cost || (turned && !mayTurn(i, before, state))) return;
    }
    if (cost >= state.cost) return;
    state.cost = cost;
    state.parent = parent;
    state.switched = !goes_on;
    state.turned = turned;
  }
  /// Whether the rotary joints may go from one branch to another within a cut: the tool axis stays within its
  /// tolerance all the way, while linear joints hold the tip.
  bool mayTurn(std::size_t i, const State& before, const State& state) const {
    if (solver_.opennessAt(before.q) > 10.0 * options_.singular_openness + options_.axis_tolerance)
      return false;
    const TipAxis from{points_[i - 1].tip, points_[i - 1].axis};
    const TipAxis to{points_[i].tip, points_[i].axis};
    const JointPositions end = nearestTurns(before.q, state.q);
    for (int n = 1; n < 16; ++n) {
      const double s = n / 16.0;
      JointPositions q{};
      for (std::size_t k = 0; k < kMaxAxes; ++k) q[k] = before.q[k] + s * (end[k] - before.q[k]);
      const Solution held = solver_.holdTip(between(from, to, s), q);
      if (!held.converged || held.axis_error > std::max(options_.axis_tolerance, 1e-9)) return false;
    }
    return true;
  }
  JointPositions nearestTurns(const JointPositions& from, JointPositions to) const {
    for (int i = 0; i < machine_.jointCount(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (machine_.isRotary(i) && !isLimited(machine_.joint(i)))
        to[k] = from[k] + std::remainder(to[k] - from[k], kTurn);
    }
    return to;
  }

  void keep(const std::vector<State>& states) {
    first_.push_back(steps_.size());
    for (const State& state : states) {
      const Alternative& one = tracker_.alternatives()[static_cast<std::size_t>(state.alternative)];
      steps_.push_back(
          {state.q, state.parent, static_cast<std::int16_t>(one.iterations), state.switched, state.turned});
    }
  }

  Result<PathPlan> wayBack() {
    PathPlan plan;
    plan.points.resize(points_.size());
    const auto best = std::ranges::min_element(states_, {}, &State::cost);
    auto at = static_cast<std::int32_t>(best - states_.begin());
    for (std::size_t i = points_.size(); i-- > 0;) {
      const Step& step = steps_[first_[i] + static_cast<std::size_t>(at)];
      plan.points[i] = {step.q, step.iterations, 1.0, step.switched, step.turned};
      at = step.parent;
    }
    for (std::size_t i = 0; i < plan.points.size(); ++i) {
      PlannedPoint& point = plan.points[i];
      if (i > 0) point.q = nearestTurns(plan.points[i - 1].q, point.q);
      point.openness = solver_.opennessAt(point.q);
      plan.singular += point.openness < options_.singular_openness ? 1 : 0;
      if (!point.switched) continue;
      ++plan.switches;
      plan.warnings.countedWarning("post.switch",
                                   point.turned ? "The rotary axes turn on the spot in a singular pose."
                                                : "The rotary axes change to another branch in a rapid.",
                                   points_[i].line);
    }
    return plan;
  }

  Error unreachable(std::size_t i) const {
    const ClPoint& point = points_[i];
    const std::string where =
        fmt::format("({:.4f} {:.4f} {:.4f}), axis ({:.6f} {:.6f} {:.6f})", point.tip.x(), point.tip.y(),
                    point.tip.z(), point.axis.x(), point.axis.y(), point.axis.z());
    if (tracker_.alternatives().empty())
      return noAnswer("post.unreachable",
                      fmt::format("No joint positions of '{}' reach the point {}.", machine_.id(), where), {},
                      point.line);
    std::string joints;
    for (const Alternative& one : tracker_.alternatives()) {
      const int joint = machine_.firstOutsideTravel(one.q);
      if (joint < 0) continue;
      const std::string name = machine_.joint(joint).axis.text();
      if (joints.find(name) == std::string::npos) joints += (joints.empty() ? "" : ", ") + name;
    }
    return noAnswer("post.travel", fmt::format("The point {} lies outside the travel of {}.", where, joints),
                    {}, point.line);
  }
  Error noWay(std::size_t i) const {
    return noAnswer(
        "post.flip",
        "The cut cannot go on here: every way to stand at this point that is inside the travel would "
        "turn the rotary axes to another branch within the cut. Retract before it.",
        {}, points_[i].line);
  }

  const PoseSolver& solver_;
  const Machine& machine_;
  const std::vector<ClPoint>& points_;
  JointPositions home_;
  PlanOptions options_;
  BranchTracker tracker_;
  std::vector<std::size_t> wound_;
  std::vector<State> states_;
  std::vector<Step> steps_;
  std::vector<std::size_t> first_;  // of each point in steps_
};

}  // namespace

Result<PathPlan> planPath(const PoseSolver& solver, const std::vector<ClPoint>& points,
                          const JointPositions& home, const PlanOptions& options, Progress& progress) {
  NL_EXPECTS(!points.empty());
  return Planner(solver, points, home, options).run(progress);
}

}  // namespace nineline::postprocessing
