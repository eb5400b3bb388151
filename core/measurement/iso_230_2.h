#pragma once

#include "core/measurement/evaluation_runs.h"

namespace nineline::measurement {

/// One target of ISO 230-2. Everything in the unit of the readings (mm or rad).
struct Iso2302Position {
  double target = 0.0;
  std::optional<ApproachStatistics> forward;
  std::optional<ApproachStatistics> backward;
  std::optional<double> mean;        ///< mean of both directions; absent in a unidirectional test
  std::optional<double> B;           ///< reversal value: forward mean − backward mean, signed
  std::optional<double> R_forward;   ///< 4 s
  std::optional<double> R_backward;  ///< 4 s
  std::optional<double> R;           ///< max(2 s↑ + 2 s↓ + |B|, R↑, R↓)
};

/// The letters of ISO 230-2 (and of GB/T 17421.2, which has the same). A value is absent where the test does
/// not give it: B, M and the bidirectional ones need both directions; A and R need two approaches to every
/// target.
struct Iso2302 {
  std::optional<double> A, A_forward, A_backward;  ///< accuracy: range of mean ± 2 s
  std::optional<double> E, E_forward, E_backward;  ///< systematic deviation: range of the means
  std::optional<double> R, R_forward, R_backward;  ///< repeatability: largest of the positions
  std::optional<double> M;                         ///< range of the means of both directions
  std::optional<double> B, mean_B;                 ///< largest |B_i|; mean of the signed B_i
  std::vector<Iso2302Position> positions;
  std::size_t fewest_approaches = 0;  ///< over targets and driven directions; the standard asks for 5
};

[[nodiscard]] Result<Iso2302> evaluateIso2302(const TargetRuns& runs);

/// What is known about a positioning test besides its readings; zero = does not contribute.
struct PositioningCircumstances {
  double length = 0.0;               ///< measured length, mm
  double device_expanded = 0.0;      ///< expanded uncertainty (k = 2) of the device over the length, mm
  double misalignment = 0.0;         ///< largest angle between beam and axis, rad
  double temperature_off_20 = 0.0;   ///< mean temperature of the machine − 20 °C
  double expansion = 11.7e-6;        ///< expansion coefficient used for the correction to 20 °C, 1/°C
  double expansion_range = 0.0;      ///< width of the interval that holds the true coefficient, 1/°C
  double temperature_range = 0.0;    ///< width of the interval that holds the machine's temperature, °C
  double environment_variation = 0;  ///< E_VE: range of the readings at rest for as long as the test took, mm
  std::size_t approaches = 5;        ///< to each target in each direction
};

/// Expanded uncertainties (k = 2) of the letters, mm. Derived in resources/docs/evaluation.md from the rules
/// of the GUM with the contributions that ISO/TR 230-9 names; rectangular distributions for intervals.
struct Iso2302Uncertainty {
  double A = 0.0, E = 0.0, M = 0.0;  ///< also for the one-way A and E
  double R = 0.0;                    ///< also for the one-way R
  double B = 0.0;
};

[[nodiscard]] Iso2302Uncertainty uncertaintyOf(const PositioningCircumstances& circumstances);

}  // namespace nineline::measurement
