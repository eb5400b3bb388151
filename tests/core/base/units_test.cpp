#include "core/base/units.h"

#include <gtest/gtest.h>

namespace nineline {
namespace {

TEST(Units, KnownValues) {
  EXPECT_DOUBLE_EQ(mmFromUm(1500.0), 1.5);
  EXPECT_DOUBLE_EQ(radFromDeg(180.0), kPi);
  EXPECT_DOUBLE_EQ(radFromArcsec(3600.0), radFromDeg(1.0));
  EXPECT_DOUBLE_EQ(mmFromInch(10.0), 254.0);
  EXPECT_DOUBLE_EQ(perSecondFromPerMinute(90.0), 1.5);
  EXPECT_DOUBLE_EQ(kTurn, radFromDeg(360.0));
  // One arc second over a metre is 4.848 µm: the machinist's rule.
  EXPECT_NEAR(umFromMm(1000.0 * radFromArcsec(1.0)), 4.848, 5e-4);
}

TEST(Units, EveryConversionHasItsInverse) {
  for (const double value : {-123.456, 0.0, 1e-9, 7.0}) {
    EXPECT_DOUBLE_EQ(umFromMm(mmFromUm(value)), value);
    EXPECT_DOUBLE_EQ(degFromRad(radFromDeg(value)), value);
    EXPECT_DOUBLE_EQ(arcsecFromRad(radFromArcsec(value)), value);
    EXPECT_DOUBLE_EQ(inchFromMm(mmFromInch(value)), value);
    EXPECT_DOUBLE_EQ(perMinuteFromPerSecond(perSecondFromPerMinute(value)), value);
  }
}

}  // namespace
}  // namespace nineline
