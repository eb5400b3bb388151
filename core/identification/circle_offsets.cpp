#include "core/identification/circle_offsets.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <cmath>

#include "core/base/units.h"

namespace nineline::identification {

namespace {

constexpr double kFinestTilt = 1e-10;   // rad, keeps weights finite on noiseless data
constexpr double kFinestPlace = 1e-10;  // mm

struct Plane {
  Vector3d middle, first, second, normal;
  double sigma_tilt = 0.0;
};

Result<Plane> fitPlane(const CirclePoints& points) {
  Plane plane;
  plane.middle = Vector3d::Zero();
  for (const Vector3d& point : points) plane.middle += point / static_cast<double>(points.size());
  Matrix3d scatter = Matrix3d::Zero();
  for (const Vector3d& point : points) scatter += (point - plane.middle) * (point - plane.middle).transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(scatter);
  const Vector3d spread = eigen.eigenvalues();
  if (!(spread(1) > 1e-12 * spread(2))) {
    return noAnswer("circle.line", "The points of a circle lie in one line or in one place.");
  }
  plane.normal = eigen.eigenvectors().col(0);
  Vector3d turned = Vector3d::Zero();
  for (std::size_t i = 1; i < points.size(); ++i) {
    turned += (points[i - 1] - plane.middle).cross(points[i] - plane.middle);
  }
  if (turned.dot(plane.normal) < 0.0) plane.normal = -plane.normal;
  plane.first = eigen.eigenvectors().col(2);
  plane.second = plane.normal.cross(plane.first);
  if (points.size() > 3) {
    const double freedom = static_cast<double>(points.size()) - 3.0;
    plane.sigma_tilt = std::sqrt(std::max(spread(0), 0.0) / freedom / spread(1));
  }
  return plane;
}

/// Distances from the circle in the plane, and their normal equations over centre and radius.
struct RadialFit {
  Matrix3d normal = Matrix3d::Zero();
  Vector3d right = Vector3d::Zero();
  double squares = 0.0;
};

RadialFit radialFit(const CirclePoints& points, const Plane& plane, const Vector3d& circle) {
  RadialFit fit;
  for (const Vector3d& point : points) {
    const Eigen::Vector2d outward(plane.first.dot(point - plane.middle) - circle.x(),
                                  plane.second.dot(point - plane.middle) - circle.y());
    const Vector3d row(outward.x() / outward.norm(), outward.y() / outward.norm(), 1.0);
    const double rest = outward.norm() - circle.z();
    fit.normal += row * row.transpose();
    fit.right += row * rest;
    fit.squares += rest * rest;
  }
  return fit;
}

/// Algebraic circle (linear), a start for the geometric one: |p|² = 2 c·p + k.
Vector3d startCircle(const CirclePoints& points, const Plane& plane) {
  Matrix3d normal = Matrix3d::Zero();
  Vector3d right = Vector3d::Zero();
  for (const Vector3d& point : points) {
    const Vector3d row(plane.first.dot(point - plane.middle), plane.second.dot(point - plane.middle), 1.0);
    normal += row * row.transpose();
    right += row * row.head<2>().squaredNorm();
  }
  const Vector3d found = normal.colPivHouseholderQr().solve(right);
  const Eigen::Vector2d centre = 0.5 * found.head<2>();
  return {centre.x(), centre.y(), std::sqrt(std::max(found.z() + centre.squaredNorm(), 0.0))};
}

Result<Vector3d> fitCircleIn(const Plane& plane, const CirclePoints& points) {
  Vector3d circle = startCircle(points, plane);
  for (int iteration = 0; iteration < 50; ++iteration) {
    const RadialFit fit = radialFit(points, plane, circle);
    const Eigen::ColPivHouseholderQR<Matrix3d> solver(fit.normal);
    if (!fit.normal.allFinite() || solver.rank() < 3) break;
    const Vector3d step = solver.solve(fit.right);
    circle += step;
    if (step.norm() <= 1e-13 * circle.z()) return circle;
    if (iteration > 20 && step.norm() <= 1e-11 * circle.z()) return circle;
  }
  return noAnswer("circle.fit", "No circle was found through the points of a rotary axis.");
}

/// Sum of estimates weighted by their certainty.
struct WeightedDirection {
  Vector3d sum = Vector3d::Zero();
  void add(const Vector3d& direction, double sigma) {
    sum += direction / (sigma * sigma + kFinestTilt * kFinestTilt);
  }
};

Vector3d meanCentre(const std::vector<SpaceCircle>& circles) {
  Vector3d sum = Vector3d::Zero();
  double weights = 0.0;
  for (const SpaceCircle& circle : circles) {
    const double weight = 1.0 / (circle.sigma_centre * circle.sigma_centre + kFinestPlace * kFinestPlace);
    sum += weight * circle.centre;
    weights += weight;
  }
  return sum / weights;
}

/// The line through the centres, with the standard uncertainty of its direction; nothing for one height.
void addLineOfCentres(const std::vector<SpaceCircle>& circles, WeightedDirection& direction) {
  const Vector3d middle = meanCentre(circles);
  Matrix3d scatter = Matrix3d::Zero();
  double sigma = kFinestPlace;
  for (const SpaceCircle& circle : circles) {
    scatter += (circle.centre - middle) * (circle.centre - middle).transpose();
    sigma = std::max(sigma, circle.sigma_centre);
  }
  const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(scatter);
  const double length = std::sqrt(std::max(eigen.eigenvalues()(2), 0.0));
  if (length < 1e-3 * circles.front().radius) return;
  Vector3d line = eigen.eigenvectors().col(2);
  if (line.dot(direction.sum) < 0.0) line = -line;
  direction.add(line, sigma / length);
}

}  // namespace

Result<SpaceCircle> fitSpaceCircle(const CirclePoints& points) {
  if (points.size() < 3) {
    return badInput("circle.count", fmt::format("A circle needs three points; there are {}.", points.size()));
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite())
      return badInput("circle.number", fmt::format("Point {} of a circle is no number.", i + 1));
  }
  const Result<Plane> plane = fitPlane(points);
  if (!plane) return plane.error();
  const Result<Vector3d> circle = fitCircleIn(*plane, points);
  if (!circle) return circle.error();
  const RadialFit rest = radialFit(points, *plane, *circle);
  SpaceCircle result;
  result.centre = plane->middle + circle->x() * plane->first + circle->y() * plane->second;
  result.normal = plane->normal;
  result.radius = circle->z();
  double squares = rest.squares;
  for (const Vector3d& point : points) squares += std::pow(plane->normal.dot(point - plane->middle), 2);
  result.rms = std::sqrt(squares / static_cast<double>(points.size()));
  result.sigma_tilt = plane->sigma_tilt;
  if (points.size() > 3) {
    const Matrix3d covariance =
        rest.normal.inverse() * rest.squares / (static_cast<double>(points.size()) - 3.0);
    result.sigma_centre = std::sqrt(covariance.topLeftCorner<2, 2>().trace());
  }
  return result;
}

