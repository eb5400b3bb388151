#include "core/measurement/iso_230_4.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/measurement/evaluation_runs.h"

namespace nineline::measurement {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Points = std::vector<Vector2d>;

constexpr std::size_t kFewestPoints = 8;
constexpr double kLargestGap = kPi / 18.0;  // 10°

Result<void> checkPath(const std::optional<CircularPath>& path, double radius) {
  if (!path) return {};
  if (path->angle.size() != path->deviation.size() || path->angle.size() < kFewestPoints) {
    return badInput("evaluation.circle", fmt::format("A circular path needs at least {} points; it has {}.",
                                                     kFewestPoints, path->angle.size()));
  }
  for (std::size_t i = 0; i < path->angle.size(); ++i) {
    if (!std::isfinite(path->angle[i]) || !std::isfinite(path->deviation[i])) {
      return badInput("evaluation.number", fmt::format("Point {} of a circular path is no number.", i + 1));
    }
    if (path->deviation[i] <= -radius) {
      return badInput("evaluation.circle", fmt::format("Point {} deviates by more than the radius.", i + 1));
    }
  }
  return {};
}

Points pointsOf(const CircularPath& path, double radius) {
  Points points;
  points.reserve(path.angle.size());
  for (std::size_t i = 0; i < path.angle.size(); ++i) {
    points.push_back((radius + path.deviation[i]) *
                     Vector2d(std::cos(path.angle[i]), std::sin(path.angle[i])));
  }
  return points;
}

double separation(const Points& points, const Vector2d& centre) {
  Extent distances;
  for (const Vector2d& point : points) distances.add((point - centre).norm());
  return *distances.range();
}

/// Geometric least squares by Gauss–Newton: distance from the centre = radius.
Result<CircleFit> fitCircle(const Points& points, double radius) {
  Vector3d unknown(0.0, 0.0, radius);  // centre, radius
  for (int iteration = 0; iteration < 50; ++iteration) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Vector3d right = Vector3d::Zero();
    for (const Vector2d& point : points) {
      const Vector2d outward = point - unknown.head<2>();
      const Vector3d row(outward.x() / outward.norm(), outward.y() / outward.norm(), 1.0);
      normal += row * row.transpose();
      right += row * (outward.norm() - unknown.z());
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(normal);
    if (eigen.eigenvalues()(0) < 1e-9 * eigen.eigenvalues()(2)) {
      return noAnswer("evaluation.circle", "The points cover too little of the circle to find its centre.");
    }
    const Vector3d step =
        eigen.eigenvectors() * (eigen.eigenvectors().transpose() * right).cwiseQuotient(eigen.eigenvalues());
    unknown += step;
    if (step.norm() > 1e-12 * radius) continue;
    const Vector2d centre = unknown.head<2>();
    return CircleFit{centre.x(), centre.y(), unknown.z() - radius, separation(points, centre), 0.0};
  }
  return noAnswer("evaluation.circle", "The circle through the points was not found in 50 steps.");
}

/// Smallest value of a convex function of one number between two limits, and where.
template <typename Function>
double smallestBetween(double low, double high, const Function& function) {
  constexpr double kGolden = 0.6180339887498949;
  double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
  double at_a = function(a), at_b = function(b);
  for (int i = 0; i < 48; ++i) {
    if (at_a <= at_b) {
      high = b, b = a, at_b = at_a;
      a = high - kGolden * (high - low), at_a = function(a);
    } else {
      low = a, a = b, at_a = at_b;
      b = low + kGolden * (high - low), at_b = function(b);
    }
  }
  return std::min(at_a, at_b);
}

/// Radial separation of the closest pair of concentric circles around all points. As a function of the centre
/// it is convex as long as the deviations are small against the radius.
double minimumZone(const Points& points, const CircleFit& fit) {
  const Vector2d start(fit.centre_u, fit.centre_v);
  const double reach = std::max(fit.G, 1e-12);
  return smallestBetween(-reach, reach, [&](double u) {
    return smallestBetween(-reach, reach,
                           [&](double v) { return separation(points, start + Vector2d(u, v)); });
  });
}

/// Deviation at an angle by linear interpolation between the path's neighbours, sorted by angle in [0, 2π).
class PeriodicCurve {
 public:
  PeriodicCurve(const Points& points, const Vector2d& centre) {
    for (const Vector2d& point : points) {
      const Vector2d outward = point - centre;
      knots_.emplace_back(std::atan2(outward.y(), outward.x()), outward.norm());
    }
    std::sort(knots_.begin(), knots_.end());
  }
  [[nodiscard]] const std::vector<std::pair<double, double>>& knots() const { return knots_; }

