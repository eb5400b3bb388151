#pragma once

#include <vector>

#include "core/errors/effect.h"
#include "core/estimation/basis.h"
#include "core/kinematics/chain.h"

namespace nineline::estimation {

/// One unknown error: motion along `unit` at a joint and slot, as a weighted sum of a basis. Its coefficients
/// stand at `first` in the vector of all.
struct Block {
  int joint = 0;
  errors::Slot slot = errors::Slot::Moved;
  errors::SmallMotion unit;
  std::size_t basis = 0;
  Index first = 0;
};

/// Everything that is to be estimated about a machine, as coefficients of basis functions. Blocks that depend
/// on the state in the same way share a basis, which is evaluated once for all of them.
class Unknowns {
 public:
  /// Gives the number of the basis.
  std::size_t addBasis(std::shared_ptr<const Basis> basis);
  /// Gives the number of the block.
  std::size_t addBlock(int joint, errors::Slot slot, const errors::SmallMotion& unit, std::size_t basis);

  [[nodiscard]] Index size() const { return size_; }
  [[nodiscard]] const std::vector<Block>& blocks() const { return blocks_; }
  [[nodiscard]] const std::vector<std::shared_ptr<const Basis>>& bases() const { return bases_; }
  [[nodiscard]] Index sizeOf(const Block& block) const { return bases_[block.basis]->size(); }

  /// All bases at a state.
  void evaluate(const MachineState& state, std::span<BasisValues> values) const;
  /// Displacements of the joints at the state of `values`.
  void displacements(std::span<const BasisValues> values, const VectorXd& coefficients,
                     kinematics::JointDisplacements& out) const;

 private:
  std::vector<std::shared_ptr<const Basis>> bases_;
  std::vector<Block> blocks_;
  Index size_ = 0;
};

}  // namespace nineline::estimation
