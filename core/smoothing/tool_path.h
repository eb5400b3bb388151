#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/kinematics/machine.h"
#include "core/nc/interpreter.h"
#include "core/smoothing/bspline.h"

namespace nineline::smoothing {

using Eigen::Vector3d;
using kinematics::JointPositions;
using kinematics::Machine;

/// A programmed point of the cut path.
struct PathPoint {
  nc::AxisValues values{};  ///< in machine coordinates; with tool-centre-point control X Y Z are the tip
  Vector3d tip = Vector3d::Zero();  ///< in W, mm
  std::size_t line = 0;             ///< whose block leads here; of the first point: 0
  std::optional<double> feed;       ///< F word in force on the way here; absent where it was stated before
};

/// A run of lines that say nothing but straight cutting motions, one after the other. The lines follow each
/// other in the file and are executed once.
struct PathSection {
  std::vector<PathPoint> points;  ///< the start, and the end of each line that moves
  std::size_t first_line = 0;
  std::size_t last_line = 0;
  std::string label;  ///< N word of the first line, empty where there is none
  std::string line_end;
  bool tool_centre_point = false;
  nc::WordFrame frame;
  nc::AxisMask moving = 0;  ///< axes that move
};

/// The smoothable sections of a program, and what the interpreter found.
struct ToolPath {
  std::vector<PathSection> sections;
  std::size_t motions = 0;  ///< straight cutting motions in all, smoothable or not
  nc::Dialect dialect = nc::Dialect::Fanuc;
  Diagnostics diagnostics;
};

/// Reads a program. A section ends at any block that says more than N, G1 (G01), F and plain absolute axis
/// words: rapids, arcs, cycles, M, S and T words, comments, other G codes, increments (G91), inverse time and
/// feed per revolution, cutter compensation, a gap in the lines; where the tool turns in place; and where an
/// axis moves that the program has not stated yet. Fails as the interpreter does.
[[nodiscard]] Result<ToolPath> readToolPath(const Machine& machine, nc::TextSource& program,
                                            const nc::InterpreterOptions& options);

/// Tip in W of axis values.
[[nodiscard]] Vector3d tipOf(const Machine& machine, const nc::AxisValues& values, bool tool_centre_point);

}  // namespace nineline::smoothing
