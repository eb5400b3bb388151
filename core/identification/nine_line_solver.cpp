#include "core/identification/nine_line_solver.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/kinematics/rotation.h"

namespace nineline::identification {

namespace {

constexpr double kZeroSingularValue = 1e-9;  // of the largest

}  // namespace

double predictReading(const LineReading& reading, const SixErrors& errors, LineMethod method) {
  const Vector3d delta = errors.head<3>(), epsilon = errors.tail<3>();
  if (method == LineMethod::FirstOrder) return reading.direction.dot(delta + epsilon.cross(reading.target));
  const Vector3d turned = kinematics::exponential(epsilon) * reading.target;
  return reading.direction.dot(delta + (turned - reading.target));
}

Eigen::Matrix<double, 1, 6> readingGradient(const LineReading& reading, const SixErrors& errors,
                                            LineMethod method) {
  Eigen::Matrix<double, 1, 6> gradient;
  gradient.head<3>() = reading.direction.transpose();
  if (method == LineMethod::FirstOrder) {
    gradient.tail<3>() = reading.target.cross(reading.direction).transpose();
    return gradient;
  }
  const Vector3d epsilon = errors.tail<3>();
  const Vector3d turned = kinematics::exponential(epsilon) * reading.target;
  gradient.tail<3>() = turned.cross(reading.direction).transpose() * kinematics::leftJacobian(epsilon);
  return gradient;
}

double leverOf(const LineSetup& setup) {
  double lever = 1.0;
  for (const LineReading& one : setup.readings) {
    lever = std::max(lever, one.target.norm());
    for (const LineReading& other : setup.readings)
      lever = std::max(lever, (one.target - other.target).norm());
  }
  return lever;
}

Decomposition decompose(const Eigen::MatrixXd& weighted, const Eigen::VectorXd& scale,
                        std::optional<int> rank) {
  const Eigen::MatrixXd scaled = weighted * scale.asDiagonal();
  const Eigen::BDCSVD<Eigen::MatrixXd> svd(scaled, Eigen::ComputeThinU | Eigen::ComputeFullV);
  const Eigen::VectorXd& values = svd.singularValues();
  Decomposition result;
  while (result.rank < values.size() && values(result.rank) > kZeroSingularValue * values(0)) ++result.rank;
  if (rank) result.rank = std::min(*rank, result.rank);
  const Eigen::MatrixXd seen = scale.asDiagonal() * svd.matrixV().leftCols(result.rank) *
                               values.head(result.rank).cwiseInverse().asDiagonal();
  result.pseudo_inverse = seen * svd.matrixU().leftCols(result.rank).transpose();
  result.covariance = seen * seen.transpose();
  result.open = svd.matrixV().rightCols(scaled.cols() - result.rank);
  result.condition_number = result.rank > 0 ? values(0) / values(result.rank - 1) : 0.0;
  return result;
}

}  // namespace nineline::identification
