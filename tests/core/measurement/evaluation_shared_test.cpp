// ISO 230-2 figures of public raw data in ../shared/data (psi-lab) against the report that was published with
// them.
#include <gtest/gtest.h>

#include <filesystem>

#include "core/measurement/evaluation_record.h"
#include "core/measurement/measurement_file.h"

namespace nineline::measurement {
namespace {

constexpr double kPrinted_um = 6e-6;  // the report's last digit is 1e-5 um

TEST(SharedEvaluation, ReproducesAPublishedReport) {
  const std::string path = std::string(NINELINE_SOURCE_DIR) + "/../shared/data/psi-lab/positioning.csv";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there: published figures not compared";
  const MeasurementReading reading = loadMeasurement(path);
  ASSERT_FALSE(reading.diagnostics.hasErrors());
  const std::vector<EvaluationInput> inputs{{&reading.measurement, &*reading.machine}};
  const Result<std::vector<Evaluation>> found = evaluateMeasurements(inputs);
  ASSERT_TRUE(found) << found.error().text;
  const Iso2302& letters = *found->front().iso_230_2;
  const auto um = [](const std::optional<double>& value) { return 1e3 * value.value(); };
  EXPECT_NEAR(um(letters.mean_B), 0.0054, kPrinted_um);
  EXPECT_NEAR(um(letters.B), 0.0122, kPrinted_um);
  EXPECT_NEAR(um(letters.R_forward), 0.05033, kPrinted_um);
  EXPECT_NEAR(um(letters.R_backward), 0.0629, kPrinted_um);
  EXPECT_NEAR(um(letters.E_forward), 0.0246, kPrinted_um);
  EXPECT_NEAR(um(letters.E_backward), 0.0330, kPrinted_um);
  EXPECT_NEAR(um(letters.M), 0.0277, kPrinted_um);
  EXPECT_NEAR(um(letters.A_forward), 0.06428, kPrinted_um);
  EXPECT_NEAR(um(letters.A_backward), 0.08881, kPrinted_um);
  EXPECT_NEAR(um(letters.A), 0.08881, kPrinted_um);
  // Printed at the positions; the report's R and E are one-way values by mistake (formats.md), these are not.
  const double printed_R_um[] = {0.03517, 0.03772, 0.0417, 0.04871, 0.06882};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(um(letters.positions[i].R), printed_R_um[i], kPrinted_um);
  EXPECT_NEAR(um(letters.R), 0.06882, kPrinted_um);
  EXPECT_NEAR(um(letters.E), 0.0368, kPrinted_um);  // −0.08482 … −0.12162 of the printed means
}

}  // namespace
}  // namespace nineline::measurement
