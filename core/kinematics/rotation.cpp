#include "core/kinematics/rotation.h"

#include <Eigen/Geometry>
#include <cmath>

namespace nineline::kinematics {

namespace {
/// Of the squared angle: below it the series are exact to a double's last digit.
constexpr double kSeriesBelow = 1e-4;

struct Coefficients {
  double a, b, c;  // sin t / t, (1 − cos t)/t², (t − sin t)/t³
};

Coefficients coefficients(double t2) {
  if (t2 < kSeriesBelow) {
    return {1.0 - t2 * (1.0 / 6.0 - t2 * (1.0 / 120.0)), 0.5 - t2 * (1.0 / 24.0 - t2 * (1.0 / 720.0)),
            1.0 / 6.0 - t2 * (1.0 / 120.0 - t2 * (1.0 / 5040.0))};
  }
  const double t = std::sqrt(t2);
  const double half = std::sin(0.5 * t);
  const double sine = std::sin(t);
  return {sine / t, 2.0 * half * half / t2, (t - sine) / (t2 * t)};
}

/// I·k0 + k1 [w]× + k2 [w]×², written out.
Matrix3d polynomial(const Vector3d& w, double k1, double k2) {
  const double x = w.x(), y = w.y(), z = w.z();
  const double xy = k2 * x * y, xz = k2 * x * z, yz = k2 * y * z;
  const double xx = k2 * x * x, yy = k2 * y * y, zz = k2 * z * z;
  const double sx = k1 * x, sy = k1 * y, sz = k1 * z;
  Matrix3d m;
  double* const c = m.data();  // column by column
  c[0] = 1.0 - (yy + zz), c[1] = xy + sz, c[2] = xz - sy;
  c[3] = xy - sz, c[4] = 1.0 - (xx + zz), c[5] = yz + sx;
  c[6] = xz + sy, c[7] = yz - sx, c[8] = 1.0 - (xx + yy);
  return m;
}
}  // namespace

Matrix3d skew(const Vector3d& w) {
  Matrix3d m;
  m << 0.0, -w.z(), w.y(), w.z(), 0.0, -w.x(), -w.y(), w.x(), 0.0;
  return m;
}

Matrix3d exponential(const Vector3d& w) {
  const Coefficients k = coefficients(w.squaredNorm());
  return polynomial(w, k.a, k.b);
}

Matrix3d leftJacobian(const Vector3d& w) {
  const Coefficients k = coefficients(w.squaredNorm());
  return polynomial(w, k.b, k.c);
}

Vector3d logarithm(const Matrix3d& R) {
  // By way of the quaternion: unlike the antisymmetric part of R it stays exact near half a turn.
  const Eigen::Quaterniond turn(R);
  const double cosine = std::abs(turn.w());
  const Vector3d v = turn.w() < 0.0 ? Vector3d(-turn.vec()) : Vector3d(turn.vec());
  const double squared = v.squaredNorm();
  // atan(t)/t = 1 − t²/3 + t⁴/5 − t⁶/7: exact to a double's last digit below.
  if (squared < kSeriesBelow * cosine * cosine) {
    const double t2 = squared / (cosine * cosine);
    return v * (2.0 / cosine * (1.0 - t2 * (1.0 / 3.0 - t2 * (1.0 / 5.0 - t2 * (1.0 / 7.0)))));
  }
  const double sine = std::sqrt(squared);
  return v * (2.0 * std::atan2(sine, cosine) / sine);
}

Matrix3d rotationAbout(const Vector3d& axis, double angle) {
  const double half = std::sin(0.5 * angle);
  return polynomial(axis, std::sin(angle), 2.0 * half * half);
}

}  // namespace nineline::kinematics
