#include "core/estimation/ceres_fit.h"

#include <ceres/ceres.h>

namespace nineline::estimation {

namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Rows [first, first + count) of the function as one cost; the function is evaluated once for all of them.
struct Evaluation {
  const ResidualFunction* function;
  VectorXd x;
  VectorXd residuals;
  MatrixXd jacobian;
  bool has_jacobian = false;

  void at(const VectorXd& point, bool with_jacobian) {
    if (x.size() == point.size() && x == point && (has_jacobian || !with_jacobian)) return;
    x = point;
    has_jacobian = with_jacobian;
    (*function)(x, residuals, with_jacobian ? &jacobian : nullptr);
  }
};

class Rows final : public ceres::CostFunction {
 public:
  Rows(Evaluation& evaluation, Index first, Index count, Index parameters)
      : evaluation_(evaluation), first_(first) {
    set_num_residuals(static_cast<int>(count));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(parameters));
  }
  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const Index n = parameter_block_sizes()[0];
    const bool with_jacobian = jacobians != nullptr && jacobians[0] != nullptr;
    evaluation_.at(Eigen::Map<const VectorXd>(parameters[0], n), with_jacobian);
    Eigen::Map<VectorXd>(residuals, num_residuals()) = evaluation_.residuals.segment(first_, num_residuals());
    if (with_jacobian) {
      Eigen::Map<RowMajor>(jacobians[0], num_residuals(), n) =
          evaluation_.jacobian.middleRows(first_, num_residuals());
    }
    return true;
  }

 private:
  Evaluation& evaluation_;
  Index first_;
};

}  // namespace

Result<CeresFit> fitWithCeres(const ResidualFunction& function, Index residuals, VectorXd start,
                              double huber) {
  NL_EXPECTS(residuals > 0 && start.size() > 0, residuals, start.size());
  Evaluation evaluation{&function, {}, VectorXd(residuals), MatrixXd(residuals, start.size()), false};
  ceres::Problem problem;
  const Index block = huber > 0.0 ? 1 : residuals;  // a loss acts on a residual block as a whole
  for (Index first = 0; first < residuals; first += block) {
    problem.AddResidualBlock(new Rows(evaluation, first, block, start.size()),
                             huber > 0.0 ? new ceres::HuberLoss(huber) : nullptr, start.data());
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = 100;
  options.function_tolerance = 1e-14;
  options.parameter_tolerance = 1e-14;
  options.gradient_tolerance = 1e-16;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  if (!summary.IsSolutionUsable()) {
    return noAnswer("estimation.convergence", "The fit does not settle: " + summary.message);
  }
  return CeresFit{std::move(start), summary.final_cost, static_cast<int>(summary.iterations.size())};
}

}  // namespace nineline::estimation
