#include "core/identification/rotary_axis.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <cmath>
#include <complex>

#include "core/base/units.h"
#include "core/kinematics/rotation.h"

namespace nineline::identification {

namespace {

using kinematics::rotationAbout;

/// The same angle in (−π, π].
double wrapped(double angle) { return std::remainder(angle, kTurn); }

Matrix3d rotationOf(const RotaryPose& pose) {
  return rotationAbout(Vector3d::UnitZ(), pose.e.z()) * rotationAbout(Vector3d::UnitY(), pose.e.y()) *
         rotationAbout(Vector3d::UnitX(), pose.e.x());
}

Result<void> checkTargets(const RotaryTargets& targets) {
  if (targets.h1 == targets.h2 || !std::isfinite(targets.h1) || !std::isfinite(targets.h2)) {
    return badInput("rotary.planes", fmt::format("The balls need two different planes, not {:g} and {:g} mm.",
                                                 targets.h1, targets.h2));
  }
  if (!(targets.radius > 0.0) || !std::isfinite(targets.radius)) {
    return badInput("rotary.radius",
                    fmt::format("The angular target needs a radius above 0, not {:g} mm.", targets.radius));
  }
  return {};
}

bool isFinite(const RotaryReadings& readings) {
  return std::isfinite(readings.axial + readings.y1 + readings.z1 + readings.y2 + readings.z2 +
                       readings.turn);
}

/// e1 of (9): where the target stands, seen from the ideal axis, fixes the turn about it.
Result<double> turnAboutAxis(const RotaryTargets& targets, const RotaryReadings& readings, const Vector3d& e,
                             double angle) {
  const double theta = angle + readings.turn;
  const double sine = std::sin(theta), cosine = std::cos(theta);
  const double a = std::cos(e.z()) * sine;
  const double b = std::sin(e.y()) * std::sin(e.z()) * sine - std::cos(e.y()) * cosine;
  const double k = (readings.z1 * cosine - readings.y1 * sine) / targets.radius;
  const double ratio = k / std::hypot(a, b);
  if (!(std::abs(ratio) <= 1.0)) {
    return noAnswer("rotary.turn", "No turn of the axis brings the angular target to where it was read.");
  }
  const double middle = std::atan2(b, a), half = std::acos(ratio);
  const double one = wrapped(middle + half - angle), other = wrapped(middle - half - angle);
  return std::abs(one) <= std::abs(other) ? one : other;
}

}  // namespace

RotaryReadings predictRotaryReadings(const RotaryTargets& targets, const RotaryPose& pose, double angle) {
  const Matrix3d R = rotationOf(pose);
  const Vector3d first = pose.d + (R.col(0) - Vector3d::UnitX()) * targets.h1;
  const Vector3d second = pose.d + (R.col(0) - Vector3d::UnitX()) * targets.h2;
  const Vector3d target(targets.h1, targets.radius * std::cos(angle), targets.radius * std::sin(angle));
  const Vector3d seen = pose.d + R * target;
  return {first.x(),  first.y(),  first.z(),
          second.y(), second.z(), wrapped(std::atan2(seen.z(), seen.y()) - angle)};
}

Result<RotaryPose> exactRotaryPose(const RotaryTargets& targets, const RotaryReadings& readings,
                                   double angle) {
  if (const Result<void> checked = checkTargets(targets); !checked) return checked.error();
  if (!isFinite(readings)) return badInput("rotary.number", "A reading of the rotary axis is no number.");
  const double apart = targets.h2 - targets.h1;
  const double u_y = (readings.y2 - readings.y1) / apart, u_z = (readings.z2 - readings.z1) / apart;
  const double across = u_y * u_y + u_z * u_z;
  if (across >= 1.0) return noAnswer("rotary.tilt", "The radial readings tilt the axis by 90° or more.");
  const double u_x = std::sqrt(1.0 - across);
  RotaryPose pose;
  pose.e.y() = -std::asin(u_z);
  pose.e.z() = std::atan2(u_y, u_x);
  pose.d = {readings.axial + targets.h1 * across / (1.0 + u_x), readings.y1 - targets.h1 * u_y,
            readings.z1 - targets.h1 * u_z};
  const Result<double> turn = turnAboutAxis(targets, readings, pose.e, angle);
  if (!turn) return turn.error();
  pose.e.x() = *turn;
  return pose;
}

Result<RotaryPose> firstOrderRotaryPose(const RotaryTargets& targets, const RotaryReadings& readings,
                                        double angle) {
  if (const Result<void> checked = checkTargets(targets); !checked) return checked.error();
  if (!isFinite(readings)) return badInput("rotary.number", "A reading of the rotary axis is no number.");
  const double apart = targets.h2 - targets.h1;
  const double sine = std::sin(angle), cosine = std::cos(angle), radius = targets.radius;
  RotaryPose pose;
  pose.e.z() = std::atan((readings.y2 - readings.y1) / apart);
  pose.e.y() = -std::atan((readings.z2 - readings.z1) / apart);
  pose.d = {readings.axial, readings.y1 - targets.h1 * pose.e.z(), readings.z1 + targets.h1 * pose.e.y()};
  const double d1 = wrapped(std::atan2(radius * sine, radius * cosine + readings.y1) - angle);
  const double d2 = wrapped(std::atan2(radius * sine + readings.z1, radius * cosine) - angle);
  const double d4 = wrapped(std::atan2(sine * std::cos(pose.e.y()), cosine) - angle);
  const double d5 = wrapped(std::atan2(sine, cosine * std::cos(pose.e.z())) - angle);
  pose.e.x() = readings.turn - d1 - d2 - d4 - d5;
  return pose;
}

SmallMotion motionOf(const RotaryPose& pose) { return {pose.d, kinematics::logarithm(rotationOf(pose))}; }

SmallMotion turningMotionOf(const RotaryPose& pose, double angle) {
  return inTurningFrame(motionOf(pose), Vector3d::UnitX(), angle);
}

SmallMotion inBedAxes(const SmallMotion& local, char axis) {
  NL_EXPECTS(axis >= 'A' && axis <= 'C', axis);
  const Eigen::Index first = axis - 'A';
  SmallMotion result;
  for (Eigen::Index k = 0; k < 3; ++k) {
    result.translation((first + k) % 3) = local.translation(k);
    result.rotation((first + k) % 3) = local.rotation(k);
  }
  return result;
}

namespace {

struct Turning {
  std::complex<double> mean;
  std::complex<double> once;
};

/// y + i z = mean + once e^{iα} + terms that turn against the axis or faster, by least squares.
Result<Turning> fitTurning(const std::vector<double>& angles, const Eigen::VectorXcd& values) {
  const auto count = static_cast<Eigen::Index>(angles.size());
  std::vector<int> orders{0, 1, -1};
  for (int n = 2; n <= 6 && 2 * n + 3 <= count; ++n) orders.insert(orders.end(), {n, -n});
  Eigen::MatrixXcd basis(count, static_cast<Eigen::Index>(orders.size()));
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index k = 0; k < basis.cols(); ++k) {
      basis(i, k) =
          std::polar(1.0, orders[static_cast<std::size_t>(k)] * angles[static_cast<std::size_t>(i)]);
    }
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXcd> solver(basis);
  if (solver.rank() < basis.cols()) {
    basis.conservativeResize(Eigen::NoChange, 3);
    solver.compute(basis);
  }
  if (count < 4 || solver.rank() < 3) {
    return noAnswer("rotary.angles", "The mandrel's eccentricity needs four different angles over the turn.");
  }
  const Eigen::VectorXcd found = solver.solve(values);
  return Turning{found(0), found(1)};
}

}  // namespace

