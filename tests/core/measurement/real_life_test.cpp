// Fifty files with the faults of real life: each is read right, or refused with a message that names place
// and remedy. What the shop floor does to a file: half runs, decimal commas, GBK text, missing targets,
// swapped runs.

#include <gtest/gtest.h>

#include <cmath>

#include "core/kinematics/machine_file.h"
#include "core/measurement/measurement_file.h"
#include "core/measurement/run_checks.h"
#include "tests/core/measurement/real_life_files.h"
#include "tests/support/random_machines.h"

namespace nineline::measurement {
namespace {

/// All that is said about a file, by reader and run checks.
std::string saidOf(const MeasurementReading& reading) {
  std::string said;
  for (const Diagnostic& one : reading.diagnostics.all()) said += one.text + "\n";
  if (reading.diagnostics.hasErrors()) return said;
  for (const RunFault& fault : checkRuns(reading.measurement, *reading.machine)) {
    EXPECT_FALSE(fault.remedy.empty());
    said += fault.text + "\n";
  }
  return said;
}

void expectRead(const RealFile& file, const MeasurementReading& reading, const std::string& said) {
  EXPECT_FALSE(reading.diagnostics.hasErrors()) << said;
  ASSERT_EQ(reading.measurement.samples.size(), file.samples);
  if (!file.said.empty()) {
    EXPECT_NE(said.find(file.said), std::string::npos) << said;
    return;
  }
  EXPECT_EQ(said, "");
  const MeasurementReading wanted = readMeasurement(soundFile(), "wanted.csv");
  for (std::size_t i = 1; i < file.samples; ++i) {
    EXPECT_EQ(reading.measurement.readings[i], wanted.measurement.readings[i]) << "sample " << i;
    EXPECT_EQ(reading.measurement.samples[i].q, wanted.measurement.samples[i].q) << "sample " << i;
  }
}

void expectRefused(const RealFile& file, const MeasurementReading& reading, const std::string& said) {
  ASSERT_TRUE(reading.diagnostics.hasErrors());
  EXPECT_EQ(reading.diagnostics.firstError("a.csv").line, file.line) << said;
  EXPECT_NE(said.find(file.said), std::string::npos) << said;
}

TEST(RealLife, FiftyFilesAreReadRightOrRefusedWithARemedy) {
  const std::vector<RealFile> files = realFiles();
  EXPECT_GE(files.size(), 50u);
  for (const RealFile& file : files) {
    SCOPED_TRACE(file.name);
    const MeasurementReading reading = readMeasurement(file.text, "a.csv");
    const std::string said = saidOf(reading);
    if (file.is_read) {
      expectRead(file, reading, said);
    } else {
      expectRefused(file, reading, said);
    }
  }
}

TEST(RealLife, AnyByteMayBeSpoilt) {
  // No input may crash the reader or slip a number through that is not finite.
  test_support::Random random(351);
  const std::string good = soundFile();
  for (int k = 0; k < 3000; ++k) {
    std::string text = good;
    for (int n = random.whole(1, 6); n > 0 && !text.empty(); --n) {
      const auto at = static_cast<std::size_t>(random.whole(0, static_cast<int>(text.size()) - 1));
      if (random.whole(0, 2) == 0) {
        text.erase(at, static_cast<std::size_t>(random.whole(1, 40)));
      } else {
        text[at] = static_cast<char>(random.whole(0, 255));
      }
    }
    const MeasurementReading reading = readMeasurement(text, "a.csv");
    if (reading.diagnostics.hasErrors()) continue;
    for (const Sample& sample : reading.measurement.samples) {
      for (const double q : sample.q) ASSERT_TRUE(std::isfinite(q));
    }
    (void)checkRuns(reading.measurement, *reading.machine);
  }
}

}  // namespace
}  // namespace nineline::measurement
