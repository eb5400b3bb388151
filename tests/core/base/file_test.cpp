#include "core/base/file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>

namespace nineline {
namespace {

namespace fs = std::filesystem;

class FileTest : public ::testing::Test {
 protected:
  FileTest() {
    std::string pattern = (fs::temp_directory_path() / "nineline-file-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  ~FileTest() override { fs::remove_all(folder_); }

  [[nodiscard]] std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  [[nodiscard]] fs::path path(const char* name) const { return folder_ / name; }
  static std::string bytesOf(const fs::path& path) { return readFile(path).value_or("(unreadable)"); }

  fs::path folder_;
};

/// Limits how long a file may grow, as a full disk would, while it lives.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t most_bytes) {
    getrlimit(RLIMIT_FSIZE, &old_);
    old_handler_ = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{most_bytes, old_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~SmallDisk() {
    setrlimit(RLIMIT_FSIZE, &old_);
    std::signal(SIGXFSZ, old_handler_);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

 private:
  rlimit old_{};
  void (*old_handler_)(int) = nullptr;
};

TEST_F(FileTest, EveryByteComesBack) {
  std::string bytes;
  for (int i = 0; i < 70000; ++i) bytes += static_cast<char>(i % 256);
  ASSERT_TRUE(writeFile(path("a"), bytes));
  EXPECT_EQ(bytesOf(path("a")), bytes);
  ASSERT_TRUE(writeFile(path("a"), ""));
  EXPECT_EQ(bytesOf(path("a")), "");
  EXPECT_EQ(entries(), 1U);
}

TEST_F(FileTest, ReadingWhatIsNoFileIsRefused) {
  EXPECT_EQ(readFile(path("gone")).error().code, "file.missing");
  EXPECT_EQ(readFile(path("gone")).error().source, path("gone").string());
  EXPECT_EQ(readFile(folder_).error().code, "file.kind");
  EXPECT_EQ(readFile("/dev/zero").error().code, "file.kind");
}

TEST_F(FileTest, WithoutCommitTheOldFileStays) {
  ASSERT_TRUE(writeFile(path("a"), "old"));
  {
    Result<AtomicFile> file = AtomicFile::create(path("a"));
    ASSERT_TRUE(file);
    ASSERT_TRUE(file->write("new"));
    ASSERT_TRUE(file->flush());
    EXPECT_EQ(bytesOf(file->temporaryPath()), "new");
    EXPECT_EQ(bytesOf(path("a")), "old");
  }
  EXPECT_EQ(bytesOf(path("a")), "old");
  EXPECT_EQ(entries(), 1U) << "the temporary file is gone";
}

TEST_F(FileTest, MovedFilesCommitOnce) {
  Result<AtomicFile> file = AtomicFile::create(path("a"));
  ASSERT_TRUE(file);
  AtomicFile moved = std::move(*file);
  ASSERT_TRUE(moved.write("x"));
  ASSERT_TRUE(moved.commit());
  EXPECT_EQ(bytesOf(path("a")), "x");
  EXPECT_EQ(entries(), 1U);
}

TEST_F(FileTest, AFolderThatIsMissingIsNamed) {
  const Result<void> written = writeFile(folder_ / "no" / "such" / "a", "x");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, "file.create");
  EXPECT_EQ(written.error().source, (folder_ / "no" / "such" / "a").string());
}

TEST_F(FileTest, AFolderInPlaceOfTheFileIsRefused) {
  fs::create_directory(path("d"));
  EXPECT_EQ(writeFile(path("d"), "x").error().code, "file.kind");
}

TEST_F(FileTest, AReadOnlyFolderIsRefused) {
  if (geteuid() == 0) {
    // Root may write anywhere but into the kernel's own folders.
    EXPECT_EQ(writeFile("/proc/nineline-test", "x").error().code, "file.create");
    return;
  }
  fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_EQ(writeFile(path("a"), "x").error().code, "file.create");
  fs::permissions(folder_, fs::perms::owner_all);
}

TEST_F(FileTest, AFullDiskLeavesTheOldFileUntouched) {
  ASSERT_TRUE(writeFile(path("a"), "old"));
  {
    const SmallDisk disk(1 << 16);
    const Result<void> small = writeFile(path("b"), std::string(1000, 'x'));
    EXPECT_TRUE(small) << "what fits is written";
    const Result<void> large = writeFile(path("a"), std::string(1 << 20, 'x'));
    ASSERT_FALSE(large);
    EXPECT_EQ(large.error().code, "file.write");
    EXPECT_NE(large.error().text.find("untouched"), std::string::npos);
  }
  EXPECT_EQ(bytesOf(path("a")), "old");
  EXPECT_EQ(entries(), 2U) << "a and b; the temporary file is gone";
}

TEST_F(FileTest, AFullDiskIsNoticedInBufferedBytesToo) {
  const SmallDisk disk(100);
  Result<AtomicFile> file = AtomicFile::create(path("a"));
  ASSERT_TRUE(file);
  EXPECT_TRUE(file->write(std::string(200, 'x'))) << "still in the buffer";
  EXPECT_FALSE(file->commit());
  EXPECT_FALSE(fs::exists(path("a")));
}

TEST_F(FileTest, PermissionsOfTheOldFileStay) {
  ASSERT_TRUE(writeFile(path("a"), "old"));
  ASSERT_EQ(chmod(path("a").c_str(), 0640), 0);
  ASSERT_TRUE(writeFile(path("a"), "new"));
  struct stat now {};
  ASSERT_EQ(stat(path("a").c_str(), &now), 0);
  EXPECT_EQ(now.st_mode & 07777, 0640U);
}

TEST_F(FileTest, ALinkStaysALink) {
  ASSERT_TRUE(writeFile(path("a"), "old"));
  fs::create_symlink(path("a"), path("link"));
  ASSERT_TRUE(writeFile(path("link"), "new"));
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(bytesOf(path("a")), "new");
}

}  // namespace
}  // namespace nineline
