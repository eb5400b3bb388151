#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/json.h"
#include "core/base/progress.h"
#include "core/base/units.h"
#include "core/smoothing/path_fit.h"
#include "core/smoothing/tool_path.h"

namespace nineline::smoothing {

/// How the smooth path is written (theory.md, 5.7).
enum class Format {
  G01,             ///< straight blocks close together
  FanucNurbs,      ///< G06.2
  SiemensBspline,  ///< BSPLINE, control points
  SiemensPoly      ///< POLY, polynomials
};

struct SmoothingOptions {
  double tolerance = 0.005;  ///< mm: the whole of it, writing included
  double turn_tolerance = radFromDeg(0.05);
  Criterion criterion = Criterion::Points;
  Format format = Format::G01;
  std::optional<double> chord;  ///< mm: chord error of the CAM system, where known
  double corner = radFromDeg(20.0);
  std::optional<int> linear_decimals;  ///< absent: as in the program, at least 4 (inch 5)
  std::optional<int> rotary_decimals;  ///< absent: as in the program, at least 5
};

/// Jumps of the second difference of one axis along the path, at the programmed points: largest and rms, mm
/// or rad per mm².
struct AxisJumps {
  AxisId axis;
  bool rotary = false;
  double before_max = 0.0, before_rms = 0.0;
  double after_max = 0.0, after_rms = 0.0;
};

struct SmoothingReport {
  std::size_t points_in = 0;        ///< ends of the straight cutting motions of the program
  std::size_t points_out = 0;       ///< what stands for them: points, control points, or polynomials
  std::size_t segments = 0;         ///< curves written
  std::size_t control_points = 0;   ///< of all curves
  std::size_t points_smoothed = 0;  ///< programmed points that curves cover
  double max_position_error = 0.0;  ///< mm, of the curves, measured at the points
  double max_turn_error = 0.0;      ///< rad
  double bound = 0.0;               ///< mm, proven, of what was written, by the criterion
  double turn_bound = 0.0;          ///< rad
  std::vector<AxisJumps> jumps;
  Diagnostics diagnostics;
};

struct SmoothedText {
  std::string text;
  SmoothingReport report;
};

/// Sees the points of each curve in order: segment from 1, axis values, tip.
struct CurveSample {
  std::size_t segment = 0;
  bool smoothed = false;
  nc::AxisValues values{};
  Vector3d tip = Vector3d::Zero();
};
using CurveSink = std::function<void(const CurveSample&)>;

/// Replaces what can be smoothed of a program; every other line stays byte for byte, and so does every part
/// that no certified curve covers. Fails as the interpreter does, and with BadInput where the format cannot
/// carry a section.
[[nodiscard]] Result<SmoothedText> smoothText(const Machine& machine, const std::string& name,
                                              std::string text, const nc::InterpreterOptions& setup,
                                              const SmoothingOptions& options, Progress& progress,
                                              const CurveSink& sink = {});

/// The result record of contract.md.
[[nodiscard]] Json reportToJson(const SmoothingReport& report);

}  // namespace nineline::smoothing
