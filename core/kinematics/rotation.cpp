#include "core/kinematics/rotation.h"

#include <cmath>

namespace nineline::kinematics {

namespace {
constexpr double kSeriesBelow = 1e-8;  // of the squared angle

struct Coefficients {
  double a, b, c;  // sin t / t, (1 − cos t)/t², (t − sin t)/t³
};

Coefficients coefficients(double t2) {
  if (t2 < kSeriesBelow) return {1.0 - t2 / 6.0, 0.5 - t2 / 24.0, 1.0 / 6.0 - t2 / 120.0};
  const double t = std::sqrt(t2);
  const double half = std::sin(0.5 * t);
  const double sine = std::sin(t);
  return {sine / t, 2.0 * half * half / t2, (t - sine) / (t2 * t)};
}

/// I·k0 + k1 [w]× + k2 [w]×², written out.
Matrix3d polynomial(const Vector3d& w, double k1, double k2) {
  const double x = w.x(), y = w.y(), z = w.z();
  Matrix3d m;
  m << 1.0 - k2 * (y * y + z * z), k2 * x * y - k1 * z, k2 * x * z + k1 * y,  //
      k2 * x * y + k1 * z, 1.0 - k2 * (x * x + z * z), k2 * y * z - k1 * x,   //
      k2 * x * z - k1 * y, k2 * y * z + k1 * x, 1.0 - k2 * (x * x + y * y);
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
  const Vector3d v = 0.5 * Vector3d(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1));
  const double sine = v.norm();
  const double cosine = 0.5 * (R.trace() - 1.0);
  if (sine > 1e-9 || cosine > 0.0) {
    return sine > 1e-12 ? Vector3d(v * (std::atan2(sine, cosine) / sine)) : v;
  }
  // Half a turn: R = 2 u uᵀ − I.
  Eigen::Index largest = 0;
  R.diagonal().maxCoeff(&largest);
  const Vector3d column = R.col(largest) + Matrix3d::Identity().col(largest);
  return column.normalized() * std::atan2(sine, cosine);
}

Matrix3d rotationAbout(const Vector3d& axis, double angle) {
  const double half = std::sin(0.5 * angle);
  return polynomial(axis, std::sin(angle), 2.0 * half * half);
}

}  // namespace nineline::kinematics
