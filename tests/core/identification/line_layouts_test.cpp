#include "core/identification/line_layouts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace nineline::identification {
namespace {

/// The ranks of theory.md, 2.1: 51 unknowns of which 3 are squarenesses.
TEST(LineLayouts, HaveTheRanksOfTheTheory) {
  const LayoutSize size;
  EXPECT_EQ(layoutReport(nineLengthLines(size)).unknowns, 51);
  EXPECT_EQ(layoutReport(nineLengthLines(size)).rank, 27);
  EXPECT_EQ(layoutReport(twelveLines(size)).rank, 36);
  EXPECT_EQ(layoutReport(fourteenLines(size)).rank, 42);
  EXPECT_EQ(layoutReport(twentyTwoLines(size)).rank, 48);
  EXPECT_EQ(layoutReport(nineFullLines(size, true)).rank, 45);
  EXPECT_EQ(layoutReport(nineFullLines(size, false)).rank, 51);
  std::vector<VolumeLine> with_diagonals = nineFullLines(size, true);
  for (const VolumeLine& line : faceDiagonals(size)) with_diagonals.push_back(line);
  EXPECT_EQ(layoutReport(with_diagonals).rank, 48);
}

TEST(LineLayouts, NameWhatTheyDoNotTell) {
  const LayoutReport inclined = layoutReport(nineFullLines({}, true));
  EXPECT_THAT(inclined.unobservable,
              testing::UnorderedElementsAre("EAX q^1", "EBY q^1", "ECZ q^1", "A0Z", "B0Z", "C0Y"));
}

}  // namespace
}  // namespace nineline::identification
