#include "core/estimation/mixed_model.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace nineline::estimation {

namespace {

constexpr double kUsualRatio = 0.25;    // variance of run offsets by that of the noise, before any data
constexpr double kRatioFreedom = 0.5;   // runs that the usual ratio counts for
constexpr double kPooledFreedom = 4.0;  // runs that the ratio of all classes together counts for in one
// Of the stated repeatability, and of the largest level: keep readings without any noise finite.
constexpr double kLeastScale = 1e-6;
constexpr double kLeastShare = 1e-3;
constexpr double kJitter = 1e-13;        // added to the unit diagonal where rounding has made it indefinite
constexpr double kZeroPrecision = 1e-4;  // 1/mm²: an unused zero stays at 0

struct System {
  MatrixXd matrix;
  VectorXd right;
};

/// Factor by which a run group's sum pulls its offset: b = k (Σ w (r − a·step − zero)).
double pullOf(const NormalSums& sums, const NoiseLevels& noise, const RunGroup& group, Index g) {
  const double variance = noise.ratio[group.noise] * sums.group_variance[g];
  return variance / (1.0 + variance * sums.group_weight[g]);
}

/// The column of a run group in the system of parameters and zeros.
VectorXd groupColumn(const NormalSums& sums, const RunGroup& group, Index g, Index zeros) {
  VectorXd column = VectorXd::Zero(sums.size() + zeros);
  column.head(sums.size()) = sums.group_columns.col(g);
  if (group.zero >= 0) column[sums.size() + group.zero] = sums.group_weight[g];
  return column;
}

System assemble(const ReadingSet& readings, const NormalSums& sums, const NoiseLevels& noise) {
  const Index p = sums.size();
  const Index z = readings.zeroCount();
  System system{MatrixXd::Zero(p + z, p + z), VectorXd::Zero(p + z)};
  for (std::size_t c = 0; c < sums.matrix.size(); ++c) {
    const double weight = 1.0 / (noise.scale[c] * noise.scale[c]);
    system.matrix.topLeftCorner(p, p) += weight * sums.matrix[c];
    system.right.head(p) += weight * sums.right[c];
  }
  MatrixXd pulled(p + z, static_cast<Index>(readings.groups().size()));
  for (std::size_t n = 0; n < readings.groups().size(); ++n) {
    const RunGroup& group = readings.groups()[n];
    const auto g = static_cast<Index>(n);
    const double scale = noise.scale[group.noise];
    const double weight = 1.0 / (scale * scale);
    if (group.zero >= 0) {
      const Index at = p + group.zero;
      system.matrix.col(at).head(p) += weight * sums.group_columns.col(g);
      system.matrix.row(at).head(p) += weight * sums.group_columns.col(g);
      system.matrix(at, at) += weight * sums.group_weight[g];
      system.right[at] += weight * sums.group_right[g];
    }
    const double pull = pullOf(sums, noise, group, g);
    const VectorXd column = groupColumn(sums, group, g, z);
    pulled.col(g) = std::sqrt(weight * pull) * column;
    system.right -= weight * pull * sums.group_right[g] * column;
  }
  system.matrix.selfadjointView<Eigen::Lower>().rankUpdate(pulled, -1.0);
  system.matrix.triangularView<Eigen::StrictlyUpper>() = system.matrix.transpose();
  for (Index i = p; i < p + z; ++i) system.matrix(i, i) += kZeroPrecision;
  return system;
}

}  // namespace

NoiseLevels usualNoise(const ReadingSet& readings) {
  const std::size_t classes = readings.classes().size();
  return {std::vector<double>(classes, 1.0), std::vector<double>(classes, kUsualRatio)};
}

