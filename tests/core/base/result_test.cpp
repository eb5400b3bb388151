#include "core/base/result.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "core/base/progress.h"

namespace nineline {
namespace {

TEST(Error, MessageNamesWhatIsKnownOfThePlace) {
  EXPECT_EQ(badInput("a.b", "Text.", "file.nc", 3, 7).message(), "file.nc:3:7: Text.");
  EXPECT_EQ(badInput("a.b", "Text.", "file.nc", 3).message(), "file.nc:3: Text.");
  EXPECT_EQ(badInput("a.b", "Text.", "file.nc").message(), "file.nc: Text.");
  EXPECT_EQ(badInput("a.b", "Text.", "", 3, 7).message(), "line 3:7: Text.");
  EXPECT_EQ(badInput("a.b", "Text.").message(), "Text.");
}

TEST(Error, KindsAreTheExitStatuses) {
  EXPECT_EQ(static_cast<int>(usageError("a", "b").kind), 2);
  EXPECT_EQ(static_cast<int>(badInput("a", "b").kind), 3);
  EXPECT_EQ(static_cast<int>(noAnswer("a", "b").kind), 4);
  EXPECT_EQ(static_cast<int>(ErrorKind::Transfer), 5);
}

TEST(Error, CancellingIsNoAnswer) {
  EXPECT_EQ(cancelled().kind, ErrorKind::NoAnswer);
  EXPECT_EQ(cancelled().code, "cancelled");
}

TEST(Result, HoldsAValueOrAnError) {
  const Result<std::string> good = std::string("yes");
  ASSERT_TRUE(good);
  EXPECT_TRUE(good.has_value());
  EXPECT_EQ(*good, "yes");
  EXPECT_EQ(good->size(), 3U);
  EXPECT_EQ(good.value_or("no"), "yes");

  const Result<std::string> bad = badInput("code", "no");
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.error().code, "code");
  EXPECT_EQ(bad.value_or("otherwise"), "otherwise");
}

TEST(Result, AskingForWhatIsNotThereIsAContractViolation) {
  const Result<int> good = 1;
  const Result<int> bad = badInput("code", "the reason");
  EXPECT_THROW((void)good.error(), ContractViolation);
  try {
    (void)bad.value();
    FAIL() << "a value was given";
  } catch (const ContractViolation& violation) {
    EXPECT_NE(std::string(violation.what()).find("the reason"), std::string::npos) << violation.what();
  }
}

TEST(Result, CarriesWhatCanOnlyBeMoved) {
  Result<std::unique_ptr<int>> made = std::make_unique<int>(7);
  ASSERT_TRUE(made);
  const std::unique_ptr<int> taken = std::move(made).value();
  EXPECT_EQ(*taken, 7);
}

TEST(Result, VoidIsGoodUntilGivenAnError) {
  const Result<void> good;
  EXPECT_TRUE(good);
  EXPECT_THROW((void)good.error(), ContractViolation);
  const Result<void> bad = usageError("code", "text");
  EXPECT_FALSE(bad);
  EXPECT_EQ(bad.error().kind, ErrorKind::Usage);
}

TEST(Contract, NamesConditionAndValues) {
  const int count = -3;
  try {
    NL_EXPECTS(count >= 0, count, "apples");
    FAIL() << "nothing was thrown";
  } catch (const ContractViolation& violation) {
    const std::string text = violation.what();
    EXPECT_NE(text.find("count >= 0"), std::string::npos) << text;
    EXPECT_NE(text.find("[-3] [apples]"), std::string::npos) << text;
    EXPECT_NE(text.find("result_test.cpp"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace nineline
