#include "core/postprocessing/branch_tracker.h"

#include <algorithm>
#include <cmath>

namespace nineline::postprocessing {

namespace {

constexpr std::size_t kMostAlternatives = 8;
constexpr std::size_t kMostWhenThorough = 48;
constexpr double kLongTurn = 0.2;  // rad: a step that turns more is walked in shorter ones
constexpr int kLongestInterval = 256;

double largestTurn(const Machine& machine, const JointPositions& a, const JointPositions& b) {
  double most = 0.0;
  for (int i = 0; i < machine.jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (machine.isRotary(i)) most = std::max(most, std::abs(a[k] - b[k]));
  }
  return most;
}

}  // namespace

void BranchTracker::search(bool thorough) {
  BranchOptions options;
  options.most = thorough ? kMostWhenThorough : kMostAlternatives;
  options.starts = thorough ? 400 : options.starts;
  options.thorough = thorough;
  for (const JointPositions& q : findBranches(solver_, target_, home_, options)) {
    const auto same = [&](const Alternative& one) { return sameButTurns(solver_.machine(), one.q, q); };
    if (alternatives_.size() >= options.most || std::ranges::any_of(alternatives_, same)) continue;
    alternatives_.push_back({q, next_track_++, 0});
  }
}

void BranchTracker::start(const TipAxis& target) {
  target_ = target;
  search();
  complete_ = alternatives_.size();
}

/// A long step may end on another branch: it is walked in steps that turn little, and what they end on
/// counts.
Solution BranchTracker::followClosely(const Alternative& from, const TipAxis& to) const {
  Solution solution = solver_.follow(target_, from.q, to);
  const double turn = largestTurn(solver_.machine(), from.q, solution.q);
  if (solution.converged && turn <= kLongTurn) return solution;
  const int steps =
      solution.converged ? std::min(64, static_cast<int>(std::ceil(2.0 * turn / kLongTurn))) : 16;
  Solution walked;
  walked.q = from.q;
  TipAxis before = target_;
  int iterations = 0;
  for (int i = 1; i <= steps; ++i) {
    const TipAxis next = i == steps ? to : between(target_, to, static_cast<double>(i) / steps);
    walked = solver_.follow(before, walked.q, next);
    iterations += walked.iterations;
    if (!walked.converged) return solution;
    before = next;
  }
  walked.iterations = iterations;
  return walked;
}

void BranchTracker::advance(const TipAxis& target) {
  std::vector<Alternative> next;
  for (const Alternative& one : alternatives_) {
    const Solution solution = followClosely(one, target);
    if (!solution.converged) continue;
    const auto same = [&](const Alternative& other) {
      return sameButTurns(solver_.machine(), other.q, solution.q);
    };
    if (std::ranges::any_of(next, same)) continue;
    next.push_back({solution.q, one.track, solution.iterations});
  }
  alternatives_ = std::move(next);
  target_ = target;
  const bool lost = alternatives_.size() < complete_ && !solver_.isRedundant();
  if (!alternatives_.empty() && !lost) {
    search_interval_ = 1;
    return;
  }
  if (!alternatives_.empty() && --until_search_ > 0) return;
  const std::size_t before = alternatives_.size();
  search();
  search_interval_ = alternatives_.size() > before ? 1 : std::min(2 * search_interval_, kLongestInterval);
  until_search_ = search_interval_;
}

}  // namespace nineline::postprocessing
