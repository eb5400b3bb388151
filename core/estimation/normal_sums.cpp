#include "core/estimation/normal_sums.h"

#include <algorithm>

namespace nineline::estimation {

namespace {

constexpr Index kChunk = 96;  // rows that are multiplied at once; they stay in the cache

NormalSums emptySums(const Linearisation& linearisation) {
  const ReadingSet& readings = linearisation.readings();
  const Index n = linearisation.unknowns().size();
  const auto groups = static_cast<Index>(readings.groups().size());
  NormalSums sums;
  sums.matrix.assign(readings.classes().size(), MatrixXd::Zero(n, n));
  sums.right.assign(readings.classes().size(), VectorXd::Zero(n));
  sums.square.assign(readings.classes().size(), 0.0);
  sums.count.assign(readings.classes().size(), 0.0);
  sums.group_columns = MatrixXd::Zero(n, groups);
  sums.group_right = VectorXd::Zero(groups);
  sums.group_weight = VectorXd::Zero(groups);
  sums.group_variance = VectorXd::Ones(groups);
  return sums;
}

void fillGroupVariance(const ReadingSet& readings, NormalSums& sums) {
  VectorXd sum = VectorXd::Zero(sums.group_weight.size());
  VectorXd count = VectorXd::Zero(sums.group_weight.size());
  for (const ReadingPlace& reading : readings.readings()) {
    sum[static_cast<Index>(reading.group)] += reading.sigma * reading.sigma;
    count[static_cast<Index>(reading.group)] += 1.0;
  }
  sums.group_variance = sum.cwiseQuotient(count.cwiseMax(1.0));
}

/// The rows of one batch and one noise class, gathered until a chunk is full.
class Gatherer {
 public:
  Gatherer(const Linearisation::Batch& batch, std::size_t noise, Index rows)
      : columns_(batch.columns),
        noise_(noise),
        rows_(static_cast<Index>(batch.columns.size()), std::min(rows, kChunk)),
        residuals_(rows_.cols()),
        local_(MatrixXd::Zero(rows_.rows(), rows_.rows())),
        right_(VectorXd::Zero(rows_.rows())) {}

  [[nodiscard]] double* next(double root_weight, double residual) {
    if (used_ == rows_.cols()) flush();
    residuals_[used_] = root_weight * residual;
    return rows_.col(used_++).data();
  }
  void scatter(NormalSums& sums) {
    flush();
    // An instrument sees some of the blocks only; the columns of the others are zero.
    std::vector<std::size_t> seen;
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      if (local_(static_cast<Index>(k), static_cast<Index>(k)) > 0.0) seen.push_back(k);
    }
    MatrixXd& matrix = sums.matrix[noise_];
    for (const std::size_t k : seen) {
      const auto column = static_cast<Index>(k);
      sums.right[noise_][columns_[k]] += right_[column];
      double* out = matrix.col(columns_[k]).data();
      for (const std::size_t i : seen) {
        out[columns_[i]] += local_(static_cast<Index>(std::max(i, k)), static_cast<Index>(std::min(i, k)));
      }
    }
  }

 private:
  void flush() {
    const auto rows = rows_.leftCols(used_);
    local_.selfadjointView<Eigen::Lower>().rankUpdate(rows);
    right_.noalias() += rows * residuals_.head(used_);
    used_ = 0;
  }
  const std::vector<Index>& columns_;
  std::size_t noise_;
  MatrixXd rows_;
  VectorXd residuals_;
  MatrixXd local_;
  VectorXd right_;
  Index used_ = 0;
};

/// One reading of a batch into the sums; `gather` takes its weighted row.
void addReading(const Linearisation& linearisation, std::size_t sample, std::size_t row, double weight,
                const std::vector<Index>& columns, Gatherer& gather, NormalSums& sums) {
  const ReadingSet& readings = linearisation.readings();
  const ReadingPlace& reading = readings.readings()[row];
  const double root = std::sqrt(weight) / reading.sigma;
  const double residual = linearisation.residual()[static_cast<Index>(row)];
  double* entries = gather.next(root, residual);
  linearisation.entries(sample, row, entries);
  const std::size_t noise = readings.groups()[reading.group].noise;
  const auto group = static_cast<Index>(reading.group);
  double* of_group = sums.group_columns.col(group).data();
  for (std::size_t k = 0; k < columns.size(); ++k) {
    entries[k] *= root;
    of_group[columns[k]] += root * entries[k];
  }
  sums.group_right[group] += root * root * residual;
  sums.group_weight[group] += root * root;
  sums.square[noise] += root * root * residual * residual;
  sums.count[noise] += 1.0;
}

}  // namespace

