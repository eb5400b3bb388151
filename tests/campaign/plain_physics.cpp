#include "tests/campaign/plain_physics.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace nineline::campaign {

namespace {

using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Matrix4d translation(const Vector3d& by) {
  Matrix4d T = Matrix4d::Identity();
  T.topRightCorner<3, 1>() = by;
  return T;
}

Matrix4d rotation(const Vector3d& w) {
  const double angle = w.norm();
  Matrix4d T = Matrix4d::Identity();
  if (angle == 0.0) return T;
  Matrix3d K;
  K << 0.0, -w.z(), w.y(), w.z(), 0.0, -w.x(), -w.y(), w.x(), 0.0;
  const double half = std::sin(0.5 * angle) / angle;
  T.topLeftCorner<3, 3>() += (std::sin(angle) / angle) * K + 2.0 * half * half * K * K;
  return T;
}

/// Second derivatives at the grid points of the cubic spline: natural ends, or periodic.
std::vector<double> curvatureOf(const PlainTable& table) {
  const auto n = static_cast<Eigen::Index>(table.values.size());
  if (table.location || n < 3) return std::vector<double>(table.values.size(), 0.0);
  MatrixXd A = MatrixXd::Zero(n, n);
  VectorXd b = VectorXd::Zero(n);
  const double h = table.spacing;
  for (Eigen::Index i = 0; i < n; ++i) {
    if (!table.periodic && (i == 0 || i == n - 1)) {
      A(i, i) = 1.0;
      continue;
    }
    const Eigen::Index before = (i + n - 1) % n;
    const Eigen::Index after = (i + 1) % n;
    A(i, before) += h / 6.0;
    A(i, i) += 2.0 * h / 3.0;
    A(i, after) += h / 6.0;
    const auto y = [&](Eigen::Index k) { return table.values[static_cast<std::size_t>(k)]; };
    b[i] = (y(after) - 2.0 * y(i) + y(before)) / h;
  }
  const VectorXd solution = A.fullPivLu().solve(b);
  return {solution.data(), solution.data() + n};
}

}  // namespace

PlainPhysics::PlainPhysics(const PlainMachine& machine) : machine_(machine) {
  for (const PlainTable& table : machine_.tables) curvatures_.push_back(curvatureOf(table));
  for (const PlainEffect& effect : machine_.effects) {
    if (effect.kind == PlainEffect::Kind::Backlash)
      width_[static_cast<std::size_t>(effect.joint)] += effect.size;
  }
}

double PlainPhysics::valueOf(const PlainTable& table, const std::vector<double>& curvature, double q) const {
  if (table.location) return table.values.front();
  const auto count = static_cast<double>(table.values.size());
  double place = (q - table.start) / table.spacing;
  if (table.periodic) place -= count * std::floor(place / count);
  if (!table.periodic) place = std::clamp(place, 0.0, count - 1.0);
  auto i = static_cast<std::size_t>(place);
  if (!table.periodic) i = std::min(i, table.values.size() - 2);
  i = std::min(i, table.values.size() - 1);
  const std::size_t j = (i + 1) % table.values.size();
  const double b = place - static_cast<double>(i);
  const double a = 1.0 - b;
  const double h = table.spacing;
  return a * table.values[i] + b * table.values[j] +
         ((a * a * a - a) * curvature[i] + (b * b * b - b) * curvature[j]) * h * h / 6.0;
}

