#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/postprocessing/path_plan.h"

namespace nineline::postprocessing {

namespace {

/// Spreads the turns of one wild step over a stretch of the path that grows to both sides.
class Spread {
 public:
  Spread(const PoseSolver& solver, const std::vector<ClPoint>& points, const PlanOptions& options,
         PathPlan& plan)
      : solver_(solver), machine_(solver.machine()), points_(points), options_(options), plan_(plan) {}

  /// The largest turn of a rotary joint on the step to point i, and which joint.
  std::pair<double, int> turnOf(std::size_t i) const {
    double most = 0.0;
    int joint = -1;
    for (int j = 0; j < machine_.jointCount(); ++j) {
      const auto k = static_cast<std::size_t>(j);
      const double turn = std::abs(plan_.points[i].q[k] - plan_.points[i - 1].q[k]);
      if (!machine_.isRotary(j) || turn <= most) continue;
      most = turn;
      joint = j;
    }
    return {most, joint};
  }

  void calm(std::size_t i) {
    std::size_t first = i - 1;
    std::size_t last = i;
    bool grows_down = true;
    bool grows_up = true;
    while (grows_down || grows_up) {
      if (grows_down) grows_down = first > 0 && !points_[first].rapid && spread(first - 1, last);
      if (grows_down) --first;
      if (grows_up)
        grows_up = last + 1 < points_.size() && !points_[last + 1].rapid && spread(first, last + 1);
      if (grows_up) ++last;
      double most = 0.0;
      for (std::size_t p = first + 1; p <= last; ++p) most = std::max(most, turnOf(p).first);
      if (most <= options_.most_turn) return;
    }
  }

 private:
  /// Lets the rotary joints go evenly from one point to another; false, and nothing changes, where the tool
  /// axis would leave its tolerance or a joint its travel.
  bool spread(std::size_t first, std::size_t last) {
    std::vector<JointPositions> between_points;
    const double count = static_cast<double>(last - first);
    for (std::size_t p = first + 1; p < last; ++p) {
      const double s = static_cast<double>(p - first) / count;
      JointPositions q = plan_.points[p].q;
      for (int j = 0; j < machine_.jointCount(); ++j) {
        const auto k = static_cast<std::size_t>(j);
        if (machine_.isRotary(j))
          q[k] = plan_.points[first].q[k] + s * (plan_.points[last].q[k] - plan_.points[first].q[k]);
      }
      const Solution held = solver_.holdTip({points_[p].tip, points_[p].axis}, q);
      if (!held.converged || held.axis_error > options_.axis_tolerance) return false;
      if (machine_.firstOutsideTravel(held.q) >= 0) return false;
      between_points.push_back(held.q);
    }
    for (std::size_t p = first + 1; p < last; ++p) {
      plan_.points[p].q = between_points[p - first - 1];
      plan_.points[p].turned = true;
    }
    if (last > first + 1) plan_.points[last].turned = true;
    return true;
  }

  const PoseSolver& solver_;
  const Machine& machine_;
  const std::vector<ClPoint>& points_;
  const PlanOptions& options_;
  PathPlan& plan_;
};

}  // namespace

void calmTurns(const PoseSolver& solver, const std::vector<ClPoint>& points, const PlanOptions& options,
               PathPlan& plan) {
  Spread spread(solver, points, options, plan);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double openness = std::min(plan.points[i].openness, plan.points[i - 1].openness);
    const bool is_near = openness < 10.0 * options.singular_openness || plan.points[i].turned;
    if (points[i].rapid || !is_near || spread.turnOf(i).first <= options.most_turn) continue;
    if (options.axis_tolerance > 0.0) spread.calm(i);
    const auto [turn, joint] = spread.turnOf(i);
    const double axis_turn = angleBetween(points[i - 1].axis, points[i].axis);
    if (turn <= std::max(options.most_turn, 5.0 * axis_turn)) continue;
    plan.warnings.warning(
        "post.singular",
        fmt::format(
            "Near a singular pose axis {} turns by {:.2f}° while the tool moves {:.3f} mm and tilts {:.3f}°.",
            solver.machine().joint(joint).axis.text(), degFromRad(turn),
            (points[i].tip - points[i - 1].tip).norm(), degFromRad(axis_turn)),
        points[i].line);
  }
}

}  // namespace nineline::postprocessing
