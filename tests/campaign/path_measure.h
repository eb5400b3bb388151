#pragma once

#include "core/base/result.h"
#include "core/nc/interpreter.h"
#include "tests/campaign/plain_physics.h"

namespace nineline::campaign {

/// One motion of a program with the line whose tag stands over it.
struct PlainMotion {
  std::size_t line = 0;
  nc::Motion motion;
  [[nodiscard]] Positions at(double fraction, std::size_t joints) const;
};

/// A program as its reader understands it.
[[nodiscard]] Result<std::vector<PlainMotion>> motionsOf(const std::string& text,
                                                         const nc::InterpreterOptions& options);

/// Length-weighted mean squares of a deviation from the ideal path of the original.
struct PathFigures {
  double length = 0.0;
  double square = 0.0;       ///< of the tip, mm² mm
  double tilt_square = 0.0;  ///< of the tool axis, rad² mm
  double rest_square = 0.0;  ///< of the tip: what no correction could remove
  double rest_tilt_square = 0.0;
  double largest = 0.0;          ///< mm
  std::size_t largest_line = 0;  ///< of the original
  [[nodiscard]] double rms() const;
  [[nodiscard]] double tilt() const;
  void add(const PathFigures& other);
};

struct PathComparison {
  PathFigures before;
  PathFigures after;
  std::string fault;  ///< empty: every motion found its corrected counterpart
};

/// Deviation of the actual tool from the ideal path of `original`, along all cutting motions, when the
/// machine runs `original` and when it runs `corrected`. Block ends are compared with block ends; between
/// them the pieces of a divided block are laid along it by their ends.
[[nodiscard]] PathComparison comparePaths(const PlainPhysics& physics, const std::string& original_text,
                                          const std::vector<PlainMotion>& original,
                                          const std::string& corrected_text,
                                          const std::vector<PlainMotion>& corrected, const Positions& start);

}  // namespace nineline::campaign