PlainPose PlainPhysics::pose(const Positions& q, const Positions* play) const {
  std::array<std::array<double, 6>, 9> located{};
  std::array<std::array<double, 6>, 9> standing{};
  std::array<std::array<double, 6>, 9> moved{};
  std::array<double, 9> own{};
  if (play != nullptr) {
    for (std::size_t t = 0; t < machine_.tables.size(); ++t) {
      const PlainTable& table = machine_.tables[t];
      const auto joint = static_cast<std::size_t>(table.joint);
      auto& slot = table.location ? located : table.fixed_frame ? standing : moved;
      slot[joint][static_cast<std::size_t>(table.row)] += valueOf(table, curvatures_[t], q[joint]);
    }
    for (const PlainEffect& effect : machine_.effects) {
      const auto joint = static_cast<std::size_t>(effect.joint);
      if (effect.kind == PlainEffect::Kind::Scale) own[joint] += effect.size * q[joint];
      if (effect.kind == PlainEffect::Kind::Cyclic)
        own[joint] += effect.size * std::sin(6.283185307179586 * q[joint] / effect.period + effect.phase);
      if (effect.kind == PlainEffect::Kind::ThermalScrew)
        own[joint] += effect.size * effect.above_20_C * (q[joint] - effect.fixed);
    }
    for (std::size_t joint = 0; joint < jointCount(); ++joint) own[joint] += (*play)[joint];
  }
  const auto slide = [](const std::array<double, 6>& six) { return Vector3d(six[0], six[1], six[2]); };
  const auto turn = [](const std::array<double, 6>& six) { return Vector3d(six[3], six[4], six[5]); };
  Matrix4d workpiece = Matrix4d::Identity();
  Matrix4d tool = Matrix4d::Identity();
  for (std::size_t i = 0; i < jointCount(); ++i) {
    const PlainJoint& joint = machine_.joints[i];
    Matrix4d& chain = joint.on_workpiece ? workpiece : tool;
    const Vector3d along = own[i] * joint.direction;
    chain = chain * translation(joint.offset) * translation(slide(located[i]));
    for (int k = 0; k < 3; ++k)
      chain = chain * rotation(located[i][static_cast<std::size_t>(3 + k)] * Vector3d::Unit(k));
    chain = chain * translation(slide(standing[i])) * rotation(turn(standing[i]));
    chain = chain * (joint.rotary ? rotation(q[i] * joint.direction) : translation(q[i] * joint.direction));
    const Vector3d delta = slide(moved[i]) + (joint.rotary ? Vector3d(Vector3d::Zero()) : along);
    const Vector3d epsilon = turn(moved[i]) + (joint.rotary ? along : Vector3d(Vector3d::Zero()));
    chain = chain * translation(delta) * rotation(epsilon);
  }
  const Matrix4d T_WP = workpiece.inverse() * tool * translation(machine_.tool_tip);
  return {T_WP.topRightCorner<3, 1>(), T_WP.block<3, 1>(0, 2).normalized()};
}

PlainPose PlainPhysics::best(const Positions& q, const Positions& play, const PlainPose& ideal,
                             double lever) const {
  const auto n = static_cast<Eigen::Index>(jointCount());
  const auto residual = [&](const Positions& at) {
    const PlainPose now = actual(at, play);
    VectorXd r(6);
    r << now.tip - ideal.tip, lever * (now.axis - ideal.axis);
    return r;
  };
  Positions at = q;
  for (int step = 0; step < 4; ++step) {
    const VectorXd r = residual(at);
    MatrixXd J(6, n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const double h = machine_.joints[k].rotary ? 1e-5 : 1e-3;
      Positions up = at;
      Positions down = at;
      up[k] += h;
      down[k] -= h;
      // A turn counts by the arc on a radius of 100 mm, so that the cut-off below means the same for all.
      J.col(i) = (residual(up) - residual(down)) / (2.0 * h) / (machine_.joints[k].rotary ? 100.0 : 1.0);
    }
    Eigen::JacobiSVD<MatrixXd> svd(J, Eigen::ComputeThinU | Eigen::ComputeThinV);
    svd.setThreshold(1e-3);
    const VectorXd dq = svd.solve(-r);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      at[k] += dq[i] / (machine_.joints[k].rotary ? 100.0 : 1.0);
    }
  }
  return actual(at, play);
}

void PlainPlay::move(const Positions& from, const Positions& to) {
  for (std::size_t i = 0; i < physics_.jointCount(); ++i) {
    const double half = 0.5 * physics_.playWidth(i);
    const double way = to[i] - from[i];
    if (half == 0.0 || way == 0.0) continue;
    // Nothing is known of the time before: the first motion finds the play taken up.
    if (!moved_[i]) offsets_[i] = way > 0.0 ? -half : half;
    moved_[i] = true;
    offsets_[i] = std::min(half, std::max(-half, offsets_[i] - way));
  }
}

}  // namespace nineline::campaign
