#include "core/thread_grinding/functional_error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nineline::thread_grinding {
namespace {

TEST(FunctionalError, TenMicrometresAlongTheTangentAreAHundredNanometresOfLead) {
  const FunctionalError error = functionalError({0.0, 0.010, 0.0}, Hand::Left, 1.5, 24.0);
  EXPECT_NEAR(error.axial_lead, +0.010 * 1.5 / (kTurn * 24.0), 1e-10);
  EXPECT_NEAR(umFromMm(error.axial_lead), 0.0995, 5e-5);
  EXPECT_NEAR(error.radial, 2.08e-6, 1e-8);
}

TEST(FunctionalError, ADisplacementAlongTheScrewLineChangesNothing) {
  for (const Hand hand : {Hand::Right, Hand::Left}) {
    const double r = 20.0;
    const double angle = 0.02;
    const ContactDisplacement along{r * std::cos(angle) - r, r * std::sin(angle),
                                    signOf(hand) * 10.0 * angle / kTurn};
    const FunctionalError error = functionalError(along, hand, 10.0, r);
    EXPECT_NEAR(error.axial_lead, 0.0, 1e-15);
    EXPECT_NEAR(error.radial, 0.0, 1e-14);
  }
}

TEST(FunctionalError, AxialShiftMovesTheFlanksOppositely) {
  const FunctionalError error = functionalError({0.0, 0.0, 0.004}, Hand::Right, 3.0, 24.0);
  EXPECT_DOUBLE_EQ(error.axial_lead, 0.004);
  EXPECT_DOUBLE_EQ(error.flank_plus, -error.flank_minus);
  EXPECT_NEAR(error.flank_plus, 0.004 * std::sqrt(3.0) / 2.0, 1e-15);
}

TEST(FunctionalError, RadialGrowthMovesBothFlanksInward) {
  const FunctionalError error = functionalError({0.010, 0.0, 0.0}, Hand::Right, 3.0, 24.0);
  EXPECT_NEAR(error.flank_plus, -0.005, 1e-15);
  EXPECT_NEAR(error.flank_minus, -0.005, 1e-15);
  EXPECT_NEAR(error.pitch_diameter, 0.020, 1e-15);
}

}  // namespace
}  // namespace nineline::thread_grinding
