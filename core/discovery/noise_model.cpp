#include "core/discovery/noise_model.h"

#include <algorithm>
#include <cmath>

#include "core/base/contract.h"

namespace nineline::discovery {

namespace {

constexpr double kOutlierInflation = 400.0;
constexpr double kLevelSpread = 0.6;  // prior standard deviation of ln s²

std::vector<NoiseShape> makeShapes() {
  struct Offset {
    double share, log_prior;
  };
  const std::vector<Offset> offsets = {{0.0, 0.0},  {0.08, 0.0},  {0.25, 0.0},
                                       {0.5, -0.5}, {0.75, -2.0}, {0.92, -5.0}};
  std::vector<NoiseShape> shapes;
  for (const double f : {0.0, 0.3, 0.6, 0.85}) {
    for (const double length : {2.5, 7.0, 20.0}) {
      if (f == 0.0 && length > 2.5) continue;
      for (const Offset& offset : offsets) {
        const double prior = offset.log_prior - (f > 0.8 ? 1.5 : 0.0) - (length > 15.0 ? 0.5 : 0.0);
        shapes.push_back({f, length, offset.share, prior});
      }
    }
  }
  return shapes;
}

double levelPrior(double level) {
  const double x = std::log(level) / kLevelSpread;
  return -0.5 * x * x;
}

bool isOptimistic(const NoiseShape& shape) {
  return shape.length < 8.0 && shape.offset < 0.3 && shape.correlated < 0.7;
}

}  // namespace

const std::vector<NoiseShape>& noiseShapes() {
  static const std::vector<NoiseShape> shapes = makeShapes();
  return shapes;
}

NoiseModel::NoiseModel(NoiseLayout layout) : layout_(std::move(layout)) {
  Index next = 0;
  for (const NoiseRun& run : layout_.runs) {
    NL_EXPECTS(run.first == next && run.count > 0 && run.group >= 0 && run.group < layout_.groups);
    next += run.count;
  }
  NL_EXPECTS(next == layout_.place.size());
  outliers_.assign(static_cast<std::size_t>(next), false);
  prepare();
}

void NoiseModel::setOutliers(const std::vector<bool>& outliers) {
  NL_EXPECTS(outliers.size() == outliers_.size());
  outliers_ = outliers;
  prepare();
}

void NoiseModel::prepare() {
  filters_.assign(layout_.runs.size(), {});
  counts_.assign(static_cast<std::size_t>(layout_.groups), 0);
  for (std::size_t r = 0; r < layout_.runs.size(); ++r) {
    const NoiseRun& run = layout_.runs[r];
    for (const NoiseShape& shape : noiseShapes()) filters_[r].push_back(makeFilter(run, shape));
    for (Index i = 0; i < run.count; ++i) {
      if (!outliers_[static_cast<std::size_t>(run.first + i)]) ++counts_[static_cast<std::size_t>(run.group)];
    }
  }
}

const NoiseModel::Filter& NoiseModel::filter(std::size_t run, std::size_t shape) const {
  return filters_[run][shape];
}

NoiseModel::Filter NoiseModel::makeFilter(const NoiseRun& run, const NoiseShape& shape) const {
  Filter f;
  for (VectorXd* v : {&f.decay, &f.gain, &f.offset_gain, &f.inverse_sigma}) v->resize(run.count);
  const double within = 1.0 - shape.offset;
  const double stationary = within * shape.correlated;
  const double white = within * (1.0 - shape.correlated);
  // Covariance of the two states before the sample: correlated part (a), offset (b), and between them (ab).
  double a = stationary, b = shape.offset, ab = 0.0;
  for (Index i = 0; i < run.count; ++i) {
    const bool outlier = outliers_[static_cast<std::size_t>(run.first + i)];
    const double innovation = a + b + 2.0 * ab + white + (outlier ? kOutlierInflation : 0.0);
    const double gain = (a + ab) / innovation;
    const double offset_gain = (b + ab) / innovation;
    a -= gain * gain * innovation;
    b -= offset_gain * offset_gain * innovation;
    ab -= gain * offset_gain * innovation;
    double decay = 0.0;
    if (i + 1 < run.count) {
      const double step = layout_.place[run.first + i + 1] - layout_.place[run.first + i];
      decay = std::exp(-std::max(step, 0.0) / shape.length);
      a = decay * decay * a + (1.0 - decay * decay) * stationary;
      ab *= decay;
    }
    f.decay[i] = decay;
    f.gain[i] = gain;
    f.offset_gain[i] = offset_gain;
    f.inverse_sigma[i] = 1.0 / std::sqrt(innovation);
    if (!outlier) f.log_determinant += std::log(innovation);
  }
  return f;
}

void NoiseModel::whitenRun(const NoiseRun& run, const Filter& filter, double level,
                           Eigen::Ref<RowMatrix> rows) const {
  const double scale = 1.0 / std::sqrt(level);
  Eigen::RowVectorXd state = Eigen::RowVectorXd::Zero(rows.cols());
  Eigen::RowVectorXd offset = Eigen::RowVectorXd::Zero(rows.cols());
  for (Index i = 0; i < run.count; ++i) {
    auto row = rows.row(i);
    row -= state + offset;
    offset += filter.offset_gain[i] * row;
    state = filter.decay[i] * (state + filter.gain[i] * row);
    row *= filter.inverse_sigma[i] * scale;
  }
}

double NoiseModel::sumOfSquares(const NoiseRun& run, const Filter& filter, const VectorXd& residual) const {
  double state = 0.0, offset = 0.0, sum = 0.0;
  for (Index i = 0; i < run.count; ++i) {
    const double innovation = residual[run.first + i] - state - offset;
    offset += filter.offset_gain[i] * innovation;
    state = filter.decay[i] * (state + filter.gain[i] * innovation);
    const double white = innovation * filter.inverse_sigma[i];
    sum += white * white;
  }
  return sum;
}

RowMatrix NoiseModel::whiten(const Noise& noise, RowMatrix columns) const {
  NL_EXPECTS(columns.rows() == sampleCount());
  for (std::size_t r = 0; r < layout_.runs.size(); ++r) {
    const NoiseRun& run = layout_.runs[r];
    const auto group = static_cast<std::size_t>(run.group);
    whitenRun(run, filter(r, noise.shape[group]), noise.level[group],
              columns.middleRows(run.first, run.count));
  }
  return columns;
}

void NoiseModel::whitenRunAlone(const NoiseRun& run, std::size_t shape, double level, RowMatrix& rows) const {
  const auto found = std::lower_bound(layout_.runs.begin(), layout_.runs.end(), run.first,
                                      [](const NoiseRun& one, Index first) { return one.first < first; });
  NL_EXPECTS(found != layout_.runs.end() && found->first == run.first && rows.rows() == run.count);
  whitenRun(*found, filter(static_cast<std::size_t>(found - layout_.runs.begin()), shape), level, rows);
}

VectorXd NoiseModel::whiten(const Noise& noise, const VectorXd& column) const {
  RowMatrix one = column;
  return whiten(noise, std::move(one)).col(0);
}

Noise NoiseModel::declared() const {
  const std::vector<NoiseShape>& shapes = noiseShapes();
  std::size_t start = 0;
  while (shapes[start].correlated != 0.0 || shapes[start].offset < 0.2) ++start;
  const auto groups = static_cast<std::size_t>(layout_.groups);
  return {std::vector<std::size_t>(groups, start), std::vector<double>(groups, 1.0)};
}

std::pair<double, double> NoiseModel::groupLikelihood(int group, std::size_t shape,
                                                      const VectorXd& residual) const {
  double sum = 0.0, log_determinant = 0.0;
  for (std::size_t r = 0; r < layout_.runs.size(); ++r) {
    if (layout_.runs[r].group != group) continue;
    sum += sumOfSquares(layout_.runs[r], filter(r, shape), residual);
    log_determinant += filter(r, shape).log_determinant;
  }
  return {sum, log_determinant};
}

NoiseModel::Estimate NoiseModel::estimate(const VectorXd& residual, bool optimistic) const {
  const std::vector<NoiseShape>& shapes = noiseShapes();
  Estimate result;
  for (int group = 0; group < layout_.groups; ++group) {
    const auto n = static_cast<double>(std::max<Index>(counts_[static_cast<std::size_t>(group)], 1));
    double best = -std::numeric_limits<double>::infinity();
    std::size_t best_shape = 0;
    double best_level = 1.0;
    for (std::size_t s = 0; s < shapes.size(); ++s) {
      if (optimistic && !isOptimistic(shapes[s])) continue;
      const auto [sum, log_determinant] = groupLikelihood(group, s, residual);
      const double level = std::max(sum / n, 1e-6);
      const double value =
          -0.5 * (log_determinant + n * std::log(level) + n) + shapes[s].log_prior + levelPrior(level);
      if (value > best) best = value, best_shape = s, best_level = level;
    }
    result.noise.shape.push_back(best_shape);
    result.noise.level.push_back(best_level);
    result.log_likelihood += best;
  }
  return result;
}

double NoiseModel::logLikelihood(const VectorXd& residual, const Noise& noise) const {
  double total = 0.0;
  for (int group = 0; group < layout_.groups; ++group) {
    const auto g = static_cast<std::size_t>(group);
    const auto n = static_cast<double>(std::max<Index>(counts_[g], 1));
    const auto [sum, log_determinant] = groupLikelihood(group, noise.shape[g], residual);
    total += -0.5 * (log_determinant + n * std::log(noise.level[g]) + sum / noise.level[g]) +
             noiseShapes()[noise.shape[g]].log_prior + levelPrior(noise.level[g]);
  }
  return total;
}

VectorXd NoiseModel::leaveOneOut(const Noise& noise, const VectorXd& residual) const {
  VectorXd z = VectorXd::Zero(sampleCount());
  for (std::size_t r = 0; r < layout_.runs.size(); ++r) {
    const NoiseRun& run = layout_.runs[r];
    const auto group = static_cast<std::size_t>(run.group);
    const Filter& steps = filter(r, noise.shape[group]);
    RowMatrix inverse = RowMatrix::Identity(run.count, run.count);
    whitenRun(run, steps, noise.level[group], inverse);
    const VectorXd pulled = inverse.transpose() * (inverse * residual.segment(run.first, run.count));
    for (Index i = 0; i < run.count; ++i) {
      const double precision = std::max(inverse.col(i).squaredNorm(), 1e-12);
      const double inflation =
          outliers_[static_cast<std::size_t>(run.first + i)] ? kOutlierInflation * noise.level[group] : 0.0;
      const double variance = std::max(1.0 / precision - inflation, 0.3 * noise.level[group]);
      z[run.first + i] = pulled[i] / precision / std::sqrt(variance);
    }
  }
  return z;
}

}  // namespace nineline::discovery