MatrixXd information(const ReadingSet& readings, const NormalSums& sums, const NoiseLevels& noise) {
  const MatrixXd all = assemble(readings, sums, noise).matrix;
  const Index p = sums.size();
  const Index z = readings.zeroCount();
  if (z == 0) return all;
  const MatrixXd cross = all.topRightCorner(p, z);
  const Eigen::LDLT<MatrixXd> zeros(all.bottomRightCorner(z, z));
  MatrixXd result = all.topLeftCorner(p, p) - cross * zeros.solve(cross.transpose());
  return 0.5 * (result + result.transpose());
}

Result<MixedSolution> solve(const ReadingSet& readings, const NormalSums& sums, const NoiseLevels& noise,
                            const Precision& prior, const VectorXd& at, bool with_covariance) {
  System system = assemble(readings, sums, noise);
  const Index p = sums.size();
  system.matrix.topLeftCorner(p, p) += prior;
  system.right.head(p) -= prior * at;
  const VectorXd unit = system.matrix.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  system.matrix = (unit.asDiagonal() * system.matrix * unit.asDiagonal()).eval();
  Eigen::LLT<MatrixXd> factor(system.matrix);
  if (factor.info() != Eigen::Success) {
    system.matrix.diagonal().array() += kJitter;
    factor.compute(system.matrix);
  }
  if (factor.info() != Eigen::Success) {
    return noAnswer("estimation.singular", "The readings do not determine the unknowns that were asked for.");
  }
  const VectorXd all = unit.cwiseProduct(factor.solve(unit.cwiseProduct(system.right)));
  MixedSolution solution;
  solution.step = all.head(p);
  solution.zeros = all.tail(readings.zeroCount());
  solution.offsets = VectorXd::Zero(static_cast<Index>(readings.groups().size()));
  for (std::size_t n = 0; n < readings.groups().size(); ++n) {
    const auto g = static_cast<Index>(n);
    const RunGroup& group = readings.groups()[n];
    const double rest = sums.group_right[g] - groupColumn(sums, group, g, readings.zeroCount()).dot(all);
    solution.offsets[g] = pullOf(sums, noise, group, g) * rest;
  }
  if (with_covariance) {
    solution.covariance = factor.solve(MatrixXd::Identity(all.size(), all.size()));
    solution.covariance = (unit.asDiagonal() * solution.covariance * unit.asDiagonal()).eval();
  }
  return solution;
}

double fittedVariance(const ReadingSet& readings, const NormalSums& sums, const NoiseLevels& noise,
                      const MixedSolution& solution, const VectorXd& a, std::size_t group) {
  const RunGroup& of_group = readings.groups()[group];
  const auto g = static_cast<Index>(group);
  const double pull = pullOf(sums, noise, of_group, g);
  const double scale = noise.scale[of_group.noise];
  // The offset follows from the parameters as b = pull (Σ w r − column · all) and an error of its own.
  VectorXd row = -pull * groupColumn(sums, of_group, g, readings.zeroCount());
  row.head(a.size()) += a;
  if (of_group.zero >= 0) row[a.size() + of_group.zero] += 1.0;
  return row.dot(solution.covariance * row) + scale * scale * pull;
}

VectorXd restOf(const Linearisation& linearisation, const VectorXd& change, const MixedSolution& solution) {
  const ReadingSet& readings = linearisation.readings();
  VectorXd rest = linearisation.residual() - change;
  for (std::size_t row = 0; row < readings.rows(); ++row) {
    const std::size_t g = readings.readings()[row].group;
    const int zero = readings.groups()[g].zero;
    double known = solution.offsets[static_cast<Index>(g)];
    if (zero >= 0) known += solution.zeros[zero];
    rest[static_cast<Index>(row)] -= known;
  }
  return rest;
}

