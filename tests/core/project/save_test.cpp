#include "core/project/save.h"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>
#include <thread>

#include "core/base/file.h"
#include "tests/core/project/project_folder.h"

namespace nineline::project {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Two windows on one file, which holds a machine and a program.
class TwoWindows : public ProjectFolder {
 protected:
  TwoWindows() {
    one_ = std::make_unique<ProjectFile>(good(ProjectFile::create(path())));
    good(one_->save(Change().setMachine("m").put(DocumentKind::Program, "p", "text")));
    two_ = std::make_unique<ProjectFile>(good(ProjectFile::open(path())));
  }
  std::unique_ptr<ProjectFile> one_;
  std::unique_ptr<ProjectFile> two_;
};

TEST_F(TwoWindows, SavesOfDifferentDocumentsBothStay) {
  good(one_->save(Change().setMachine("of one")));
  good(two_->save(Change().put(DocumentKind::Program, "p", "of two")));
  good(one_->save(Change().setMachine("of one again")));
  EXPECT_EQ(good(two_->machine()), "of one again");
  EXPECT_EQ(good(one_->find(DocumentKind::Program, "p")), "of two");
}

TEST_F(TwoWindows, NoWindowWritesOverWhatItHasNotSeen) {
  good(one_->save(Change().setMachine("of one")));
  // A save of something else must not make the second window believe that it knows the machine.
  good(two_->save(Change().put(DocumentKind::Program, "p", "of two")));
  const Result<Saved> refused =
      two_->save(Change().setMachine("of two").put(DocumentKind::Program, "q", "x"));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "project.changed");
  EXPECT_THAT(refused.error().text, HasSubstr("machine"));
  EXPECT_EQ(good(two_->machine()), "of one");
  EXPECT_EQ(good(two_->find(DocumentKind::Program, "q")), std::nullopt) << "all of a change or nothing";
}

TEST_F(TwoWindows, AfterReadingAgainAWindowMaySave) {
  good(one_->save(Change().setMachine("of one")));
  ASSERT_FALSE(two_->save(Change().setMachine("of two")));
  EXPECT_THAT(good(two_->foreignChanges()), ElementsAre("machine"));
  good(two_->reload());
  EXPECT_THAT(good(two_->foreignChanges()), IsEmpty());
  good(two_->save(Change().setMachine("of two")));
  EXPECT_EQ(good(one_->machine()), "of two");
}

TEST_F(TwoWindows, NewAndRemovedDocumentsCollideToo) {
  good(one_->save(Change().put(DocumentKind::Program, "new", "of one").remove(DocumentKind::Program, "p")));
  EXPECT_EQ(two_->save(Change().put(DocumentKind::Program, "new", "of two")).error().code, "project.changed");
  EXPECT_EQ(two_->save(Change().put(DocumentKind::Program, "p", "of two")).error().code, "project.changed");
  EXPECT_EQ(two_->save(Change().remove(DocumentKind::Program, "new")).error().code, "project.changed");
  EXPECT_THAT(good(two_->foreignChanges()), ElementsAre("program 'new'", "program 'p' (removed)"));
}

TEST_F(TwoWindows, ADocumentMadeAnewIsNotTheOneThatWasSeen) {
  good(one_->save(Change().remove(DocumentKind::Program, "p")));
  good(one_->save(Change().put(DocumentKind::Program, "p", "anew")));
  EXPECT_EQ(two_->save(Change().put(DocumentKind::Program, "p", "of two")).error().code, "project.changed");
}

TEST_F(TwoWindows, TheSameContentIsNoCollision) {
  good(one_->save(Change().setMachine("new")));
  EXPECT_TRUE(two_->save(Change().setMachine("new")));
  good(two_->save(Change().setMachine("newer")));
}

TEST_F(TwoWindows, ModelVersionsOfBothStay) {
  good(one_->save(Change().addModel("base", "")));
  good(two_->reload());
  good(one_->save(Change().addModel("of one", "")));
  good(two_->save(Change().addModel("of two", "")));
  const std::vector<ModelVersion> history = good(one_->modelHistory());
  ASSERT_EQ(history.size(), 3U);
  EXPECT_EQ(history[1].parent, 1);
  EXPECT_EQ(history[2].parent, 1) << "the second window had not seen version 2";
  EXPECT_EQ(good(one_->model(2)), "of one");
  EXPECT_EQ(good(one_->model(3)), "of two");
  EXPECT_EQ(one_->currentModel(), 2) << "each window stays with its own until it reads again";
  EXPECT_THAT(good(one_->foreignChanges()), ElementsAre("version 3 of the error model"));
}

TEST_F(TwoWindows, SavingAtTheSameTimeLosesNothing) {
  constexpr int kEach = 25;
  const auto work = [](ProjectFile& project, const std::string& name) {
    for (int i = 0; i < kEach; ++i) {
      const Result<Saved> saved = project.save(
          Change().put(DocumentKind::Measurement, name, std::to_string(i)).addModel(name, std::to_string(i)));
      if (!saved) return saved.error().message();
    }
    return std::string();
  };
  std::string fault_of_two;
  std::thread second([&] { fault_of_two = work(*two_, "two"); });
  const std::string fault_of_one = work(*one_, "one");
  second.join();
  EXPECT_EQ(fault_of_one + fault_of_two, "");
  const ProjectFile project = good(ProjectFile::open(path()));
  EXPECT_EQ(good(project.modelHistory()).size(), 2U * kEach);
  EXPECT_EQ(project.revision(), 1 + 2 * kEach);
  EXPECT_EQ(good(project.find(DocumentKind::Measurement, "one")), std::to_string(kEach - 1));
}

TEST_F(TwoWindows, AFileThatWasReplacedIsNotWritten) {
  good(two_->saveCopy(path("other.nineline")));
  std::filesystem::rename(path("other.nineline"), path());
  EXPECT_EQ(one_->save(Change().setMachine("x")).error().code, "project.replaced");
  std::filesystem::remove(path());
  EXPECT_EQ(one_->save(Change().setMachine("x")).error().code, "project.replaced");
  good(one_->saveCopy(path("rescued.nineline")));
  EXPECT_EQ(good(good(ProjectFile::open(path("rescued.nineline"))).machine()), "m");
}

TEST_F(TwoWindows, AFullDiskLeavesTheLastSave) {
  rlimit old{};
  getrlimit(RLIMIT_FSIZE, &old);
  auto* const old_handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{1 << 16, old.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const Result<Saved> refused =
      one_->save(Change().setMachine("too much").put(DocumentKind::Program, "p", std::string(1 << 20, 'x')));
  const Result<void> no_copy = two_->saveCopy(path("copy.nineline"));
  const Result<Saved> fits = one_->save(Change().put(DocumentKind::Program, "p", "small"));
  setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, old_handler);

  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().code, ::testing::AnyOf("project.io", "project.disk_full"));
  EXPECT_TRUE(fits) << "the project stays usable: " << fits.error().message();
  EXPECT_TRUE(no_copy) << "a small copy fits";
  const ProjectFile project = good(ProjectFile::open(path()));
  EXPECT_EQ(good(project.machine()), "m");
  EXPECT_EQ(good(project.find(DocumentKind::Program, "p")), "small");
}

}  // namespace
}  // namespace nineline::project
