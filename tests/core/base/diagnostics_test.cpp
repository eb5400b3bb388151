#include "core/base/diagnostics.h"

#include <gtest/gtest.h>

namespace nineline {
namespace {

TEST(Diagnostics, BeginWithoutFindings) {
  const Diagnostics none;
  EXPECT_TRUE(none.all().empty());
  EXPECT_FALSE(none.hasErrors());
  EXPECT_FALSE(none.full());
  EXPECT_THROW((void)none.firstError("file"), ContractViolation);
}

TEST(Diagnostics, KeepTheOrderAndThePlaces) {
  Diagnostics found;
  found.warning("w", "a warning", 2, 5);
  found.error("e1", "first", 3, 7);
  found.error("e2", "second", 4);
  ASSERT_EQ(found.all().size(), 3U);
  EXPECT_EQ(found.all()[0].severity, Severity::Warning);
  const Error first = found.firstError("part.nc");
  EXPECT_EQ(first.kind, ErrorKind::BadInput);
  EXPECT_EQ(first.code, "e1");
  EXPECT_EQ(first.message(), "part.nc:3:7: first");
}

TEST(Diagnostics, WarningsAreNoErrors) {
  Diagnostics found;
  for (int i = 0; i < 500; ++i) found.warning("w", "text");
  EXPECT_FALSE(found.hasErrors());
  EXPECT_FALSE(found.full());
}

TEST(Diagnostics, AreFullAtTwoHundredErrors) {
  Diagnostics found;
  for (int i = 0; i < 199; ++i) found.error("e", "text");
  EXPECT_FALSE(found.full());
  found.error("e", "text");
  EXPECT_TRUE(found.full());
}

TEST(Diagnostics, CountTheSameWarningOnce) {
  Diagnostics found;
  found.countedWarning("table.range", "outside the table", 10);
  found.countedWarning("table.range", "outside the table", 20);
  found.countedWarning("table.range", "outside another table", 30);
  ASSERT_EQ(found.all().size(), 2U);
  EXPECT_EQ(found.all()[0].count, 2U);
  EXPECT_EQ(found.all()[0].line, 10U) << "the place is that of the first";
  EXPECT_EQ(found.all()[1].count, 1U);
}

TEST(Diagnostics, AppendedErrorsCount) {
  Diagnostics one;
  Diagnostics other;
  other.error("e", "text", 1);
  other.warning("w", "text", 2);
  one.append(other);
  EXPECT_TRUE(one.hasErrors());
  EXPECT_EQ(one.all().size(), 2U);
}

}  // namespace
}  // namespace nineline