namespace {

/// What one noise class has spent and left.
struct ClassSums {
  double freedom = 0.0;         // readings less what parameters, zeros and offsets took
  double square = 0.0;          // Σ w rest²
  double offset_square = 0.0;   // Σ b² / variance unit
  double offset_freedom = 0.0;  // Σ (1 − posterior variance / prior variance)
};

void addGroups(const ReadingSet& readings, const NormalSums& sums, const NoiseLevels& noise,
               const MixedSolution& solution, std::vector<ClassSums>& classes) {
  MatrixXd columns(solution.covariance.rows(), static_cast<Index>(readings.groups().size()));
  for (Index g = 0; g < columns.cols(); ++g) {
    const RunGroup& group = readings.groups()[static_cast<std::size_t>(g)];
    columns.col(g) = groupColumn(sums, group, g, readings.zeroCount());
  }
  const VectorXd spreads = columns.cwiseProduct(solution.covariance * columns).colwise().sum();
  for (std::size_t n = 0; n < readings.groups().size(); ++n) {
    const RunGroup& group = readings.groups()[n];
    const auto g = static_cast<Index>(n);
    const double scale = noise.scale[group.noise];
    const double unit = scale * scale * sums.group_variance[g];
    const double pull = pullOf(sums, noise, group, g);
    const double spread = spreads[g];
    const double prior = noise.ratio[group.noise] * unit;
    const double told =
        std::max(0.0, pull * sums.group_weight[g] - (prior > 0.0 ? pull * pull * spread / prior : 0.0));
    ClassSums& of_class = classes[group.noise];
    // Ĥ of the class loses pull · a aᵀ / scale², which gives pull · spread / scale² back.
    of_class.freedom += pull * spread / (scale * scale) - told;
    of_class.offset_freedom += told;
    of_class.offset_square += solution.offsets[g] * solution.offsets[g] / unit;
    if (group.zero < 0) continue;
    const Index at = sums.size() + group.zero;
    const double of_zero =
        2.0 * solution.covariance.col(at).head(sums.size()).dot(sums.group_columns.col(g)) +
        solution.covariance(at, at) * sums.group_weight[g];
    of_class.freedom -= of_zero / (scale * scale);
  }
}

}  // namespace

NoiseLevels updatedNoise(const ReadingSet& readings, const NormalSums& sums, const NoiseLevels& noise,
                         const MixedSolution& solution, const VectorXd& rest, const VectorXd& weights) {
  NL_EXPECTS(solution.covariance.size() > 0);
  std::vector<ClassSums> classes(sums.matrix.size());
  const Index p = sums.size();
  for (std::size_t c = 0; c < classes.size(); ++c) {
    const double taken = solution.covariance.topLeftCorner(p, p).cwiseProduct(sums.matrix[c]).sum();
    classes[c].freedom = sums.count[c] - taken / (noise.scale[c] * noise.scale[c]);
  }
  addGroups(readings, sums, noise, solution, classes);
  for (std::size_t row = 0; row < readings.rows(); ++row) {
    const ReadingPlace& reading = readings.readings()[row];
    const double part = rest[static_cast<Index>(row)] / reading.sigma;
    classes[readings.noiseOf(row)].square += weights[static_cast<Index>(row)] * part * part;
  }
  NoiseLevels out = noise;
  double pooled_square = kRatioFreedom * kUsualRatio;
  double pooled_freedom = kRatioFreedom;
  for (const ClassSums& one : classes) {
    pooled_square += one.offset_square;
    pooled_freedom += one.offset_freedom;
  }
  const double pooled = pooled_square / pooled_freedom;
  for (std::size_t c = 0; c < classes.size(); ++c) {
    const double stated = readings.classes()[c].stated ? kStatedFreedom : 0.0;
    const double freedom = classes[c].freedom + stated;
    if (freedom > 0.5) {
      out.scale[c] = std::max(kLeastScale, std::sqrt((classes[c].square + stated) / freedom));
    }
    out.ratio[c] =
        (classes[c].offset_square + kPooledFreedom * pooled) / (classes[c].offset_freedom + kPooledFreedom);
  }
  const double largest = *std::max_element(out.scale.begin(), out.scale.end());
  for (double& scale : out.scale) scale = std::max(scale, kLeastShare * largest);
  return out;
}

}  // namespace nineline::estimation
