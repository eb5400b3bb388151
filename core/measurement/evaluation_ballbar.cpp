#include "core/measurement/evaluation_ballbar.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace nineline::measurement {

namespace {

/// Each trace for a coefficient of one, in mm of radius at polar angle a in sense +1 (counter-clockwise) or
/// −1.
struct Trace {
  std::string name;
  double (*at)(double a, double sense);
  double factor = 1.0;  ///< coefficient → the value that is reported
};

double signOf(double value) { return value > 1e-9 ? 1.0 : value < -1e-9 ? -1.0 : 0.0; }

/// The first axis moves with −sin a · sense, the second with cos a · sense; play −(w/2) s moves its own axis.
double firstPlay(double a, double sense) { return 0.5 * signOf(std::sin(a)) * sense * std::cos(a); }
double secondPlay(double a, double sense) { return -0.5 * signOf(std::cos(a)) * sense * std::sin(a); }

std::vector<Trace> tracesOf(const CircularTest& test, char first, char second) {
  const double radius = test.radius;
  std::vector<Trace> traces{
      {"radius change", [](double, double) { return 1.0; }},
      {fmt::format("centre offset {}", first), [](double a, double) { return std::cos(a); }},
      {fmt::format("centre offset {}", second), [](double a, double) { return std::sin(a); }},
      {"scale mismatch", [](double a, double) { return std::cos(2.0 * a); }, 2.0 / radius},
      {"squareness", [](double a, double) { return std::sin(2.0 * a); }, -2.0 / radius},
      {fmt::format("backlash {}", first), firstPlay},
      {fmt::format("backlash {}", second), secondPlay},
      {"straightness (three lobes, cosine)", [](double a, double) { return std::cos(3.0 * a); }},
      {"straightness (three lobes, sine)", [](double a, double) { return std::sin(3.0 * a); }}};
  if (test.clockwise && test.counterclockwise) {
    traces.push_back({"servo mismatch", [](double a, double sense) { return sense * std::sin(2.0 * a); }});
  }
  return traces;
}

struct System {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd readings;
};

System systemOf(const CircularTest& test, const std::vector<Trace>& traces) {
  std::size_t count = 0;
  for (const auto* path : {&test.clockwise, &test.counterclockwise})
    count += *path ? (*path)->angle.size() : 0;
  System system{Eigen::MatrixXd(static_cast<Eigen::Index>(count), static_cast<Eigen::Index>(traces.size())),
                Eigen::VectorXd(static_cast<Eigen::Index>(count))};
  Eigen::Index row = 0;
  for (const auto& [path, sense] :
       {std::pair{&test.clockwise, -1.0}, std::pair{&test.counterclockwise, 1.0}}) {
    for (std::size_t i = 0; *path && i < (*path)->angle.size(); ++i, ++row) {
      for (Eigen::Index k = 0; k < system.matrix.cols(); ++k) {
        system.matrix(row, k) = traces[static_cast<std::size_t>(k)].at((*path)->angle[i], sense);
      }
      system.readings(row) = (*path)->deviation[i];
    }
  }
  return system;
}

}  // namespace

Result<BallbarShares> ballbarShares(const CircularTest& test, char first, char second) {
  if (const Result<Iso2304> checked = evaluateIso2304(test); !checked) return checked.error();
  const std::vector<Trace> traces = tracesOf(test, first, second);
  const System system = systemOf(test, traces);
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(system.matrix);
  solver.setThreshold(1e-6);
  if (solver.rank() < system.matrix.cols() || system.matrix.rows() <= system.matrix.cols()) {
    return noAnswer("evaluation.ballbar",
                    "The path covers too little of the circle to tell its errors apart.");
  }
  const Eigen::VectorXd found = solver.solve(system.readings);
  const Eigen::VectorXd rest = system.readings - system.matrix * found;
  const double variance = rest.squaredNorm() / static_cast<double>(rest.size() - found.size());
  const Eigen::MatrixXd covariance = (system.matrix.transpose() * system.matrix).inverse() * variance;
  BallbarShares result;
  for (Eigen::Index k = 0; k < found.size(); ++k) {
    const Trace& trace = traces[static_cast<std::size_t>(k)];
    const Eigen::VectorXd share = system.matrix.col(k) * found(k);
    const double range = k == 0 ? std::abs(found(k)) : share.maxCoeff() - share.minCoeff();
    result.shares.push_back(
        {trace.name, trace.factor * found(k), std::abs(trace.factor) * std::sqrt(covariance(k, k)), range});
  }
  std::stable_sort(result.shares.begin(), result.shares.end(),
                   [](const BallbarShare& a, const BallbarShare& b) { return a.radial > b.radial; });
  result.residual_rms = std::sqrt(rest.squaredNorm() / static_cast<double>(rest.size()));
  result.residual_range = rest.maxCoeff() - rest.minCoeff();
  return result;
}

}  // namespace nineline::measurement
