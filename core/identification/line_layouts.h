#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace nineline::identification {

using Eigen::Vector3d;

/// A straight line in the working volume of a three-axis machine (X carries Y carries Z carries the target),
/// measured with a length or straightness instrument and zeroed at its start.
struct VolumeLine {
  Vector3d from = Vector3d::Zero();        ///< commanded X Y Z at the start, mm
  Vector3d to = Vector3d::Zero();          ///< commanded X Y Z at the end, mm
  Vector3d target = Vector3d::Zero();      ///< from the reference point of the Z carriage, mm
  Vector3d direction = Vector3d::UnitX();  ///< unit; along the line for a length instrument
  bool is_inclined = false;                ///< its reference has an unknown inclination
};

/// What a set of lines can tell about the 51 coefficients of a three-axis machine with cubic error functions:
/// three of each of the 18 motion errors, less the linear ones of the six straightnesses, plus three
/// squarenesses.
struct LayoutReport {
  int unknowns = 0;                       ///< 51, inclinations not counted
  int rank = 0;                           ///< how many independent combinations of them the lines show
  std::vector<std::string> unobservable;  ///< "EYX q^2", "C0Y": coefficients that the lines do not tell alone
};

[[nodiscard]] LayoutReport layoutReport(const std::vector<VolumeLine>& lines);

/// Edge lengths of the working volume and offsets of the second and third line of each axis, mm.
struct LayoutSize {
  Vector3d volume{300.0, 250.0, 200.0};
  Vector3d offset{180.0, 150.0, 120.0};
};

/// Length readings along nine axis-parallel lines; `offset` moves the target on its carriage.
[[nodiscard]] std::vector<VolumeLine> nineLengthLines(const LayoutSize& size);
/// The nine lines with length and both straightness readings.
[[nodiscard]] std::vector<VolumeLine> nineFullLines(const LayoutSize& size, bool is_inclined);
/// Nine lengths and one diagonal of each face (12-line method).
[[nodiscard]] std::vector<VolumeLine> twelveLines(const LayoutSize& size);
/// And two diagonals with another offset of the target (14-line method).
[[nodiscard]] std::vector<VolumeLine> fourteenLines(const LayoutSize& size);
/// Nine lengths, six face diagonals, four body diagonals, three offset diagonals (22-line method).
[[nodiscard]] std::vector<VolumeLine> twentyTwoLines(const LayoutSize& size);
/// One diagonal of each face.
[[nodiscard]] std::vector<VolumeLine> faceDiagonals(const LayoutSize& size);

}  // namespace nineline::identification
