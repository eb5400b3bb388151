#pragma once

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "core/discovery/noise_model.h"

namespace nineline::discovery {

/// A parameter that does not enter linearly (a period, a time constant), its range and where to start.
struct Nonlinear {
  std::string name;
  double low = 0.0;
  double high = 0.0;
  std::vector<double> grid;  ///< values tried first, ascending
  bool choice = false;       ///< only the grid values count
};

/// One cause at one place, as columns: what the readings do per unit of its linear coefficients, in units of
/// the declared repeatability.
struct Candidate {
  std::string name;          ///< unique in a search
  std::string group;         ///< axis or rotary group: shape details of one cause share it
  double log_prior = 0.0;    ///< nats; 0 for the ordinary one
  double largest = 1e6;      ///< plausible size of a coefficient
  int sign = 0;              ///< of the first coefficient, 0: either
  bool generic = false;      ///< unnamed structure
  bool measurement = false;  ///< an artefact of one instrument
  double extra_penalty = 0.0;
  std::vector<Nonlinear> nonlinear;
  std::function<RowMatrix(std::span<const double>)> columns;
};

/// A candidate at one value of its non-linear parameters.
struct Option {
  std::size_t candidate = 0;
  std::vector<double> shape;
  std::vector<double> step;  ///< how far each non-linear parameter may lie from the best value
  RowMatrix raw;             ///< columns, in units of the declared repeatability
  double prior_grid = 1;     ///< number of shapes that its candidate started with
};

}  // namespace nineline::discovery
