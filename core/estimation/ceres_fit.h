#pragma once

#include <functional>

#include "core/base/result.h"
#include "core/estimation/basis.h"

namespace nineline::estimation {

/// Residuals in units of their standard uncertainty at x, and their Jacobian (rows: residuals) where it is
/// asked for.
using ResidualFunction = std::function<void(const VectorXd& x, VectorXd& residuals, MatrixXd* jacobian)>;

/// Any small non-linear least squares problem, by Levenberg-Marquardt (Ceres): for fits whose unknowns do not
/// enter nearly linearly, and as a second opinion on fit(). Within the machine's own unknowns fit() is the
/// faster by far (tests/bench/estimation_benchmark.cpp).
struct CeresFit {
  VectorXd x;
  double cost = 0.0;  ///< ½ Σ residual²
  int iterations = 0;
};
/// `huber` above 0 applies Huber's loss at that size. Fails with NoAnswer when it does not converge.
[[nodiscard]] Result<CeresFit> fitWithCeres(const ResidualFunction& function, Index residuals, VectorXd start,
                                            double huber = 0.0);

}  // namespace nineline::estimation
