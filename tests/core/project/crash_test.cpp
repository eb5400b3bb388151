#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <random>

#include "core/base/text.h"
#include "tests/core/project/project_folder.h"

namespace nineline::project {
namespace {

class CrashTest : public ProjectFolder {};

constexpr std::size_t kBytes = 200000;

std::string contentOf(long long counter) {
  return std::to_string(counter) + "\n" + std::string(kBytes, static_cast<char>('a' + counter % 26));
}

/// Saves one state after the other until it is killed; tells each save that returned through the pipe.
[[noreturn]] void saveForever(const std::filesystem::path& path, long long counter, int pipe) {
  Result<ProjectFile> project = ProjectFile::open(path);
  if (!project) _exit(3);
  for (;;) {
    ++counter;
    const Result<Saved> saved =
        project->save(Change()
                          .put(DocumentKind::Program, "a", contentOf(counter))
                          .put(DocumentKind::Program, "b", contentOf(counter))
                          .put(DocumentKind::Setting, "counter", std::to_string(counter)));
    if (!saved || write(pipe, &counter, sizeof counter) != sizeof counter) _exit(4);
  }
}

/// Runs the child until it has told of so many saves and, somewhere in the next one, kills it. Returns the
/// last save that it told of.
long long killWhileSaving(const std::filesystem::path& path, long long counter, unsigned long saves,
                          unsigned long spin) {
  int ends[2];
  if (pipe(ends) != 0) return -1;
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    saveForever(path, counter, ends[1]);
  }
  close(ends[1]);
  long long told = counter;
  for (unsigned long i = 0; i < saves; ++i) {
    if (read(ends[0], &told, sizeof told) != sizeof told) break;
  }
  std::atomic<unsigned long> wait{0};  // busy, for a length that the seed decides
  while (wait++ < spin) continue;
  kill(child, SIGKILL);
  long long last = 0;
  while (read(ends[0], &last, sizeof last) == sizeof last) told = last;
  int status = 0;
  waitpid(child, &status, 0);
  close(ends[0]);
  return WIFSIGNALED(status) ? told : -1;
}

TEST_F(CrashTest, FiftyKillsInTheMiddleOfWriting) {
  good(good(ProjectFile::create(path()))
           .save(Change()
                     .put(DocumentKind::Program, "a", contentOf(0))
                     .put(DocumentKind::Program, "b", contentOf(0))
                     .put(DocumentKind::Setting, "counter", "0")));
  std::mt19937 random(50);
  long long counter = 0;
  int in_the_middle = 0;
  for (int crash = 0; crash < 50; ++crash) {
    const long long told = killWhileSaving(path(), counter, 1 + random() % 3, random() % 3000000);
    ASSERT_GE(told, counter) << "the child did not work";
    in_the_middle += std::filesystem::exists(path().string() + "-journal") ? 1 : 0;

    const ProjectFile project = good(ProjectFile::open(path()));
    const std::optional<long long> found =
        parseInteger(*good(project.find(DocumentKind::Setting, "counter")));
    ASSERT_TRUE(found);
    EXPECT_GE(*found, told) << "a save that returned is on the disk";
    EXPECT_LE(*found, told + 1) << "at most the save that was under way";
    EXPECT_EQ(good(project.find(DocumentKind::Program, "a")), contentOf(*found));
    EXPECT_EQ(good(project.find(DocumentKind::Program, "b")), contentOf(*found))
        << "all of a save or nothing";
    counter = *found;
  }
  EXPECT_GE(in_the_middle, 10) << "too few of the kills came in the middle of a save to say anything";
  RecordProperty("in_the_middle", in_the_middle);
}

}  // namespace
}  // namespace nineline::project
