#include "core/estimation/linearisation.h"

#include <algorithm>
#include <numeric>

namespace nineline::estimation {

using measurement::kGradientPerJoint;

Linearisation::Linearisation(const Unknowns& unknowns, const ReadingSet& readings)
    : unknowns_(&unknowns), readings_(&readings) {
  const std::size_t bases = unknowns.bases().size();
  basis_.resize(readings.samples().size() * bases);
  for (std::size_t i = 0; i < readings.samples().size(); ++i) {
    unknowns.evaluate(readings.state(readings.samples()[i]), std::span(basis_).subspan(i * bases, bases));
  }
  gradients_.resize(readings.rows() * unknowns.blocks().size());
  collectBatches();
}

void Linearisation::collectBatches() {
  const std::size_t bases = unknowns_->bases().size();
  std::vector<std::size_t> order(readings_->samples().size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  // Which functions are not zero follows from the first one of each basis.
  const auto compare = [this, bases](std::size_t a, std::size_t b) {
    for (std::size_t k = 0; k < bases; ++k) {
      const Index one = basis_[a * bases + k].index[0];
      const Index two = basis_[b * bases + k].index[0];
      if (one != two) return one < two ? -1 : 1;
    }
    return 0;
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return compare(a, b) < 0; });
  for (const std::size_t sample : order) {
    if (batches_.empty() || compare(batches_.back().samples.front(), sample) != 0) {
      Batch batch;
      for (const Block& block : unknowns_->blocks()) {
        const BasisValues& values = basis_[sample * bases + block.basis];
        for (std::size_t n = 0; n < values.count; ++n) batch.columns.push_back(block.first + values.index[n]);
      }
      batches_.push_back(std::move(batch));
    }
    batches_.back().samples.push_back(sample);
  }
}

Result<void> Linearisation::at(const VectorXd& coefficients, bool gradients, Progress& progress) {
  NL_EXPECTS(coefficients.size() == unknowns_->size(), coefficients.size(), unknowns_->size());
  point_ = coefficients;
  residual_.resize(static_cast<Index>(readings_->rows()));
  kinematics::JointDisplacements displacements;
  std::vector<double> predicted;
  std::vector<double> gradient;
  const std::vector<SamplePlace>& samples = readings_->samples();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (i % 4096 == 0 && progress.isCancelled()) return cancelled();
    const SamplePlace& place = samples[i];
    const measurement::ReadingFunction& function = readings_->function(place.file);
    unknowns_->displacements(basisAt(i), coefficients, displacements);
    predicted.resize(function.channelCount());
    const kinematics::JointPositions& q = readings_->state(place).q;
    if (gradients) {
      gradient.resize(function.channelCount() * function.gradientSize());
      function.readWithGradient(q, displacements, predicted, gradient);
      differentiate(i, gradient);
    } else {
      function.read(q, displacements, predicted);
    }
    for (std::size_t row = place.first_row; row < place.last_row; ++row) {
      const ReadingPlace& reading = readings_->readings()[row];
      residual_[static_cast<Index>(row)] = reading.value - predicted[reading.channel];
    }
  }
  return {};
}

void Linearisation::differentiate(std::size_t sample, std::span<const double> gradient) {
  const SamplePlace& place = readings_->samples()[sample];
  const std::size_t size = readings_->function(place.file).gradientSize();
  const std::vector<Block>& blocks = unknowns_->blocks();
  for (std::size_t row = place.first_row; row < place.last_row; ++row) {
    const double* of_row = gradient.data() + readings_->readings()[row].channel * size;
    double* out = gradients_.data() + row * blocks.size();
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      const Block& block = blocks[b];
      const double* six = of_row + static_cast<std::size_t>(block.joint) * kGradientPerJoint +
                          6 * static_cast<std::size_t>(block.slot);
      const Eigen::Vector3d& t = block.unit.translation;
      const Eigen::Vector3d& w = block.unit.rotation;
      out[b] = six[0] * t[0] + six[1] * t[1] + six[2] * t[2] + six[3] * w[0] + six[4] * w[1] + six[5] * w[2];
    }
  }
}

void Linearisation::entries(std::size_t sample, std::size_t row, double* out) const {
  const std::vector<Block>& blocks = unknowns_->blocks();
  const std::span<const BasisValues> values = basisAt(sample);
  const double* gradient = gradients_.data() + row * blocks.size();
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const BasisValues& basis = values[blocks[b].basis];
    for (std::size_t n = 0; n < basis.count; ++n) *out++ = gradient[b] * basis.value[n];
  }
}

VectorXd Linearisation::times(const VectorXd& step) const {
  const std::vector<Block>& blocks = unknowns_->blocks();
  VectorXd product(static_cast<Index>(readings_->rows()));
  std::vector<double> motion(blocks.size());
  for (std::size_t i = 0; i < readings_->samples().size(); ++i) {
    const std::span<const BasisValues> values = basisAt(i);
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      const BasisValues& basis = values[blocks[b].basis];
      motion[b] = 0.0;
      for (std::size_t n = 0; n < basis.count; ++n) {
        motion[b] += basis.value[n] * step[blocks[b].first + basis.index[n]];
      }
    }
    const SamplePlace& place = readings_->samples()[i];
    for (std::size_t row = place.first_row; row < place.last_row; ++row) {
      const double* gradient = gradients_.data() + row * blocks.size();
      double sum = 0.0;
      for (std::size_t b = 0; b < blocks.size(); ++b) sum += gradient[b] * motion[b];
      product[static_cast<Index>(row)] = sum;
    }
  }
  return product;
}

VectorXd Linearisation::row(std::size_t row) const {
  const std::size_t sample = readings_->readings()[row].sample;
  const std::vector<Block>& blocks = unknowns_->blocks();
  const std::span<const BasisValues> values = basisAt(sample);
  VectorXd dense = VectorXd::Zero(unknowns_->size());
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const BasisValues& basis = values[blocks[b].basis];
    for (std::size_t n = 0; n < basis.count; ++n) {
      dense[blocks[b].first + basis.index[n]] += gradients_[row * blocks.size() + b] * basis.value[n];
    }
  }
  return dense;
}

}  // namespace nineline::estimation