NormalSums normalSums(const Linearisation& linearisation, const VectorXd& weights) {
  const ReadingSet& readings = linearisation.readings();
  NormalSums sums = emptySums(linearisation);
  fillGroupVariance(readings, sums);
  for (const Linearisation::Batch& batch : linearisation.batches()) {
    std::vector<std::unique_ptr<Gatherer>> gatherers(readings.classes().size());
    std::size_t rows = 0;
    for (const std::size_t sample : batch.samples) {
      rows += readings.samples()[sample].last_row - readings.samples()[sample].first_row;
    }
    for (const std::size_t sample : batch.samples) {
      const SamplePlace& place = readings.samples()[sample];
      for (std::size_t row = place.first_row; row < place.last_row; ++row) {
        const double weight = weights[static_cast<Index>(row)];
        if (weight <= 0.0) continue;
        const std::size_t noise = readings.noiseOf(row);
        if (!gatherers[noise])
          gatherers[noise] = std::make_unique<Gatherer>(batch, noise, static_cast<Index>(rows));
        addReading(linearisation, sample, row, weight, batch.columns, *gatherers[noise], sums);
      }
    }
    for (const std::unique_ptr<Gatherer>& gather : gatherers) {
      if (gather) gather->scatter(sums);
    }
  }
  return sums;
}

void updateRight(const Linearisation& linearisation, const VectorXd& weights, NormalSums& sums) {
  const ReadingSet& readings = linearisation.readings();
  for (VectorXd& right : sums.right) right.setZero();
  std::fill(sums.square.begin(), sums.square.end(), 0.0);
  sums.group_right.setZero();
  std::vector<double> entries;
  for (const Linearisation::Batch& batch : linearisation.batches()) {
    entries.resize(batch.columns.size());
    for (const std::size_t sample : batch.samples) {
      const SamplePlace& place = readings.samples()[sample];
      for (std::size_t row = place.first_row; row < place.last_row; ++row) {
        const ReadingPlace& reading = readings.readings()[row];
        const double weight = weights[static_cast<Index>(row)] / (reading.sigma * reading.sigma);
        if (weight <= 0.0) continue;
        const double residual = linearisation.residual()[static_cast<Index>(row)];
        const std::size_t noise = readings.noiseOf(row);
        linearisation.entries(sample, row, entries.data());
        for (std::size_t k = 0; k < entries.size(); ++k) {
          sums.right[noise][batch.columns[k]] += weight * residual * entries[k];
        }
        sums.group_right[static_cast<Index>(reading.group)] += weight * residual;
        sums.square[noise] += weight * residual * residual;
      }
    }
  }
}

namespace {

/// mapᵀ · matrix · map. An instrument sees some of the unknowns; rows and columns of the others are left out.
MatrixXd congruence(const MatrixXd& matrix, const Eigen::SparseMatrix<double>& map) {
  std::vector<Index> seen;
  std::vector<Index> place(static_cast<std::size_t>(matrix.rows()), -1);
  for (Index i = 0; i < matrix.rows(); ++i) {
    if (matrix(i, i) <= 0.0) continue;
    place[static_cast<std::size_t>(i)] = static_cast<Index>(seen.size());
    seen.push_back(i);
  }
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<Index> parameters;
  for (Index k = 0; k < map.cols(); ++k) {
    const std::size_t before = entries.size();
    for (Eigen::SparseMatrix<double>::InnerIterator it(map, k); it; ++it) {
      const Index row = place[static_cast<std::size_t>(it.row())];
      if (row < 0) continue;
      entries.emplace_back(static_cast<int>(row), static_cast<int>(parameters.size()), it.value());
    }
    if (entries.size() > before) parameters.push_back(k);
  }
  Eigen::SparseMatrix<double> part(static_cast<Index>(seen.size()), static_cast<Index>(parameters.size()));
  part.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SparseMatrix<double> transposed = part.transpose();
  const MatrixXd small = matrix(seen, seen);
  const MatrixXd half = transposed * small;
  MatrixXd result = MatrixXd::Zero(map.cols(), map.cols());
  result(parameters, parameters) = half * part;
  return result;
}

}  // namespace

NormalSums NormalSums::reduced(const Eigen::SparseMatrix<double>& map) const {
  const Eigen::SparseMatrix<double> transposed = map.transpose();
  NormalSums out;
  for (std::size_t c = 0; c < matrix.size(); ++c) {
    out.matrix.push_back(congruence(matrix[c], map));
    out.right.emplace_back(transposed * right[c]);
  }
  out.square = square;
  out.count = count;
  out.group_columns = transposed * group_columns;
  out.group_right = group_right;
  out.group_weight = group_weight;
  out.group_variance = group_variance;
  return out;
}

NormalSums NormalSums::selected(const std::vector<Index>& which) const {
  NormalSums out = *this;
  for (std::size_t c = 0; c < matrix.size(); ++c) {
    out.matrix[c] = matrix[c](which, which);
    out.right[c] = right[c](which);
  }
  out.group_columns = group_columns(which, Eigen::all);
  return out;
}

}  // namespace nineline::estimation
