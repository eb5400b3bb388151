#pragma once

#include "core/errors/error_model.h"
#include "core/measurement/measurement.h"
#include "tests/support/random_machines.h"

namespace nineline::identification_campaign {

using measurement::Measurement;
using test_support::Random;

/// Noise of a campaign, in standard deviations of each instrument.
struct NoisePlan {
  double length = 5e-4;     ///< mm
  double angle = 2e-6;      ///< rad
  double run_offset = 0.5;  ///< of every run, by the noise
  double outliers = 0.005;  ///< share of the readings
  bool stated = true;       ///< the files say how well they repeat
};

/// A machine with planted errors and what instruments read on it.
struct PlantedCase {
  kinematics::Machine machine;
  errors::ErrorModel truth;
  std::vector<Measurement> files;
  std::size_t outliers = 0;
};

/// Machine `kind` 0 grinder, 1 three-axis, 2 trunnion, 3 rotary table, with offsets and tool drawn from the
/// seed. Errors: smooth tables on every component of every joint in the gauge of theory.md, 1.4, location
/// errors, backlash on linear joints. Measurements: three parallel lines with straightness and angular tests
/// of each linear axis, angular and dial tests of each rotary one, all bidirectional in `runs` runs, and
/// poses spread over the volume. With `noise` null the readings are exact.
[[nodiscard]] PlantedCase plantCase(unsigned seed, int kind, int runs, const NoisePlan* noise);

[[nodiscard]] const char* kindName(int kind);
/// Normally distributed with standard deviation 1.
[[nodiscard]] double normal(Random& random);

}  // namespace nineline::identification_campaign
