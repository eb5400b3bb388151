#include "core/discovery/dictionary.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace nineline::discovery {

namespace {

using Eigen::MatrixXd;

constexpr double kCollinear = 2e-3;  // share of a column that must be left for it to count
constexpr double kTestable = 9.0;    // non-centrality of half the largest amplitude
constexpr double kJitter = 1e-9;

}  // namespace

Dictionary::Dictionary(const NoiseModel& model, const Noise& noise, const FixedPart& fixed,
                       const VectorXd& residual, OptionBank& bank)
    : model_(&model), noise_(noise), bank_(&bank), precision_(fixed.precision) {
  fixed_ = model.whiten(noise, fixed.columns);
  target_ = model.whiten(noise, residual);
  MatrixXd normal = fixed_.transpose() * fixed_;
  normal.diagonal() += precision_;
  if (normal.rows() != 0) normal.diagonal().array() += 1e-10 * normal.diagonal().mean() + 1e-30;
  fixed_factor_ = Eigen::LLT<MatrixXd>(normal).matrixL();
  target_fixed_ = fixed_.transpose() * target_;
  fixed_factor_.triangularView<Eigen::Lower>().solveInPlace(target_fixed_);
  target_square_ = target_.squaredNorm() - target_fixed_.squaredNorm();
  VectorXd coefficients = target_fixed_;
  fixed_factor_.transpose().triangularView<Eigen::Upper>().solveInPlace(coefficients);
  projected_target_ = target_ - fixed_ * coefficients;
  appendAll();
}

void Dictionary::makeRoom(Index columns) {
  if (columns <= white_.cols()) return;
  const Index room = columns + columns / 4 + 64;
  white_.conservativeResize(model_->sampleCount(), room);
  cross_.conservativeResize(fixed_.cols(), room);
  diagonal_.conservativeResize(room);
  inner_.conservativeResize(room);
}

void Dictionary::appendAll() {
  Index columns = 0;
  for (const Option& option : bank_->options) columns += option.raw.cols();
  makeRoom(columns);
  for (const Option& option : bank_->options) {
    white_.middleCols(used_, option.raw.cols()) = model_->whiten(noise_, option.raw);
    used_ += option.raw.cols();
  }
  MatrixXd cross = fixed_.transpose() * white_.leftCols(used_);
  fixed_factor_.triangularView<Eigen::Lower>().solveInPlace(cross);
  cross_.leftCols(used_) = cross;
  Index at = 0;
  for (std::size_t o = 0; o < bank_->options.size(); ++o) {
    enter(o, {at, bank_->options[o].raw.cols()});
    at += bank_->options[o].raw.cols();
  }
}

void Dictionary::appendColumns(const RowMatrix& raw, std::size_t option) {
  const Index count = raw.cols();
  makeRoom(used_ + count);
  white_.middleCols(used_, count) = model_->whiten(noise_, raw);
  for (Index c = used_; c < used_ + count; ++c) {
    VectorXd cross = fixed_.transpose() * white_.col(c);
    fixed_factor_.triangularView<Eigen::Lower>().solveInPlace(cross);
    cross_.col(c) = cross;
  }
  used_ += count;
  enter(option, {used_ - count, count});
}

void Dictionary::enter(std::size_t option, Range range) {
  const auto added = white_.middleCols(range.first, range.count);
  const auto cross = cross_.middleCols(range.first, range.count);
  const double largest = bank_->candidateOf(option).largest;
  MatrixXd block = added.transpose() * added - cross.transpose() * cross;
  block.diagonal().array() += 1.0 / (largest * largest);
  diagonal_.segment(range.first, range.count) = block.diagonal();
  inner_.segment(range.first, range.count) = added.transpose() * target_ - cross.transpose() * target_fixed_;
  ranges_.push_back(range);
  blocks_.push_back(std::move(block));
  penalties_.push_back(penaltyOf(option));
  testable_.push_back(bank_->candidateOf(option).generic ||
                      strength(option) * largest * largest / 4.0 > kTestable);
}

double Dictionary::strength(std::size_t option) const {
  return diagonal_.segment(ranges_[option].first, ranges_[option].count).maxCoeff();
}

