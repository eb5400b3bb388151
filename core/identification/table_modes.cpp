#include "core/identification/table_modes.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace nineline::identification {

namespace {

/// Orthonormal basis of all vectors that are orthogonal to the columns.
MatrixXd complement(const MatrixXd& columns) {
  const Index n = columns.rows();
  Eigen::ColPivHouseholderQR<MatrixXd> qr(columns);
  qr.setThreshold(1e-9);
  const MatrixXd q = qr.householderQ() * MatrixXd::Identity(n, n);
  return q.rightCols(n - qr.rank());
}

MatrixXd secondDifferences(Index nodes, bool closed) {
  const Index rows = closed ? nodes : std::max<Index>(0, nodes - 2);
  MatrixXd differences = MatrixXd::Zero(nodes < 3 ? 0 : rows, nodes);
  for (Index i = 0; i < differences.rows(); ++i) {
    differences(i, i) += 1.0;
    differences(i, (i + 1) % nodes) -= 2.0;
    differences(i, (i + 2) % nodes) += 1.0;
  }
  return differences;
}

void fillRotary(const VectorXd& positions, TableModes& modes) {
  const Index n = positions.size();
  MatrixXd structured(n, 3);
  structured << modes.constant, positions.array().cos().matrix(), positions.array().sin().matrix();
  if (n < 4) structured = modes.constant;
  if (n >= 4) {
    modes.cosine = structured.col(1);
    modes.sine = structured.col(2);
  }
  modes.shape = complement(structured);
}

void fillLinear(const estimation::TableBasis& basis, const VectorXd& positions, TableModes& modes) {
  const Index n = positions.size();
  const double low = positions[0];
  const double high = positions[n - 1];
  modes.datum = std::clamp(0.0, low, high);
  if (n < 2) {
    modes.shape = MatrixXd(n, 0);
    return;
  }
  modes.slope = (positions.array() - modes.datum) / (0.5 * (high - low));
  MatrixXd structured(n, 2);
  structured << basis.cardinal(modes.datum), (positions.array() - positions.mean()).matrix();
  modes.shape = complement(structured);
}

}  // namespace

TableModes tableModes(const estimation::TableBasis& basis, bool rotary, double smoothness) {
  const Index n = basis.nodes();
  VectorXd positions(n);
  for (Index i = 0; i < n; ++i) positions[i] = basis.position(i);
  TableModes modes;
  modes.constant = VectorXd::Ones(n);
  if (rotary) {
    fillRotary(positions, modes);
  } else {
    fillLinear(basis, positions, modes);
  }
  const MatrixXd differences = secondDifferences(n, basis.grid().period.has_value()) * modes.shape;
  modes.precision = differences.transpose() * differences / (smoothness * smoothness);
  return modes;
}

}  // namespace nineline::identification
