#pragma once

#include <cmath>

#include "core/kinematics/chain.h"

namespace nineline::kinematics {

/// The frame axis 0 1 2 that a unit direction lies along, −1 where along none.
inline int principalAxis(const Vector3d& direction) {
  if (direction[0] == 0.0) {
    if (direction[1] == 0.0) return 2;
    return direction[2] == 0.0 ? 1 : -1;
  }
  return direction[1] == 0.0 && direction[2] == 0.0 ? 0 : -1;
}

inline bool isNothing(const Vector3d& v) { return v[0] == 0.0 && v[1] == 0.0 && v[2] == 0.0; }
inline bool isNothing(const SmallMotion& motion) {
  return isNothing(motion.translation) && isNothing(motion.rotation);
}

/// A pose under construction, rotation and translation. Columns are kept four long, the last coefficient
/// unused, so that they fill vector registers; a rotation that is still the identity costs nothing.
class Frame {
 public:
  [[nodiscard]] Matrix3d rotation() const {
    Matrix3d R;
    for (int k = 0; k < 3; ++k) R.col(k) = columns_[k].head<3>();
    return R;
  }
  [[nodiscard]] Vector3d position() const { return position_.head<3>(); }

  [[nodiscard]] Vector3d times(const Vector3d& v) const {
    return turned_ ? Vector3d(product(v.data()).head<3>()) : v;
  }
  /// The place in the frame outside of a point of this frame.
  [[nodiscard]] Vector3d at(const Vector3d& point) const { return position() + times(point); }

  void translate(const Vector3d& by) { position_ += product(by.data()); }

  /// R := R · by.
  void multiply(const Matrix3d& by) {
    const double* const b = by.data();
    const Column x = product(b);
    const Column y = product(b + 3);
    columns_[2] = product(b + 6);
    columns_[0] = x;
    columns_[1] = y;
    turned_ = true;
  }

  /// Turns about the frame's own axis k: two columns change.
  void turnAboutAxis(int k, double cosine, double sine) {
    Column& a = columns_[(k + 1) % 3];
    Column& b = columns_[(k + 2) % 3];
    const Column old = a;
    a = cosine * old + sine * b;
    b = cosine * b - sine * old;
    turned_ = true;
  }

  void turn(const Vector3d& direction, double angle) {
    const int k = principalAxis(direction);
    if (k < 0) return multiply(rotationAbout(direction, angle));
    turnAboutAxis(k, std::cos(angle), std::sin(angle) * direction[k]);
  }

  void slide(const Vector3d& direction, double distance) {
    const int k = principalAxis(direction);
    if (k < 0) return translate(distance * direction);
    position_ += (distance * direction[k]) * columns_[k];
  }

  void rotate(const Vector3d& w, RotationModel model) {
    if (isNothing(w)) return;
    multiply(model == RotationModel::Exact ? exponential(w) : Matrix3d(Matrix3d::Identity() + skew(w)));
  }

  void apply(const SmallMotion& motion, RotationModel model) {
    translate(motion.translation);
    rotate(motion.rotation, model);
  }

  /// Location errors turn about fixed axes in the order Rx(a) Ry(b) Rz(c) (theory.md, 1.3).
  void applyLocated(const SmallMotion& located, RotationModel model) {
    translate(located.translation);
    if (model == RotationModel::FirstOrder) return rotate(located.rotation, model);
    for (int k = 0; k < 3; ++k) {
      if (located.rotation[k] != 0.0)
        turnAboutAxis(k, std::cos(located.rotation[k]), std::sin(located.rotation[k]));
    }
  }

  void move(const Joint& joint, double q) {
    if (joint.type == JointType::Linear) return slide(joint.direction, q);
    turn(joint.direction, q);
  }

  /// Rᵀ v, the inverse rotation.
  [[nodiscard]] Vector3d transposedTimes(const Vector3d& v) const {
    if (!turned_) return v;
    const auto dot = [&v](const Column& c) { return c[0] * v[0] + c[1] * v[1] + c[2] * v[2]; };
    return {dot(columns_[0]), dot(columns_[1]), dot(columns_[2])};
  }
  [[nodiscard]] Matrix3d transposedTimes(const Frame& other) const {
    Matrix3d product;
    for (int k = 0; k < 3; ++k) {
      const Column& c = other.columns_[k];
      const Vector3d column = transposedTimes(Vector3d(c[0], c[1], c[2]));
      for (int i = 0; i < 3; ++i) product(i, k) = column[i];
    }
    return product;
  }
  /// Replaces the rotation by the transposed inverse, so that `transposedTimes` undoes it: for matrices that
  /// are not quite rotations.
  void invertSkewed() {
    if (!turned_) return;
    const Matrix3d inverse = rotation().inverse().transpose();
    for (int k = 0; k < 3; ++k) columns_[k].head<3>() = inverse.col(k);
  }

 private:
  using Column = Eigen::Vector4d;

  /// R v; the sum starts with v[0], so that the identity gives v exactly.
  [[nodiscard]] Column product(const double* v) const {
    return v[0] * columns_[0] + v[1] * columns_[1] + v[2] * columns_[2];
  }

  Column columns_[3] = {Column::UnitX(), Column::UnitY(), Column::UnitZ()};
  Column position_ = Column::Zero();
  bool turned_ = false;
};

}  // namespace nineline::kinematics
