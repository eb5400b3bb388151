#include "core/project/change.h"

#include <gtest/gtest.h>

#include "core/project/checksum.h"

namespace nineline::project {
namespace {

TEST(Change, KeepsTheOrderOfItsParts) {
  const Change change =
      Change().setMachine("m").remove(DocumentKind::Program, "p").addModel("t", "n").selectModel(4);
  ASSERT_EQ(change.documents().size(), 2U);
  EXPECT_EQ(change.documents()[0].content, "m");
  EXPECT_FALSE(change.documents()[1].content);
  EXPECT_EQ(change.models()[0].note, "n");
  EXPECT_EQ(change.selectedModel(), 4);
}

TEST(Change, DescribesDocumentsInWords) {
  EXPECT_EQ(describe(DocumentKind::Machine, ""), "machine");
  EXPECT_EQ(describe(DocumentKind::Measurement, "z.csv"), "measurement 'z.csv'");
  EXPECT_EQ(describe(DocumentKind::Setting, "a\nb"), "setting 'a\\x0ab'");
}

TEST(Checksum, OfTheEmptyTextAndOfA) {
  // FNV-1a of "a" is af63dc4c8601ec8c; the length, one byte of 1 and seven of 0, follows.
  std::uint64_t expected = 0xaf63dc4c8601ec8cULL;
  expected = (expected ^ 1U) * 1099511628211ULL;
  for (int i = 0; i < 7; ++i) expected *= 1099511628211ULL;
  EXPECT_EQ(static_cast<std::uint64_t>(Checksum().add("a").value()), expected);
}

TEST(Checksum, TellsFieldsApart) {
  EXPECT_NE(Checksum().add("ab").add("c").value(), Checksum().add("a").add("bc").value());
  EXPECT_NE(Checksum().add("").add("a").value(), Checksum().add("a").add("").value());
  EXPECT_NE(Checksum().add(std::int64_t{1}).value(), Checksum().add(std::int64_t{2}).value());
}

}  // namespace
}  // namespace nineline::project