Result<FoundAxis> findRotaryAxis(const std::vector<CirclePoints>& circles, const NominalAxis& nominal) {
  if (circles.empty()) return badInput("circle.none", "There is no circle to find the rotary axis from.");
  FoundAxis result;
  WeightedDirection direction;
  for (const CirclePoints& points : circles) {
    const Result<SpaceCircle> circle = fitSpaceCircle(points);
    if (!circle) return circle.error();
    result.circles.push_back(*circle);
    direction.add(circle->normal, circle->sigma_tilt);
  }
  const Vector3d of_planes = direction.sum.normalized();
  if (circles.size() > 1) addLineOfCentres(result.circles, direction);
  result.direction = direction.sum.normalized();
  const double along = nominal.direction.dot(result.direction);
  if (!(along > std::cos(kPi / 4.0))) {
    return badInput("circle.direction",
                    "The circles turn about a line more than 45° off the axis: wrong axis, or "
                    "the points are not in the order of increasing angle.");
  }
  const Vector3d middle = meanCentre(result.circles);
  result.point = middle + result.direction * (nominal.direction.dot(nominal.place - middle) / along);
  const Vector3d across = nominal.direction.cross(result.direction);
  const double sine = across.norm();
  result.location.translation = result.point - nominal.place;
  if (sine > 0.0) result.location.rotation = across * (std::atan2(sine, along) / sine);
  result.tilt_of_planes =
      std::atan2(of_planes.cross(result.direction).norm(), of_planes.dot(result.direction));
  return result;
}

}  // namespace nineline::identification
