#pragma once

#include <ceres/rotation.h>

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "core/kinematics/machine.h"

namespace nineline::bench {

inline constexpr double kNoise = 1e-3;       // mm
inline constexpr double kAngleNoise = 1e-5;  // rad
inline constexpr std::array<double, 3> kTip{40.0, -25.0, -150.0};

/// How the six errors of a linear axis are made of parameters: weights of the lateral ones and of the others.
struct Shape {
  int nodes = 0;   // 0: powers
  int degree = 3;  // of powers
  bool rotary = true;
  [[nodiscard]] int lateral() const { return nodes > 0 ? nodes - 2 : degree; }
  [[nodiscard]] int other() const { return nodes > 0 ? nodes - 1 : degree; }
};

// --- the reference: Ceres with automatic derivatives ---

template <class T>
using Vec3 = Eigen::Matrix<T, 3, 1>;
template <class T>
using Mat3 = Eigen::Matrix<T, 3, 3>;

template <class T>
Mat3<T> about(int axis, const T& angle) {
  using std::cos;
  using std::sin;
  Mat3<T> R = Mat3<T>::Identity();
  const int b = (axis + 1) % 3;
  const int c = (axis + 2) % 3;
  R(b, b) = R(c, c) = cos(angle);
  R(c, b) = sin(angle);
  R(b, c) = -sin(angle);
  return R;
}

/// A pose with its weights: readings and prediction through the same chain, once more, as a template.
struct Pose {
  const Shape* shape = nullptr;
  kinematics::JointPositions q{};
  bool angular = false;
  Eigen::Vector3d reading = Eigen::Vector3d::Zero();
  std::array<Eigen::VectorXd, 3> lateral, other;

  template <class T>
  void chain(const T* p, bool has_errors, Mat3<T>& R, Vec3<T>& tip) const {
    const int linear = shape->rotary ? 2 : 0;  // joint order: A C X Y Z
    const int per_axis = 2 * shape->lateral() + 4 * shape->other();
    const T* squareness = p + 3 * per_axis;
    Mat3<T> R_M = Mat3<T>::Identity();
    Vec3<T> p_M = Vec3<T>::Zero();
    for (int axis = 0; axis < 3; ++axis) {
      if (has_errors && axis == 1) R_M = R_M * about(2, squareness[0]);
      if (has_errors && axis == 2) R_M = R_M * about(0, squareness[1]) * about(1, squareness[2]);
      Vec3<T> step = Vec3<T>::Zero();
      step[axis] += T(q[static_cast<std::size_t>(linear + axis)]);
      if (!has_errors) {
        p_M += R_M * step;
        continue;
      }
      T six[6];
      const T* at = p + axis * per_axis;
      for (int row = 0; row < 6; ++row) {
        const Eigen::VectorXd& weights =
            (row < 3 && row != axis ? lateral : other)[static_cast<std::size_t>(axis)];
        six[row] = T(0.0);
        for (Eigen::Index k = 0; k < weights.size(); ++k) six[row] += weights[k] * *at++;
      }
      for (int k = 0; k < 3; ++k) step[k] += six[k];
      p_M += R_M * step;
      Mat3<T> small;
      ceres::AngleAxisToRotationMatrix(six + 3, small.data());
      R_M = R_M * small;
    }
    tip = p_M + R_M * Vec3<T>(T(kTip[0]), T(kTip[1]), T(kTip[2]));
    Mat3<T> R_W = Mat3<T>::Identity();
    Vec3<T> p_W = Vec3<T>::Zero();
    if (shape->rotary) {
      const T* r = squareness + 3;
      if (has_errors) p_W += Vec3<T>(T(0.0), r[0], r[1]);
      if (has_errors) R_W = about(1, r[2]) * about(2, r[3]);
      R_W = R_W * about(0, T(q[0]));
      if (has_errors) p_W += R_W * Vec3<T>(r[4], r[5], T(0.0));
      if (has_errors) R_W = R_W * about(0, r[6]) * about(1, r[7]) * about(2, r[8]);
      R_W = R_W * about(2, T(q[1]));
    }
    tip = (R_W.transpose() * (tip - p_W)).eval();
    R = R_W.transpose() * R_M;
  }

  template <class T>
  bool operator()(const T* p, T* residual) const {
    Mat3<T> R;
    Vec3<T> tip;
    chain(p, true, R, tip);
    Eigen::Matrix3d R0;
    Eigen::Vector3d tip0;
    chain(static_cast<const double*>(nullptr), false, R0, tip0);
    if (!angular) {
      for (int k = 0; k < 3; ++k) residual[k] = (tip[k] - tip0[k] - reading[k]) / kNoise;
      return true;
    }
    const Mat3<T> deviation = R * R0.transpose().cast<T>();
    T w[3];
    ceres::RotationMatrixToAngleAxis(deviation.data(), w);
    for (int k = 0; k < 3; ++k) residual[k] = (w[k] - reading[k]) / kAngleNoise;
    return true;
  }
};

}  // namespace nineline::bench
