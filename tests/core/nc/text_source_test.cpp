#include "core/nc/text_source.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace nineline::nc {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> linesOf(TextSource& source, std::string& rebuilt) {
  std::vector<std::string> lines;
  for (std::uint64_t offset = 0; offset < source.size();) {
    const Result<TextSource::Line> line = source.lineAt(offset);
    if (!line) {
      ADD_FAILURE() << line.error().message();
      break;
    }
    lines.emplace_back(line->text);
    rebuilt += std::string(line->text) + std::string(line->line_end);
    offset = line->next;
  }
  return lines;
}

/// A file that is gone after the test.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& bytes)
      : path_(fs::temp_directory_path() /
              ("nineline-text-" + std::to_string(reinterpret_cast<std::uintptr_t>(this)))) {
    std::ofstream(path_, std::ios::binary) << bytes;
  }
  ~TemporaryFile() { fs::remove(path_); }
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

const std::string kMixed = std::string("G0 X1\r\nG1\nX2\rX3\n\nlast\0end", 28);

TEST(TextSource, KeepsEveryByteAndSplitsAtAnyLineEnd) {
  MemoryText text("m", kMixed);
  std::string rebuilt;
  const std::vector<std::string> lines = linesOf(text, rebuilt);
  EXPECT_EQ(rebuilt, kMixed);
  ASSERT_EQ(lines.size(), 6U);
  EXPECT_EQ(lines[0], "G0 X1");
  EXPECT_EQ(lines[2], "X2");
  EXPECT_EQ(lines[3], "X3");
  EXPECT_EQ(lines[4], "");
}

TEST(TextSource, FileReadsAsMemoryDoesBeyondItsWindow) {
  std::string bytes;
  for (int i = 0; i < 700'000; ++i) bytes += "N" + std::to_string(i) + " X1.5" + (i % 3 == 0 ? "\r\n" : "\n");
  bytes += "M30";
  ASSERT_GT(bytes.size(), std::size_t{8} << 20);
  const TemporaryFile file(bytes);
  Result<std::unique_ptr<TextSource>> source = openTextFile(file.path());
  ASSERT_TRUE(source) << source.error().message();
  std::string rebuilt;
  const std::vector<std::string> lines = linesOf(**source, rebuilt);
  EXPECT_TRUE(rebuilt == bytes);
  EXPECT_EQ(lines.back(), "M30");
  EXPECT_EQ((*source)->lineAt(0)->text, "N0 X1.5");  // back to the start
}

TEST(TextSource, RefusesWhatIsNoFileOrNoProgram) {
  EXPECT_FALSE(openTextFile("/no/such/file.nc"));
  EXPECT_FALSE(openTextFile(fs::temp_directory_path()));
  MemoryText endless("m", std::string((std::size_t{1} << 20) + 2, 'X'));
  EXPECT_EQ(endless.lineAt(0).error().code, "nc.LineTooLong");
  const TemporaryFile file(std::string(std::size_t{9} << 20, 'X'));
  Result<std::unique_ptr<TextSource>> source = openTextFile(file.path());
  ASSERT_TRUE(source);
  EXPECT_EQ((*source)->lineAt(0).error().code, "nc.LineTooLong");
}

}  // namespace
}  // namespace nineline::nc