Result<MandrelEccentricity> removeMandrelEccentricity(const RotaryTargets& targets,
                                                      const std::vector<double>& angles,
                                                      std::vector<RotaryReadings>& readings) {
  if (const Result<void> checked = checkTargets(targets); !checked) return checked.error();
  if (angles.size() != readings.size()) {
    return badInput("rotary.count",
                    fmt::format("There are {} angles for {} readings.", angles.size(), readings.size()));
  }
  const auto count = static_cast<Eigen::Index>(angles.size());
  Eigen::VectorXcd first(count), second(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const RotaryReadings& one = readings[static_cast<std::size_t>(i)];
    if (!isFinite(one)) return badInput("rotary.number", "A reading of the rotary axis is no number.");
    first(i) = {one.y1, one.z1};
    second(i) = {one.y2, one.z2};
  }
  const Result<Turning> ball1 = fitTurning(angles, first), ball2 = fitTurning(angles, second);
  if (!ball1) return ball1.error();
  if (!ball2) return ball2.error();
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const std::complex<double> off1 = ball1->once * std::polar(1.0, angles[i]);
    const std::complex<double> off2 = ball2->once * std::polar(1.0, angles[i]);
    readings[i].y1 -= off1.real(), readings[i].z1 -= off1.imag();
    readings[i].y2 -= off2.real(), readings[i].z2 -= off2.imag();
  }
  const std::complex<double> slope = (ball2->mean - ball1->mean) / (targets.h2 - targets.h1);
  const std::complex<double> place = ball1->mean - targets.h1 * slope;
  return MandrelEccentricity{ball1->once.real(), ball1->once.imag(), ball2->once.real(), ball2->once.imag(),
                             place.real(),       place.imag(),       -slope.imag(),      slope.real()};
}

}  // namespace nineline::identification
