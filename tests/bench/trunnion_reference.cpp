#include "tests/bench/trunnion_reference.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/errors/table_effects.h"
#include "core/kinematics/machine_file.h"

namespace nineline::bench {

using Eigen::Matrix4d;
using Eigen::Vector3d;

namespace {

constexpr bool isRotary(int joint) { return joint < 2; }

Matrix4d turn(int row, double angle) {
  Matrix4d T = Matrix4d::Identity();
  T.topLeftCorner<3, 3>() = Eigen::AngleAxisd(angle, Vector3d::Unit(row)).toRotationMatrix();
  return T;
}

/// A and C turn about −X and −Z; X Y Z slide along their axes.
Matrix4d jointMatrix(int joint, double q) {
  if (joint == 0) return turn(0, -q);
  if (joint == 1) return turn(2, -q);
  Matrix4d T = Matrix4d::Identity();
  T(joint - 2, 3) = q;
  return T;
}

Matrix4d errorMatrix(const double* e) {
  Matrix4d T;
  T << 1, -e[5], e[4], e[0], e[5], 1, -e[3], e[1], -e[4], e[3], 1, e[2], 0, 0, 0, 1;
  return T;
}

/// v := E v, first order; `back`: the inverse to first order.
void applyError(const double* e, Vector3d& v, bool point, bool back) {
  const Vector3d w(e[3], e[4], e[5]);
  const Vector3d d(e[0], e[1], e[2]);
  if (back) {
    const Vector3d moved = point ? Vector3d(v - d) : v;
    v = moved - w.cross(moved);
  } else {
    v += w.cross(v) + (point ? d : Vector3d::Zero());
  }
}

void turnBack(int row, double angle, Vector3d& v) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const int a = (row + 1) % 3;
  const int b = (row + 2) % 3;
  const double old = v[a];
  v[a] = c * old - s * v[b];
  v[b] = s * old + c * v[b];
}

/// Closed form of the ideal trunnion: commands for a tip and an axis, next to `near`.
FiveJoints closedForm(const Vector3d& tip, const Vector3d& axis, const FiveJoints& near) {
  FiveJoints q = near;
  const double tilt = std::atan2(std::hypot(axis.x(), axis.y()), axis.z());
  const double sign = near[0] < 0.0 ? -1.0 : 1.0;  // axis = (sin A sin C, −sin A cos C, cos A)
  q[0] = sign * tilt;
  q[1] = std::atan2(sign * axis.x(), -sign * axis.y());
  q[1] += kTurn * std::rint((near[1] - q[1]) / kTurn);
  Vector3d p = tip;
  turnBack(2, -q[1], p);
  turnBack(0, -q[0], p);
  for (int k = 0; k < 3; ++k) q[static_cast<std::size_t>(k + 2)] = p[k];
  return q;
}

}  // namespace

TrunnionReference::TrunnionReference() {
  for (int joint = 0; joint < 5; ++joint) {
    for (int i = 0; i < kNodes; ++i) {
      for (int row = 0; row < 6; ++row)
        nodes_[joint][i][row] = (row < 3 ? 0.036 : 1e-4) * std::sin(0.11 * i * (row + 1) + joint + 0.7 * row);
    }
  }
}

double TrunnionReference::startOf(int joint) { return isRotary(joint) ? -7.0 : -500.0; }
double TrunnionReference::spacingOf(int joint) { return -2.0 * startOf(joint) / (kNodes - 1); }

void TrunnionReference::errorsAt(int joint, double q, double* six) const {
  const double s = std::clamp((q - startOf(joint)) / spacingOf(joint), 0.0, kNodes - 1.001);
  const int i = static_cast<int>(s);
  const double w = s - i;
  for (int row = 0; row < 6; ++row)
    six[row] = nodes_[joint][i][row] + w * (nodes_[joint][i + 1][row] - nodes_[joint][i][row]);
}

