#include "core/estimation/unknowns.h"

namespace nineline::estimation {

namespace {

errors::SmallMotion& motionOf(kinematics::JointDisplacement& displacement, errors::Slot slot) {
  switch (slot) {
    case errors::Slot::Located:
      return displacement.located;
    case errors::Slot::Standing:
      return displacement.standing;
    case errors::Slot::Moved:
      break;
  }
  return displacement.moved;
}

}  // namespace

std::size_t Unknowns::addBasis(std::shared_ptr<const Basis> basis) {
  bases_.push_back(std::move(basis));
  return bases_.size() - 1;
}

std::size_t Unknowns::addBlock(int joint, errors::Slot slot, const errors::SmallMotion& unit,
                               std::size_t basis) {
  NL_EXPECTS(basis < bases_.size(), basis);
  blocks_.push_back({joint, slot, unit, basis, size_});
  size_ += bases_[basis]->size();
  return blocks_.size() - 1;
}

void Unknowns::evaluate(const MachineState& state, std::span<BasisValues> values) const {
  for (std::size_t b = 0; b < bases_.size(); ++b) values[b] = bases_[b]->at(state);
}

void Unknowns::displacements(std::span<const BasisValues> values, const VectorXd& coefficients,
                             kinematics::JointDisplacements& out) const {
  out.fill({});
  for (const Block& block : blocks_) {
    const BasisValues& basis = values[block.basis];
    double sum = 0.0;
    for (std::size_t n = 0; n < basis.count; ++n) {
      sum += basis.value[n] * coefficients[block.first + basis.index[n]];
    }
    errors::addScaled(sum, block.unit, motionOf(out[static_cast<std::size_t>(block.joint)], block.slot));
  }
}

}  // namespace nineline::estimation
