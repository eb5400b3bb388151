#pragma once

#include "core/smoothing/axis_motion.h"
#include "core/smoothing/path_fit.h"
#include "core/smoothing/smoothing.h"
#include "core/smoothing/word_writer.h"

namespace nineline::smoothing {

/// What a curve is written from.
struct PieceContext {
  const PathSection& section;
  const PathPiece& piece;
  const AxisMotion& motion;
  const WordWriter& writer;
  double tolerance = 0.0;       ///< mm, of the whole
  double turn_tolerance = 0.0;  ///< rad
};

/// A curve as program text, and proven bounds of what the text adds to the errors of the curve.
struct PieceText {
  std::string text;         ///< lines with their ends
  std::size_t points = 0;   ///< blocks, control points or polynomials
  double bound = 0.0;       ///< mm
  double turn_bound = 0.0;  ///< rad
};

/// Each fails with NoAnswer where the text cannot hold the tolerance or leaves the travel.
/// Straight blocks: |tip − R| <= errors at the ends + (|p''| + h² |R''|)/8 in each.
[[nodiscard]] Result<PieceText> writeStraight(const PieceContext& context);
/// Fanuc G06.2 and Siemens BSPLINE: control points; rounding moves the curve by no more than the control
/// points.
[[nodiscard]] Result<PieceText> writeNurbs(const PieceContext& context);
[[nodiscard]] Result<PieceText> writeBspline(const PieceContext& context);
/// Siemens POLY: one block a span; the linear coefficient is implied by the end point.
[[nodiscard]] Result<PieceText> writePolynomials(const PieceContext& context);

}  // namespace nineline::smoothing