Vector3d TrunnionReference::textbook(const FiveJoints& q, Vector3d& axis) const {
  Matrix4d sides[2] = {Matrix4d::Identity(), Matrix4d::Identity()};
  for (int joint = 0; joint < 5; ++joint) {
    double e[6];
    errorsAt(joint, q[static_cast<std::size_t>(joint)], e);
    Matrix4d& T = sides[joint < 2 ? 0 : 1];
    T = T * jointMatrix(joint, q[static_cast<std::size_t>(joint)]) * errorMatrix(e);
  }
  const Matrix4d T_WP = sides[0].inverse() * sides[1];
  axis = T_WP.block<3, 1>(0, 2);
  return T_WP.block<3, 1>(0, 3);
}

Vector3d TrunnionReference::byHand(const FiveJoints& q, Vector3d& axis) const {
  Vector3d p = Vector3d::Zero();
  axis = Vector3d::UnitZ();
  double e[6];
  for (int joint = 4; joint >= 2; --joint) {
    errorsAt(joint, q[static_cast<std::size_t>(joint)], e);
    applyError(e, p, true, false);
    applyError(e, axis, false, false);
    p[joint - 2] += q[static_cast<std::size_t>(joint)];
  }
  for (int joint = 0; joint < 2; ++joint) {
    errorsAt(joint, q[static_cast<std::size_t>(joint)], e);
    for (Vector3d* v : {&p, &axis}) {
      turnBack(joint == 0 ? 0 : 2, q[static_cast<std::size_t>(joint)], *v);
      applyError(e, *v, v == &p, true);
    }
  }
  return p;
}

FiveJoints TrunnionReference::compensated(const FiveJoints& ideal, bool by_hand) const {
  // What the ideal machine does at `ideal` is the target.
  Vector3d wanted_axis = Vector3d::UnitZ();
  Vector3d wanted(ideal[2], ideal[3], ideal[4]);
  for (Vector3d* v : {&wanted, &wanted_axis}) {
    turnBack(0, ideal[0], *v);
    turnBack(2, ideal[1], *v);
  }
  FiveJoints q = ideal;
  Vector3d aim = wanted;
  Vector3d aim_axis = wanted_axis;
  for (int iteration = 0; iteration < 3; ++iteration) {
    Vector3d axis;
    const Vector3d tip = by_hand ? byHand(q, axis) : textbook(q, axis);
    aim += wanted - tip;
    aim_axis = (aim_axis + wanted_axis - axis).normalized();
    q = closedForm(aim, aim_axis, q);
  }
  return q;
}

errors::ErrorModel TrunnionReference::model() const {
  const kinematics::Machine& machine = *kinematics::findBuiltInMachine("trunnion-ac");
  std::vector<errors::EffectPtr> effects;
  for (int joint = 0; joint < 5; ++joint) {
    for (int row = 0; row < 6; ++row) {
      std::vector<double> values;
      for (const auto& node : nodes_[joint]) values.push_back(node[row]);
      errors::ErrorTable::Grid grid{startOf(joint), spacingOf(joint), errors::Interpolation::Linear,
                                    std::nullopt};
      effects.push_back(std::make_shared<errors::TableEffect>(
          joint, errors::Component{machine.joint(joint).axis, row, false},
          errors::ErrorTable::make(grid, std::move(values)).value(), false));
    }
  }
  return errors::ErrorModel::make(machine, std::move(effects)).value();
}

std::vector<FiveJoints> commandsOfPath(int count) {
  std::vector<FiveJoints> path;
  for (int i = 0; i < count; ++i) {
    const double t = kTurn * i / count;
    const double r = 100 + 60 * std::sin(23 * t);
    path.push_back({radFromDeg(35 + 20 * std::sin(3 * t)), radFromDeg(170 * std::sin(2 * t)),
                    r * std::cos(17 * t), r * std::sin(17 * t), -40 + 30 * std::sin(5 * t)});
  }
  return path;
}

}  // namespace nineline::bench