double Dictionary::betweenRunSamples(const RowMatrix& raw, double samples) const {
  const VectorXd a = raw.col(0);
  double weight = 0.0, mean = 0.0, within = 0.0, most = 0.0;
  const std::vector<NoiseRun>& runs = model_->layout().runs;
  for (const NoiseRun& run : runs) {
    most = std::max(most, a.segment(run.first, run.count).squaredNorm() / static_cast<double>(run.count));
  }
  std::vector<std::pair<double, double>> means;  // of active runs, with their sample counts
  for (const NoiseRun& run : runs) {
    const auto n = static_cast<double>(run.count);
    const double square = a.segment(run.first, run.count).squaredNorm() / n;
    if (square <= 0.02 * most) continue;
    const double average = a.segment(run.first, run.count).mean();
    means.emplace_back(average, n);
    weight += n;
    mean += n * average;
    within += n * (square - average * average);
  }
  mean /= std::max(weight, 1e-300);
  double between = 0.0;
  for (const auto& [average, n] : means) between += n * (average - mean) * (average - mean);
  const double share = between / (between + within + 1e-12);
  return 1.0 / (share / std::max(static_cast<double>(means.size()), 3.0) + (1.0 - share) / samples);
}

double Dictionary::effectiveSamples(std::size_t option) const {
  const Range range = ranges_[option];
  std::vector<double> ratios;
  for (Index c = 0; c < range.count; ++c) {
    const auto squares = white_.col(range.first + c).array().square();
    ratios.push_back(squares.sum() * squares.sum() / std::max(squares.square().sum(), 1e-30));
  }
  std::nth_element(ratios.begin(), ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2),
                   ratios.end());
  const double samples =
      std::clamp(ratios[ratios.size() / 2], 20.0, std::max(20.0, static_cast<double>(model_->sampleCount())));
  return range.count <= 2 ? betweenRunSamples(bank_->options[option].raw, samples) : samples;
}

double Dictionary::penaltyOf(std::size_t option) const {
  const Candidate& candidate = bank_->candidateOf(option);
  const auto k = static_cast<double>(ranges_[option].count);
  const double library = 2.0 * std::log(std::max<double>(2.0, static_cast<double>(bank_->candidates.size())));
  const double grid = bank_->options[option].prior_grid;
  const auto m = static_cast<double>(candidate.nonlinear.size());
  const double shape_cost = m == 0.0 ? 0.0 : 1.5 * std::log(grid + 1.0);
  return k * std::log(effectiveSamples(option)) + shape_cost + library - 2.0 * candidate.log_prior +
         candidate.extra_penalty;
}

double Dictionary::totalPenalty(const OptionSet& set) const {
  double sum = 0.0;
  for (const std::size_t option : set) sum += penalties_[option];
  return sum;
}

std::vector<Index> Dictionary::columnsOf(const OptionSet& set) const {
  std::vector<Index> columns;
  for (const std::size_t option : set) {
    for (Index c = 0; c < ranges_[option].count; ++c) columns.push_back(ranges_[option].first + c);
  }
  return columns;
}

const VectorXd& Dictionary::gramRow(Index column) const {
  VectorXd& row = rows_[column];
  const Index known = row.size();
  if (known < used_) {
    row.conservativeResize(used_);
    const Index more = used_ - known;
    row.tail(more) = white_.middleCols(known, more).transpose() * white_.col(column) -
                     cross_.middleCols(known, more).transpose() * cross_.col(column);
    if (column >= known) row[column] = diagonal_[column];
  }
  return row;
}

double Dictionary::gramEntry(Index a, Index b) const {
  if (a == b) return diagonal_[a];
  for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)}) {
    const auto row = rows_.find(one);
    if (row != rows_.end() && other < row->second.size()) return row->second[other];
  }
  const auto [entry, is_new] = entries_.try_emplace(std::minmax(a, b), 0.0);
  if (is_new) entry->second = white_.col(a).dot(white_.col(b)) - cross_.col(a).dot(cross_.col(b));
  return entry->second;
}

void Dictionary::gram(const OptionSet& set, MatrixXd& matrix, VectorXd& right) const {
  const std::vector<Index> columns = columnsOf(set);
  const auto k = static_cast<Index>(columns.size());
  matrix.resize(k, k);
  right.resize(k);
  for (Index i = 0; i < k; ++i) {
    const Index a = columns[static_cast<std::size_t>(i)];
    for (Index j = 0; j <= i; ++j) {
      matrix(i, j) = matrix(j, i) = gramEntry(a, columns[static_cast<std::size_t>(j)]);
    }
    right[i] = inner_[a];
  }
  for (Index i = 0; i < k; ++i) matrix(i, i) *= 1.0 + kJitter;
}

