#pragma once

#include <Eigen/SparseCore>
#include <string>
#include <vector>

#include "core/errors/component.h"
#include "core/estimation/observability.h"
#include "core/estimation/unknowns.h"
#include "core/identification/knots.h"

namespace nineline::identification {

/// What a parameter is of its error.
enum class Part {
  Location,  ///< squareness, parallelism, place of an axis
  Slope,     ///< mean slope of a table
  Shape,     ///< a table without its constant and slope (rotary: without its first harmonic)
  PerTurn,   ///< first harmonic of a rotary table
  Constant,  ///< value of a table at the datum (rotary: its mean)
  Play       ///< lost travel at a reversal
};
/// "shape", "mean slope", for messages.
[[nodiscard]] std::string_view nameOf(Part part);

/// One error table whose values are sought.
struct TableUnknown {
  int joint = 0;
  errors::Component component;
  bool fixed_frame = false;
  std::shared_ptr<const estimation::TableBasis> basis;
  Index first = 0;  ///< of its coefficients: node values, then second derivatives
};

/// One number that is sought: a location error or a play.
struct ScalarUnknown {
  int joint = 0;
  errors::Component component;
  Part part = Part::Location;
  Index coefficient = 0;
  Index parameter = 0;
};

/// Parameters that are told or not told together, and what they are called.
struct NamedChunk {
  errors::Component component;
  std::string name;  ///< "EXX", "EXC and EYC"
  Part part = Part::Shape;
  /// Convention decides where it goes when nothing tells it (a table's constant belongs to the setting): then
  /// it is no lack of the data.
  bool conventional = false;
};

/// Everything that readings may tell about a machine, with the gauge of theory.md, 1.4: location errors come
/// first and take the mean slopes of straightness and, of a rotary joint, what is constant in the standing
/// frame; tables are what remains. coefficients = map · parameters.
struct ParameterSet {
  estimation::Unknowns unknowns;
  std::vector<TableUnknown> tables;
  std::vector<ScalarUnknown> scalars;
  Eigen::SparseMatrix<double> map;
  VectorXd plausible;                              ///< by parameter: mm, rad
  std::vector<estimation::ParameterChunk> chunks;  ///< in the order in which they are told apart
  std::vector<NamedChunk> names;                   ///< by chunk
};

struct ParameterOptions {
  std::vector<int> knot_levels;                 ///< by joint; see chooseKnots
  std::vector<std::optional<double>> spacings;  ///< by joint, mm or rad; absent: chosen
  bool play = true;                             ///< backlash where both directions were driven
  bool lateral_play = false;                    ///< also across and about the axis
};

/// Sizes that errors of a machine tool plausibly have; what is told worse is not told.
inline constexpr double kPlausibleLength = 0.1;  ///< mm
inline constexpr double kPlausibleAngle = 5e-4;  ///< rad, 100 arcsec

[[nodiscard]] ParameterSet makeParameters(const estimation::ReadingSet& readings,
                                          const ParameterOptions& options);

}  // namespace nineline::identification
