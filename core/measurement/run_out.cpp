#include "core/measurement/run_out.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/units.h"
#include "core/measurement/evaluation_runs.h"

namespace nineline::measurement {

namespace {

constexpr double kSameAngle = 1e-6;  // rad

/// Readings by angle within the turn; angles that agree to kSameAngle are one.
using ByAngle = std::map<long long, std::vector<std::size_t>>;

ByAngle groupByAngle(const std::vector<double>& angles) {
  ByAngle groups;
  const long long cells = std::llround(kTurn / kSameAngle);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const long long cell = std::llround((angles[i] - kTurn * std::floor(angles[i] / kTurn)) / kSameAngle);
    groups[cell % cells].push_back(i);
  }
  return groups;
}

/// Constant, then cosine and sine of each order.
Eigen::MatrixXd turnBasis(const std::vector<double>& angles, int highest) {
  Eigen::MatrixXd basis(static_cast<Eigen::Index>(angles.size()), 1 + 2 * highest);
  for (Eigen::Index i = 0; i < basis.rows(); ++i) {
    const double angle = angles[static_cast<std::size_t>(i)];
    basis(i, 0) = 1.0;
    for (int n = 1; n <= highest; ++n) {
      basis(i, 2 * n - 1) = std::cos(n * angle);
      basis(i, 2 * n) = std::sin(n * angle);
    }
  }
  return basis;
}

TurnHarmonic harmonicOf(const Eigen::VectorXd& fitted, int order) {
  const double cosine = fitted(2 * order - 1), sine = fitted(2 * order);
  return {order, std::hypot(cosine, sine), std::atan2(-sine, cosine)};
}

void addTurns(const ByAngle& groups, const std::vector<double>& rest, RunOut& result) {
  Extent means, spreads;
  std::size_t turns = rest.size();
  for (const auto& [cell, members] : groups) {
    Extent here;
    double sum = 0.0;
    for (const std::size_t i : members) {
      here.add(rest[i]);
      sum += rest[i];
    }
    means.add(sum / static_cast<double>(members.size()));
    spreads.add(*here.range());
    turns = std::min(turns, members.size());
  }
  result.turns = turns;
  if (turns < 2) return;
  result.synchronous = *means.range();
  result.asynchronous = *spreads.largest();
}

Result<void> checkReadings(const std::vector<double>& angles, const std::vector<double>& readings) {
  if (angles.size() != readings.size()) {
    return badInput("evaluation.run_out",
                    fmt::format("There are {} angles for {} readings.", angles.size(), readings.size()));
  }
  for (std::size_t i = 0; i < angles.size(); ++i) {
    if (std::isfinite(angles[i]) && std::isfinite(readings[i])) continue;
    return badInput("evaluation.number", fmt::format("Reading {} of a run-out test is no number.", i + 1));
  }
  return {};
}

}  // namespace

Result<RunOut> evaluateRunOut(const std::vector<double>& angles, const std::vector<double>& readings,
                              int highest) {
  NL_EXPECTS(highest >= 1, highest);
  if (const Result<void> checked = checkReadings(angles, readings); !checked) return checked.error();
  const ByAngle groups = groupByAngle(angles);
  if (groups.size() < 4) {
    return badInput("evaluation.run_out",
                    fmt::format("A run-out needs four different angles; there are {}.", groups.size()));
  }
  highest = std::clamp((static_cast<int>(groups.size()) - 2) / 2, 1, highest);
  const Eigen::MatrixXd basis = turnBasis(angles, highest);
  const Eigen::Map<const Eigen::VectorXd> values(readings.data(), static_cast<Eigen::Index>(readings.size()));
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(basis);
  if (solver.rank() < basis.cols()) {
    return noAnswer("evaluation.run_out", "The angles do not tell the harmonics of the turn apart.");
  }
  const Eigen::VectorXd fitted = solver.solve(values);
  const Eigen::VectorXd centred = values - basis.middleCols(1, 2) * fitted.segment(1, 2);
  RunOut result;
  result.mean = fitted(0);
  result.total = values.maxCoeff() - values.minCoeff();
  result.without_eccentricity = centred.maxCoeff() - centred.minCoeff();
  result.once_per_turn = harmonicOf(fitted, 1);
  for (int order = 2; order <= highest; ++order) result.harmonics.push_back(harmonicOf(fitted, order));
  addTurns(groups, {centred.data(), centred.data() + centred.size()}, result);
  return result;
}

}  // namespace nineline::measurement