double Dictionary::sumOfSquares(const OptionSet& set) const {
  if (set.empty()) return target_square_;
  MatrixXd matrix;
  VectorXd right;
  gram(set, matrix, right);
  return target_square_ - right.dot(Eigen::LDLT<MatrixXd>(matrix).solve(right));
}

Dictionary::Fit Dictionary::fit(const OptionSet& set) const {
  if (set.empty()) return {};
  MatrixXd matrix;
  VectorXd right;
  gram(set, matrix, right);
  const Eigen::LDLT<MatrixXd> factor(matrix);
  return {factor.solve(right), factor.solve(MatrixXd::Identity(matrix.rows(), matrix.cols()))};
}

VectorXd Dictionary::fixedBeside(const OptionSet& set, const VectorXd& coefficients) const {
  VectorXd right = target_fixed_;
  const std::vector<Index> columns = columnsOf(set);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    right -= coefficients[static_cast<Index>(i)] * cross_.col(columns[i]);
  }
  fixed_factor_.transpose().triangularView<Eigen::Upper>().solveInPlace(right);
  return right;
}

bool Dictionary::isPlausible(const OptionSet& set) const {
  if (set.empty()) return true;
  const VectorXd b = fit(set).coefficients;
  Index at = 0;
  for (const std::size_t option : set) {
    const Index k = ranges_[option].count;
    const Candidate& candidate = bank_->candidateOf(option);
    if (!candidate.generic) {
      if (b.segment(at, k).cwiseAbs().maxCoeff() > candidate.largest) return false;
      if (candidate.sign != 0 && b[at] * candidate.sign < 0.0) return false;
    }
    at += k;
  }
  return true;
}

Dictionary::Sweep Dictionary::sweep(const OptionSet& set) const {
  Sweep result;
  const std::vector<Index> columns = columnsOf(set);
  const auto k = static_cast<Index>(columns.size());
  result.diagonal = diagonal_.head(used_);
  result.target = inner_.head(used_);
  if (k == 0) return result;
  MatrixXd matrix;
  VectorXd right;
  gram(set, matrix, right);
  const Eigen::LLT<MatrixXd> factor(matrix);
  result.projected.resize(k, used_);
  for (Index i = 0; i < k; ++i) {
    result.projected.row(i) = gramRow(columns[static_cast<std::size_t>(i)]).transpose();
  }
  factor.matrixL().solveInPlace(result.projected);
  factor.matrixL().solveInPlace(right);
  result.diagonal -= result.projected.colwise().squaredNorm().transpose();
  result.target -= result.projected.transpose() * right;
  return result;
}

double Dictionary::blockGain(MatrixXd block, const VectorXd& target, const VectorXd& own, int sign) const {
  if (block.rows() == 1) {
    if (block(0, 0) <= kCollinear * own[0]) return 0.0;
    if (sign != 0 && target[0] * sign < 0.0) return 0.0;
    return target[0] * target[0] / block(0, 0);
  }
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(block);
  const double least = (block.rows() == 2 ? kCollinear : 1e-4) * std::max(own.maxCoeff(), 1e-30);
  double gain = 0.0;
  for (Index i = 0; i < block.rows(); ++i) {
    if (solver.eigenvalues()[i] <= least) continue;
    const double part = solver.eigenvectors().col(i).dot(target);
    gain += part * part / solver.eigenvalues()[i];
  }
  return gain;
}

double Dictionary::optionGain(std::size_t option, const Sweep& sweep) const {
  const Range range = ranges_[option];
  MatrixXd block = blocks_[option];
  if (sweep.projected.rows() != 0) {
    const auto part = sweep.projected.middleCols(range.first, range.count);
    block -= part.transpose() * part;
  }
  return blockGain(std::move(block), sweep.target.segment(range.first, range.count),
                   diagonal_.segment(range.first, range.count), bank_->candidateOf(option).sign);
}

VectorXd Dictionary::gains(const OptionSet& set, Which which) const {
  const Sweep swept = sweep(set);
  VectorXd result(static_cast<Index>(size()));
  for (std::size_t option = 0; option < size(); ++option) {
    const bool generic = bank_->candidateOf(option).generic;
    const bool asked = which == Which::Both || generic == (which == Which::Generic);
    result[static_cast<Index>(option)] =
        asked && testable_[option] ? optionGain(option, swept) : -std::numeric_limits<double>::infinity();
  }
  return result;
}

