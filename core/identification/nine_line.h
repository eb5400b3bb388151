#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/axis_id.h"
#include "core/base/result.h"

namespace nineline::identification {

using Eigen::Vector3d;

/// One reading taken at every position of a linear axis: a target on the carriage, read along one direction.
struct LineReading {
  Vector3d target = Vector3d::Zero();      ///< r: from the reference point of the errors, carriage frame, mm
  Vector3d direction = Vector3d::UnitX();  ///< unit, bed axes; a displacement reads along the axis
  double sigma = 1e-3;                     ///< standard uncertainty of one reading, mm
  int line = 1;                            ///< number of the line, for messages
  /// Readings with the same number ≥ 0 share one straightness reference of unknown inclination; −1: none.
  int reference = -1;
};

/// Any set of lines along one axis. The model of a reading at position q is
///   direction · (δ(q) + (R(ε(q)) − 1) r) + inclination · (q − q_datum),
/// with R(ε) ≈ 1 + [ε]× in the first-order form, theory.md eq. (7).
struct LineSetup {
  AxisId axis;
  std::vector<LineReading> readings;
};

enum class LineSet {
  Minimal,  ///< six readings: displacement on all lines, straightness b and c on line 1, c on line 2
  Full      ///< nine readings: displacement and both straightnesses on every line
};
enum class StraightnessInclination { Known, EachLine, EachDirection };

/// The nine-line method's three lines for one axis a, with b and c the next two axes cyclically: r1 = first,
/// r2 = first + span_b e_b, r3 = first + span_c e_c.
struct NineLinePattern {
  int along = 0;  ///< a: 0 1 2 = X Y Z
  Vector3d first = Vector3d::Zero();
  double span_b = 300.0, span_c = 300.0;  ///< mm
  LineSet set = LineSet::Full;
  StraightnessInclination inclination = StraightnessInclination::Known;
  double sigma_displacement = 0.5e-3, sigma_straightness = 1e-3;  ///< mm
};

/// Readings in the order line 1 (a, b, c), line 2 (a, b, c), line 3 (a, b, c), those that the set has.
[[nodiscard]] LineSetup makeNineLineSetup(const AxisId& axis, const NineLinePattern& pattern);

/// Names of a motion error: ISO 230-1's "EYX" and the paper's "δy(x)".
struct ErrorName {
  std::string iso;
  std::string paper;
};
/// `row` 0 1 2: translations, 3 4 5: rotations.
[[nodiscard]] ErrorName motionErrorName(const AxisId& axis, int row);

enum class LineMethod { Exact, FirstOrder };

/// What the readings of a set-up say at each position.
struct LineData {
  std::vector<double> positions;  ///< mm
  /// The position where every reading was zeroed and all errors count as zero; its readings are subtracted.
  /// Absent: the readings are taken as they are.
  std::optional<std::size_t> datum;
  std::vector<std::vector<double>> readings;  ///< [reading][position], mm
  /// [reading][position], mm; empty: the sigma of the set-up.
  std::vector<std::vector<double>> sigma;
};

/// EX EY EZ (mm) EA EB EC (rad) at one position. A value that the readings cannot tell is absent.
struct LineErrors {
  double position = 0.0;
  std::array<std::optional<double>, 6> value;
  std::array<std::optional<double>, 6> sigma;  ///< standard uncertainty
  double chi_square = 0.0;                     ///< weighted sum of squared residuals
  int freedom = 0;
  bool is_blunder = false;  ///< chi_square has a probability below 0.001 (above 16.3 for three degrees)
};

struct LineReport {
  std::vector<LineErrors> positions;
  std::vector<double> inclinations;       ///< of the straightness references, rad; empty when none is unknown
  std::vector<std::string> unobservable;  ///< ISO names of errors that the readings cannot tell
  /// ISO names of errors whose mean slope the readings cannot tell from a straightness reference's
  /// inclination (or that mix into it); their values are given with slope zero.
  std::vector<std::string> slope_unobservable;
  int unknowns = 0;
  int rank = 0;
  double condition_number = 0.0;  ///< rotations times the largest distance of targets; of the observable part
};

/// Weighted least squares at each position, or over all positions together where a straightness reference has
/// an unknown inclination. The exact method iterates on the rigid-body kinematics. Fails on lists of wrong
/// lengths, numbers that are not finite, and where the readings leave more open than slopes.
[[nodiscard]] Result<LineReport> identifyLines(const LineSetup& setup, const LineData& data,
                                               LineMethod method = LineMethod::Exact);

/// The readings that errors would give, [reading], mm; without inclinations.
[[nodiscard]] std::vector<double> predictLines(const LineSetup& setup, const Vector3d& delta,
                                               const Vector3d& epsilon,
                                               LineMethod method = LineMethod::Exact);

/// Probability that a chi-square of `freedom` ≥ 1 degrees is above `value`.
[[nodiscard]] double chiSquareTail(double value, int freedom);

}  // namespace nineline::identification
