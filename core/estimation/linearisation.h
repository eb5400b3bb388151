#pragma once

#include <vector>

#include "core/estimation/reading_set.h"

namespace nineline::estimation {

/// All readings about one point of the unknowns:
///     reading = prediction(point) + J (c − point) + zero + noise.
/// J is kept in the form in which it arises, the gradient of each reading along each block times the few
/// basis functions that are not zero there; products run over blocks of samples that share those functions.
class Linearisation {
 public:
  /// The unknowns and the readings must outlive it. Evaluates the bases; `at` must follow.
  Linearisation(const Unknowns& unknowns, const ReadingSet& readings);

  /// Predicts and differentiates all readings at these coefficients, through the exact kinematics. With
  /// `gradients` false J stays that of the last call: it changes by some 1e-4 of itself only.
  [[nodiscard]] Result<void> at(const VectorXd& coefficients, bool gradients, Progress& progress);

  [[nodiscard]] const VectorXd& point() const { return point_; }
  /// reading − prediction, by row; mm, rad; the zero not subtracted.
  [[nodiscard]] const VectorXd& residual() const { return residual_; }
  /// J · step, by row.
  [[nodiscard]] VectorXd times(const VectorXd& step) const;
  [[nodiscard]] const Unknowns& unknowns() const { return *unknowns_; }
  [[nodiscard]] const ReadingSet& readings() const { return *readings_; }

  /// Row of J, dense.
  [[nodiscard]] VectorXd row(std::size_t row) const;

  /// Samples whose non-zero functions are the same, and where their coefficients stand.
  struct Batch {
    std::vector<std::size_t> samples;
    std::vector<Index> columns;  ///< a column may occur twice
  };
  [[nodiscard]] const std::vector<Batch>& batches() const { return batches_; }
  /// The entries of one row of J in the columns of its batch.
  void entries(std::size_t sample, std::size_t row, double* out) const;

 private:
  void collectBatches();
  [[nodiscard]] std::span<const BasisValues> basisAt(std::size_t sample) const {
    return std::span(basis_).subspan(sample * unknowns_->bases().size(), unknowns_->bases().size());
  }
  void differentiate(std::size_t sample, std::span<const double> gradient);
  const Unknowns* unknowns_;
  const ReadingSet* readings_;
  std::vector<BasisValues> basis_;  // by sample and basis
  std::vector<Batch> batches_;
  std::vector<double> gradients_;  // by row and block
  VectorXd point_;
  VectorXd residual_;
};

}  // namespace nineline::estimation