VectorXd Dictionary::netGains(const OptionSet& set, Which which) const {
  VectorXd result = gains(set, which);
  for (std::size_t option = 0; option < size(); ++option) {
    result[static_cast<Index>(option)] -= penalties_[option];
  }
  for (const std::size_t option : set) {
    result[static_cast<Index>(option)] = -std::numeric_limits<double>::infinity();
  }
  return result;
}

Dictionary::Profile Dictionary::profile(const OptionSet& set, std::size_t like) const {
  Profile profile{like, whitenedResidual(set), projectedColumns(set), {}, 1.0};
  if (!set.empty()) {
    MatrixXd matrix;
    VectorXd right;
    gram(set, matrix, right);
    profile.set_inverse =
        Eigen::LDLT<MatrixXd>(matrix).solve(MatrixXd::Identity(matrix.rows(), matrix.cols()));
  }
  const Range range = ranges_[like];
  const double whole = white_.middleCols(range.first, range.count).squaredNorm();
  const double taken = cross_.middleCols(range.first, range.count).squaredNorm();
  if (whole > 0.0) profile.kept = std::clamp((whole - taken) / whole, kCollinear, 1.0);
  return profile;
}

double Dictionary::gainAt(const Profile& profile, std::span<const double> shape) const {
  const Candidate& cause = bank_->candidateOf(profile.like);
  RowMatrix raw = cause.columns(shape);
  if (!raw.allFinite()) return 0.0;
  const MatrixXd white = model_->whiten(noise_, std::move(raw));
  MatrixXd block = profile.kept * (white.transpose() * white);
  block.diagonal().array() += 1.0 / (cause.largest * cause.largest);
  const VectorXd own = block.diagonal();
  if (profile.set_columns.cols() != 0) {
    const MatrixXd between = profile.set_columns.transpose() * white;
    block -= between.transpose() * profile.set_inverse * between;
  }
  return blockGain(std::move(block), white.transpose() * profile.residual, own, cause.sign);
}

std::size_t Dictionary::append(std::size_t like, std::vector<double> shape, std::vector<double> step) {
  const std::size_t index = bank_->addOption(bank_->options[like].candidate, std::move(shape),
                                             std::move(step), bank_->options[like].prior_grid);
  update();
  return index;
}

void Dictionary::update() {
  while (size() < bank_->options.size()) appendColumns(bank_->options[size()].raw, size());
}

MatrixXd Dictionary::whitenedColumns(const OptionSet& set) const {
  const std::vector<Index> columns = columnsOf(set);
  MatrixXd result(white_.rows(), static_cast<Index>(columns.size()));
  for (Index i = 0; i < result.cols(); ++i) result.col(i) = white_.col(columns[static_cast<std::size_t>(i)]);
  return result;
}

const VectorXd& Dictionary::projectedColumn(Index column) const {
  VectorXd& projected = projected_[column];
  if (projected.size() != 0) return projected;
  VectorXd coefficients = cross_.col(column);
  fixed_factor_.transpose().triangularView<Eigen::Upper>().solveInPlace(coefficients);
  projected = white_.col(column) - fixed_ * coefficients;
  return projected;
}

MatrixXd Dictionary::projectedColumns(const OptionSet& set) const {
  const std::vector<Index> columns = columnsOf(set);
  MatrixXd result(white_.rows(), static_cast<Index>(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i) {
    result.col(static_cast<Index>(i)) = projectedColumn(columns[i]);
  }
  return result;
}

VectorXd Dictionary::whitenedResidual(const OptionSet& set) const {
  if (set.empty()) return projectedTarget();
  return projectedTarget() - projectedColumns(set) * fit(set).coefficients;
}

double Dictionary::likeness(std::size_t a, std::size_t b) const {
  const auto orthonormal = [&](std::size_t option) {
    const MatrixXd columns = projectedColumns({option});
    const Eigen::ColPivHouseholderQR<MatrixXd> qr(columns);
    return MatrixXd(qr.householderQ() * MatrixXd::Identity(columns.rows(), qr.rank()));
  };
  const MatrixXd product = orthonormal(a).transpose() * orthonormal(b);
  if (product.size() == 0) return 0.0;
  return std::min(1.0, Eigen::JacobiSVD<MatrixXd>(product).singularValues()[0]);
}

}  // namespace nineline::discovery
