#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"

namespace nineline::identification {

/// A line through readings, by least squares.
struct SlopeFit {
  double slope = 0.0;         ///< reading per position: mm/mm = rad
  double intercept = 0.0;     ///< at position 0, mm
  double sigma_slope = 0.0;   ///< standard uncertainty from the residuals; 0 for two points
  double straightness = 0.0;  ///< range of the residuals, mm
};

/// Fails on fewer than two different positions or numbers that are not finite.
[[nodiscard]] Result<SlopeFit> fitSlope(const std::vector<double>& positions,
                                        const std::vector<double>& readings);

/// Squareness of one linear axis to another.
struct Squareness {
  std::string component;     ///< location error of the second axis, "C0Y"; ISO 230-1 writes E_C(0X)Y
  std::string reference;     ///< letter of the axis that defines the direction 0: the reference line
  double value = 0.0;        ///< rad; turns the second axis about the third bed axis by this
  double first_order = 0.0;  ///< the same with slopes in place of angles (theory.md, 2.2)
  double sigma = 0.0;        ///< standard uncertainty from both fits
  double between = 0.0;      ///< angle between the two positive directions, rad
};

/// Squareness from the fitted slopes of two straightness runs against one straightness reference and an
/// optical square (whose error enters one to one). `reference_axis` and `second_axis` are 'X', 'Y' or 'Z'.
/// `of_reference`: how the reference axis deviates along the second one, per mm of its motion along its bed
/// axis; `of_second`: how the second deviates along the reference axis. Signed, both in one frame. For a
/// joint whose positive sense runs against its bed axis, change the slope's sign first.
///
/// The reference X turns by +b1 about Z, the second axis Y by −b2: C0Y = −(atan b1 + atan b2); cyclic for
/// (Y, Z) → A0Z and (Z, X) → B0X; the opposite sign for the pairs in the other order.
[[nodiscard]] Result<Squareness> squarenessOf(char reference_axis, char second_axis,
                                              const SlopeFit& of_reference, const SlopeFit& of_second);

/// Tilt of a work spindle C to the motion of Z, from an indicator on a mandrel.
struct SpindleParallelism {
  double A0C = 0.0, B0C = 0.0;                          ///< rad: the spindle's direction turned about X and Y
  double mandrel_about_x = 0.0, mandrel_about_y = 0.0;  ///< tilt of the mandrel in the spindle at 0°, rad
  double sigma = 0.0;                                   ///< standard uncertainty of each, from the fits
};

enum class MovingPart {
  Mandrel,   ///< the table with spindle and mandrel moves along Z, the indicator stands
  Indicator  ///< the indicator moves along Z, the mandrel stands
};

/// Slopes of the x and y readings over Z, with the spindle at 0° and at 180° (reversal takes the mandrel's
/// own tilt out). For a moving mandrel B0C = −d(x)/dz and A0C = +d(y)/dz, opposite for a moving indicator;
/// readings positive when the mandrel's surface lies further along the axis.
struct MandrelSlopes {
  SlopeFit x_at_0, y_at_0;
  SlopeFit x_at_180, y_at_180;
};
[[nodiscard]] SpindleParallelism parallelismOf(const MandrelSlopes& slopes, MovingPart moving);

}  // namespace nineline::identification
