#pragma once

#include "core/estimation/fit.h"
#include "tests/support/random_machines.h"

namespace nineline::estimation {

/// Readings of three instruments on a drawn machine of two linear joints and one rotary one, unknown tables
/// on one or two components of each joint and one location error, all told by the readings.
struct SampleProblem {
  explicit SampleProblem(unsigned seed, int runs = 2, int targets = 8);

  kinematics::Machine machine;
  std::vector<Measurement> files;
  Unknowns unknowns;
  Eigen::SparseMatrix<double> map;  ///< node values and the location error
  VectorXd truth;                   ///< parameters

  /// Sets the readings to what the instruments read at these parameters.
  void setReadings(const VectorXd& parameters);
};

}  // namespace nineline::estimation
