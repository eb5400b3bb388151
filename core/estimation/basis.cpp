#include "core/estimation/basis.h"

#include <cmath>

namespace nineline::estimation {

using errors::ErrorTable;

BasisValues ConstantBasis::at(const MachineState&) const {
  BasisValues values;
  values.add(0, 1.0);
  return values;
}

BasisValues ApproachBasis::at(const MachineState& state) const {
  BasisValues values;
  values.add(0, -0.5 * state.approach[joint_]);
  return values;
}

PowerBasis::PowerBasis(int joint, double reach, int first, int last)
    : joint_(static_cast<std::size_t>(joint)), reach_(reach), first_(first), last_(last) {
  NL_EXPECTS(first >= 0 && last >= first && last - first < static_cast<int>(BasisValues::kMost), first, last);
}

BasisValues PowerBasis::at(const MachineState& state) const {
  const double u = state.q[joint_] / reach_;
  BasisValues values;
  double power = std::pow(u, first_);
  for (int k = first_; k <= last_; ++k, power *= u) values.add(k - first_, power);
  return values;
}

namespace {

ErrorTable unitTable(const ErrorTable::Grid& grid, Index nodes, Index which) {
  std::vector<double> values(static_cast<std::size_t>(nodes), 0.0);
  if (which >= 0) values[static_cast<std::size_t>(which)] = 1.0;
  return ErrorTable::make(grid, std::move(values)).value();
}

/// Second derivatives at the nodes of the table that is 1 at one node and 0 at the others.
VectorXd curvaturesOf(const ErrorTable& table, Index nodes) {
  VectorXd m = VectorXd::Zero(nodes);
  const auto segments = static_cast<Index>(table.segmentCount());
  for (Index i = 0; i < segments; ++i) {
    const ErrorTable::Cubic& c = table.coefficients(static_cast<std::size_t>(i));
    m[i] = 2.0 * c.c2;
    if (i + 1 == segments && segments < nodes) m[i + 1] = 2.0 * c.c2 + 6.0 * table.grid().spacing * c.c3;
  }
  return m;
}

}  // namespace

TableBasis::TableBasis(int joint, const ErrorTable::Grid& grid, Index nodes)
    : joint_(static_cast<std::size_t>(joint)), nodes_(nodes), table_(unitTable(grid, nodes, -1)) {
  curvatures_.resize(nodes, nodes);
  for (Index k = 0; k < nodes; ++k) curvatures_.col(k) = curvaturesOf(unitTable(grid, nodes, k), nodes);
}

double TableBasis::position(Index node) const {
  return table_.grid().start + table_.grid().spacing * static_cast<double>(node);
}

BasisValues TableBasis::atPosition(double position) const {
  const ErrorTable::Place place = table_.place(position);
  const auto i = static_cast<Index>(place.segment);
  const Index k = (i + 1) % nodes_;
  const double h = table_.grid().spacing;
  const double u = place.t / h;
  BasisValues values;
  values.add(i, 1.0 - u);
  values.add(k, u);
  values.add(nodes_ + i, h * h * u * (-1.0 / 3.0 + u * (0.5 - u / 6.0)));
  values.add(nodes_ + k, h * h * u * (u * u - 1.0) / 6.0);
  return values;
}

VectorXd TableBasis::cardinal(double position) const {
  const BasisValues values = atPosition(position);
  VectorXd weights = VectorXd::Zero(nodes_);
  for (std::size_t n = 0; n < values.count; ++n) {
    if (values.index[n] < nodes_) {
      weights[values.index[n]] += values.value[n];
    } else {
      weights += values.value[n] * curvatures_.row(values.index[n] - nodes_).transpose();
    }
  }
  return weights;
}

}  // namespace nineline::estimation
