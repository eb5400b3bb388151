#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>

#include "core/errors/error_table.h"
#include "core/errors/machine_state.h"

namespace nineline::estimation {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using errors::MachineState;

/// The functions of a basis that are not zero at one state.
struct BasisValues {
  static constexpr std::size_t kMost = 12;
  std::array<Index, kMost> index{};
  std::array<double, kMost> value{};
  std::size_t count = 0;

  void add(Index which, double what) {
    NL_EXPECTS(count < kMost, count);
    index[count] = which;
    value[count++] = what;
  }
};

/// Functions b_k of the machine's state whose weighted sum an unknown error is: Σ b_k(state) c_k.
class Basis {
 public:
  virtual ~Basis() = default;
  [[nodiscard]] virtual Index size() const = 0;
  [[nodiscard]] virtual BasisValues at(const MachineState& state) const = 0;
};

/// The constant 1.
class ConstantBasis final : public Basis {
 public:
  [[nodiscard]] Index size() const override { return 1; }
  [[nodiscard]] BasisValues at(const MachineState& state) const override;
};

/// −s/2, s the sense of a joint's last motion: its coefficient is the width of a backlash.
class ApproachBasis final : public Basis {
 public:
  explicit ApproachBasis(int joint) : joint_(static_cast<std::size_t>(joint)) {}
  [[nodiscard]] Index size() const override { return 1; }
  [[nodiscard]] BasisValues at(const MachineState& state) const override;

 private:
  std::size_t joint_;
};

/// Powers u^first … u^last of a joint's position, u = position / reach.
class PowerBasis final : public Basis {
 public:
  PowerBasis(int joint, double reach, int first, int last);
  [[nodiscard]] Index size() const override { return last_ - first_ + 1; }
  [[nodiscard]] BasisValues at(const MachineState& state) const override;

 private:
  std::size_t joint_;
  double reach_;
  int first_, last_;
};

/// The interpolation of an ErrorTable, as a function of its n values y and of the n second derivatives M at
/// the nodes: coefficients (y, M). So four functions are not zero at a position however many nodes there are;
/// `curvatures()` says how M follows from y.
class TableBasis final : public Basis {
 public:
  TableBasis(int joint, const errors::ErrorTable::Grid& grid, Index nodes);
  [[nodiscard]] Index size() const override { return 2 * nodes_; }
  [[nodiscard]] BasisValues at(const MachineState& state) const override {
    return atPosition(state.q[joint_]);
  }
  [[nodiscard]] BasisValues atPosition(double position) const;

  [[nodiscard]] int joint() const { return static_cast<int>(joint_); }
  [[nodiscard]] Index nodes() const { return nodes_; }
  [[nodiscard]] const errors::ErrorTable::Grid& grid() const { return table_.grid(); }
  [[nodiscard]] double position(Index node) const;
  [[nodiscard]] bool covers(double position) const { return table_.covers(position); }
  /// M = curvatures() · y, by the interpolation that the table itself uses.
  [[nodiscard]] const MatrixXd& curvatures() const { return curvatures_; }
  /// How the value at a position depends on the node values.
  [[nodiscard]] VectorXd cardinal(double position) const;

 private:
  std::size_t joint_;
  Index nodes_;
  errors::ErrorTable table_;
  MatrixXd curvatures_;
};

}  // namespace nineline::estimation
