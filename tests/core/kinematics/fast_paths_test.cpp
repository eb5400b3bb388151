#include <gtest/gtest.h>

#include <Eigen/SVD>

#include "core/kinematics/machine_file.h"
#include "core/kinematics/step_solver.h"
#include "tests/support/random_machines.h"

namespace nineline::kinematics {
namespace {

using test_support::Random;

/// The chain as theory.md writes it: products of 4×4 matrices.
Eigen::Isometry3d plainMotion(const SmallMotion& motion, RotationModel model) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  const double angle = motion.rotation.norm();
  if (model == RotationModel::FirstOrder) {
    T.linear() = Matrix3d::Identity() + skew(motion.rotation);
  } else if (angle > 0.0) {
    T.linear() = Eigen::AngleAxisd(angle, motion.rotation / angle).toRotationMatrix();
  }
  T.translation() = motion.translation;
  return T;
}

Eigen::Isometry3d plainLocated(const SmallMotion& located, RotationModel model) {
  if (model == RotationModel::FirstOrder) return plainMotion(located, model);
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translate(located.translation);
  for (int k = 0; k < 3; ++k) T.rotate(Eigen::AngleAxisd(located.rotation[k], Vector3d::Unit(k)));
  return T;
}

ToolPose plainForward(const Machine& machine, const JointPositions& q,
                      const JointDisplacements& displacements, RotationModel model) {
  Eigen::Matrix4d sides[2] = {Eigen::Matrix4d::Identity(), Eigen::Matrix4d::Identity()};
  for (int i = 0; i < machine.jointCount(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Joint& joint = machine.joint(i);
    Eigen::Isometry3d T_LN = Eigen::Isometry3d::Identity();
    if (joint.type == JointType::Linear) {
      T_LN.translate(q[k] * joint.direction);
    } else {
      T_LN.rotate(Eigen::AngleAxisd(q[k], joint.direction));
    }
    Eigen::Matrix4d& T_MD = sides[machine.side(i) == Side::Tool];
    T_MD = T_MD * Eigen::Isometry3d(Eigen::Translation3d(joint.offset)).matrix() *
           plainLocated(displacements[k].located, model).matrix() *
           plainMotion(displacements[k].standing, model).matrix() * T_LN.matrix() *
           plainMotion(displacements[k].moved, model).matrix();
  }
  const Eigen::Matrix4d T_WP =
      sides[0].inverse() * sides[1] * Eigen::Isometry3d(Eigen::Translation3d(machine.toolTip())).matrix();
  ToolPose pose;
  pose.tip = T_WP.topRightCorner<3, 1>();
  pose.R_WP = T_WP.topLeftCorner<3, 3>();
  pose.axis = (pose.R_WP * machine.toolAxis()).normalized();
  return pose;
}

void expectSamePose(const ToolPose& fast, const ToolPose& plain, const std::string& what) {
  EXPECT_LT((fast.tip - plain.tip).norm(), 1e-11) << what;
  EXPECT_LT((fast.R_WP - plain.R_WP).norm(), 1e-13) << what;
  EXPECT_LT((fast.axis - plain.axis).norm(), 1e-13) << what;
}

TEST(FastChain, AgreesWithProductsOfMatrices) {
  Random random(811);
  for (int trial = 0; trial < 300; ++trial) {
    const Machine machine = test_support::randomMachine(random, random.whole(1, kMaxAxes));
    const JointPositions q = test_support::randomPositions(random, machine);
    const double angle = trial % 3 == 0 ? 0.3 : trial % 3 == 1 ? 0.0099 : 1e-4;
    const JointDisplacements moved = test_support::randomDisplacements(random, machine, angle);
    for (const RotationModel model : {RotationModel::Exact, RotationModel::FirstOrder}) {
      expectSamePose(forward(machine, q, moved, model), plainForward(machine, q, moved, model),
                     "trial " + std::to_string(trial));
    }
    expectSamePose(forward(machine, q), plainForward(machine, q, {}, RotationModel::Exact), "ideal");
  }
}

/// Steps by the singular values of the weighed Jacobian, whatever its shape (theory.md, 4.2).
JointPositions plainStep(const Machine& machine, const PoseJacobian& jacobian, const PoseResidual& residual,
                         const PoseTarget& target, const StepOptions& options) {
  Eigen::MatrixXd rows = Eigen::MatrixXd::Identity(6, 6);
  rows.bottomRightCorner(3, 3) *= options.rotation_length;
  if (target.rotation == PoseTarget::Rotation::None) rows.bottomRightCorner(3, 3).setZero();
  if (target.rotation == PoseTarget::Rotation::Axis)
    rows.bottomRightCorner(3, 3) *= Matrix3d::Identity() - target.axis * target.axis.transpose();
  Eigen::VectorXd scale = Eigen::VectorXd::Zero(machine.jointCount());
  for (int i = 0; i < machine.jointCount(); ++i) {
    if ((options.free >> i & 1U) != 0) scale[i] = machine.isRotary(i) ? 1.0 / options.rotary_length : 1.0;
  }
  const Eigen::MatrixXd A = rows * jacobian * scale.asDiagonal();
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(A, Eigen::ComputeThinU | Eigen::ComputeThinV);
  svd.setThreshold(options.weakest);
  const Eigen::VectorXd step = scale.asDiagonal() * svd.solve(rows * residual);
  JointPositions result{};
  for (int i = 0; i < machine.jointCount(); ++i) result[static_cast<std::size_t>(i)] = step[i];
  return result;
}

/// The fast inverse solves what the plain one solves; near singular poses both amplify their rounding.
void expectSameStep(const Machine& machine, const JointPositions& q, const PoseTarget& target,
                    const StepOptions& options, const PoseResidual& residual) {
  PoseJacobian jacobian;
  static_cast<void>(forwardWithJacobian(machine, q, jacobian));
  const JointPositions fast = leastSquaresStep(machine, jacobian, residual, target, options);
  const JointPositions plain = plainStep(machine, jacobian, residual, target, options);
  double largest = 0.0;
  for (const double value : plain) largest = std::max(largest, std::abs(value));
  for (std::size_t k = 0; k < fast.size(); ++k) {
    EXPECT_NEAR(fast[k], plain[k], 1e-9 * largest + 1e-15) << machine.id() << " joint " << k;
  }
}

TEST(FastStep, AgreesWithSingularValuesAlsoAtSingularPoses) {
  Random random(812);
  for (int trial = 0; trial < 3000; ++trial) {
    static constexpr const char* kIds[] = {"trunnion-ac", "head-head-bc", "table-head-bc", "generic-3axis",
                                           "b2-k3032"};
    const Machine& machine = *findBuiltInMachine(kIds[trial % 5]);
    JointPositions q = test_support::randomPositions(random, machine);
    // Every third pose has one joint at zero or next to it, where the mills are singular.
    const int at = random.whole(0, machine.jointCount() - 1);
    if (trial % 3 == 0) q[static_cast<std::size_t>(at)] = random.whole(0, 1) * random.between(-1e-3, 1e-3);
    const ToolPose pose = forward(machine, q);
    PoseTarget target{pose.tip, pose.axis, pose.R_WP, PoseTarget::Rotation::None};
    if (machine.jointCount() == 5 && trial % 2 == 0) target.rotation = PoseTarget::Rotation::Axis;
    StepOptions options;
    options.weakest = 1e-9;  // so that rounding does not decide what is left alone
    if (trial % 4 == 0) options.free = static_cast<unsigned>(random.whole(0, 31));
    PoseResidual residual;
    residual.head<3>() = random.vector(0.02);
    residual.tail<3>() = random.vector(1e-4);
    expectSameStep(machine, q, target, options, residual);
  }
}

TEST(FastStep, RandomFiveAxisMachines) {
  Random random(813);
  for (int trial = 0; trial < 1000; ++trial) {
    const Machine machine = test_support::randomMachine(random, 5);
    const JointPositions q = test_support::randomPositions(random, machine);
    const ToolPose pose = forward(machine, q);
    const PoseTarget target{pose.tip, pose.axis, pose.R_WP, PoseTarget::Rotation::Axis};
    StepOptions options;
    options.weakest = 1e-9;
    PoseResidual residual;
    residual.head<3>() = random.vector(0.02);
    residual.tail<3>() = random.vector(1e-4);
    expectSameStep(machine, q, target, options, residual);
  }
}

TEST(Rotation, TheSeriesMeetsTheClosedForm) {
  Random random(814);
  for (const double angle : {1e-12, 1e-6, 1e-4, 9.999e-3, 1.0001e-2, 0.05}) {
    const Vector3d axis = random.unitVector();
    const Matrix3d plain = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    EXPECT_LT((exponential(angle * axis) - plain).norm(), 4e-16) << angle;
  }
}

}  // namespace
}  // namespace nineline::kinematics
