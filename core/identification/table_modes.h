#pragma once

#include "core/estimation/basis.h"

namespace nineline::identification {

using estimation::Index;
using estimation::MatrixXd;
using estimation::VectorXd;

/// Node values of a table as sums of few meaningful vectors.
struct TableModes {
  VectorXd constant;      ///< 1 at every node
  VectorXd slope;         ///< linear joint: from the datum, ±1 over half the range; empty for one node
  VectorXd cosine, sine;  ///< rotary joint: cos q, sin q at the nodes; empty where there are too few nodes
  MatrixXd shape;         ///< orthonormal columns: everything that has neither
  MatrixXd precision;     ///< of the shape's weights: second differences about 0
  double datum = 0.0;     ///< position where shape and slope are 0 (linear joint)
};

/// Linear joint: shape and slope vanish at the datum (position 0, or the end nearest to it) and the shape has
/// mean slope 0. Rotary joint: the shape has mean 0 and no first harmonic. `smoothness`: standard deviation
/// of a second difference of neighbouring values that is taken for granted.
[[nodiscard]] TableModes tableModes(const estimation::TableBasis& basis, bool rotary, double smoothness);

}  // namespace nineline::identification
