#pragma once

#include <Eigen/Core>

#include "core/identification/nine_line.h"

namespace nineline::identification {

/// The six errors of one position: δ in rows 0…2 (mm), ε in rows 3…5 (rad).
using SixErrors = Eigen::Matrix<double, 6, 1>;

/// What a reading says for errors, without inclination, mm.
[[nodiscard]] double predictReading(const LineReading& reading, const SixErrors& errors, LineMethod method);

/// Its derivative with respect to the six errors.
[[nodiscard]] Eigen::Matrix<double, 1, 6> readingGradient(const LineReading& reading, const SixErrors& errors,
                                                          LineMethod method);

/// Largest distance of targets from each other or from the reference point, mm: the lever that makes
/// rotations comparable to translations. At least 1.
[[nodiscard]] double leverOf(const LineSetup& setup);

/// Singular values and the space that a weighted, scaled matrix leaves open.
struct Decomposition {
  Eigen::MatrixXd pseudo_inverse;  ///< of the unscaled, weighted matrix
  Eigen::MatrixXd covariance;      ///< pseudo_inverse · pseudo_inverseᵀ
  Eigen::MatrixXd open;            ///< columns: unit directions of the scaled unknowns that change no reading
  int rank = 0;
  double condition_number = 0.0;  ///< largest over smallest singular value above the threshold
};

/// `scale` per unknown: the size of it that counts as one. Singular values below 1e-9 of the largest are zero
/// (theory.md, 2.1). With `rank` the smallest are zero beyond that many: what is open where all errors are
/// zero stays open where second-order terms make it faintly visible.
[[nodiscard]] Decomposition decompose(const Eigen::MatrixXd& weighted, const Eigen::VectorXd& scale,
                                      std::optional<int> rank = std::nullopt);

}  // namespace nineline::identification