  /// Nothing inside a gap of the path.
  [[nodiscard]] std::optional<double> at(double angle) const {
    const auto above = std::lower_bound(knots_.begin(), knots_.end(), std::pair{angle, -1.0});
    auto right = above == knots_.end() ? knots_.front() : *above;
    auto left = above == knots_.begin() ? knots_.back() : *(above - 1);
    if (above == knots_.end()) right.first += kTurn;
    if (above == knots_.begin()) left.first -= kTurn;
    const double width = right.first - left.first;
    if (width > kLargestGap) return std::nullopt;
    if (width <= 0.0) return right.second;
    return left.second + (right.second - left.second) * (angle - left.first) / width;
  }

  [[nodiscard]] double largestGap() const {
    double gap = knots_.front().first + kTurn - knots_.back().first;
    for (std::size_t i = 1; i < knots_.size(); ++i)
      gap = std::max(gap, knots_[i].first - knots_[i - 1].first);
    return gap;
  }

 private:
  std::vector<std::pair<double, double>> knots_;
};

std::optional<double> hysteresis(const PeriodicCurve& one, const PeriodicCurve& other) {
  Extent differences;
  for (const auto& [angle, distance] : one.knots()) {
    if (const std::optional<double> there = other.at(angle)) differences.add(std::abs(distance - *there));
  }
  for (const auto& [angle, distance] : other.knots()) {
    if (const std::optional<double> there = one.at(angle)) differences.add(std::abs(distance - *there));
  }
  return differences.largest();
}

/// Fits one set of points, the closest zone included.
Result<CircleFit> figuresOf(const Points& points, double radius) {
  Result<CircleFit> fit = fitCircle(points, radius);
  if (fit) fit->G_minimum_zone = std::min(fit->G, minimumZone(points, *fit));
  return fit;
}

void addRadialDeviations(const Points& all, double radius, Iso2304& result) {
  const Vector2d fitted(result.all.centre_u, result.all.centre_v);
  Extent as_set, about_fit;
  for (const Vector2d& point : all) {
    as_set.add(point.norm() - radius);
    about_fit.add((point - fitted).norm() - radius);
  }
  result.F_max_as_set = *as_set.largest();
  result.F_min_as_set = *as_set.smallest();
  const Extent& chosen = result.is_full_circle ? about_fit : as_set;
  result.F_max = *chosen.largest();
  result.F_min = *chosen.smallest();
}

}  // namespace

Result<Iso2304> evaluateIso2304(const CircularTest& test) {
  if (!(test.radius > 0.0) || (!test.clockwise && !test.counterclockwise)) {
    return badInput("evaluation.circle", "A circular test needs a radius above 0 and at least one path.");
  }
  Iso2304 result;
  Points all;
  std::vector<Points> paths;
  for (const auto& [path, fit] : {std::pair{&test.clockwise, &result.clockwise},
                                  std::pair{&test.counterclockwise, &result.counterclockwise}}) {
    if (const Result<void> checked = checkPath(*path, test.radius); !checked) return checked.error();
    if (!*path) continue;
    paths.push_back(pointsOf(**path, test.radius));
    const Result<CircleFit> found = figuresOf(paths.back(), test.radius);
    if (!found) return found.error();
    *fit = *found;
    all.insert(all.end(), paths.back().begin(), paths.back().end());
  }
  const Result<CircleFit> both = figuresOf(all, test.radius);
  if (!both) return both.error();
  result.all = *both;
  result.D = both->radius_change;
  std::vector<PeriodicCurve> curves;
  for (const Points& path : paths) curves.emplace_back(path, Vector2d(both->centre_u, both->centre_v));
  result.is_full_circle = std::all_of(curves.begin(), curves.end(), [](const PeriodicCurve& curve) {
    return curve.largestGap() <= kLargestGap;
  });
  if (curves.size() == 2) result.H = hysteresis(curves[0], curves[1]);
  addRadialDeviations(all, test.radius, result);
  return result;
}

}  // namespace nineline::measurement
