// A short cut of the campaign behind resources/docs/reports/identification-campaign.md.
#include "tests/identification_campaign/campaign.h"

#include <gtest/gtest.h>

namespace nineline::identification_campaign {
namespace {

TEST(IdentificationCampaign, StatedUncertaintiesCoverWhatWasPlanted) {
  Coverage all;
  std::size_t planted_outliers = 0;
  std::size_t found_outliers = 0;
  for (unsigned seed = 810001; seed < 810041; ++seed) {
    NoisePlan noise;
    noise.stated = seed % 2 == 0;
    noise.run_offset = 0.25 * (seed % 5);
    const PlantedCase planted =
        plantCase(seed, static_cast<int>(seed % 4), 2 + static_cast<int>(seed % 3), &noise);
    NoProgress progress;
    identification::IdentificationOptions options;
    options.propose = false;
    const auto report = identification::identify(planted.machine, planted.files, options, progress);
    ASSERT_TRUE(report) << seed << ": " << report.error().message();
    const Comparison comparison = compare(*report->model, planted.truth);
    EXPECT_TRUE(comparison.missing.empty()) << seed;
    all.add(comparison.all);
    planted_outliers += planted.outliers;
    found_outliers += report->outliers.size();
  }
  EXPECT_GT(all.percent(), 94.0) << all.values;
  EXPECT_LT(all.percent(), 97.0) << all.values;
  EXPECT_GT(found_outliers, planted_outliers * 95 / 100);
  EXPECT_LT(found_outliers, planted_outliers * 110 / 100);
}

}  // namespace
}  // namespace nineline::identification_campaign
