#include "core/project/project_file.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "core/base/file.h"
#include "tests/core/project/project_folder.h"

namespace nineline::project {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::MatchesRegex;

class ProjectFileTest : public ProjectFolder {};

std::string everyByte() {
  std::string bytes;
  for (int i = 0; i < 1024; ++i) bytes += static_cast<char>(i % 256);
  return bytes;
}

TEST_F(ProjectFileTest, ANewProjectIsEmptyAndAlone) {
  const ProjectFile project = good(ProjectFile::create(path()));
  EXPECT_EQ(project.revision(), 0);
  EXPECT_EQ(project.path(), path());
  EXPECT_FALSE(project.isReadOnly());
  EXPECT_FALSE(project.currentModel());
  EXPECT_EQ(good(project.machine()), std::nullopt);
  EXPECT_THAT(good(project.names(DocumentKind::Program)), IsEmpty());
  EXPECT_THAT(good(project.modelHistory()), IsEmpty());
  EXPECT_THAT(good(project.results()), IsEmpty());
  EXPECT_EQ(entries(), 1U) << "one file, nothing beside it";
}

TEST_F(ProjectFileTest, AllKindsComeBackByteForByte) {
  {
    ProjectFile project = good(ProjectFile::create(path()));
    const Saved saved = good(project.save(Change()
                                              .setMachine("{\"id\": \"b2\"}")
                                              .put(DocumentKind::Measurement, "z.csv", "#a\r\n1;2\n")
                                              .put(DocumentKind::Program, "Gewinde µ.nc", everyByte())
                                              .put(DocumentKind::Program, "empty.nc", "")
                                              .put(DocumentKind::Setting, "wizard.page", "3")
                                              .addModel("{\"effects\": []}", "typed in")
                                              .addResult("compensate", "{\"blocks\": 7}", everyByte())));
    EXPECT_EQ(saved.revision, 1);
    EXPECT_THAT(saved.models, ElementsAre(1));
    EXPECT_THAT(saved.results, ElementsAre(1));
  }
  const ProjectFile project = good(ProjectFile::open(path()));
  EXPECT_EQ(project.revision(), 1);
  EXPECT_TRUE(project.warnings().all().empty());
  EXPECT_EQ(good(project.machine()), "{\"id\": \"b2\"}");
  EXPECT_EQ(good(project.find(DocumentKind::Measurement, "z.csv")), "#a\r\n1;2\n");
  EXPECT_THAT(good(project.names(DocumentKind::Program)), ElementsAre("Gewinde µ.nc", "empty.nc"));
  EXPECT_EQ(good(project.find(DocumentKind::Program, "Gewinde µ.nc")), everyByte());
  EXPECT_EQ(good(project.find(DocumentKind::Program, "empty.nc")), "");
  EXPECT_EQ(good(project.find(DocumentKind::Program, "gone.nc")), std::nullopt);
  EXPECT_EQ(good(project.find(DocumentKind::Setting, "wizard.page")), "3");
  EXPECT_EQ(good(project.model(1)), "{\"effects\": []}");
  const StoredResult result = good(project.result(1));
  EXPECT_EQ(result.info.kind, "compensate");
  EXPECT_EQ(result.info.model, 1);
  EXPECT_EQ(result.record, "{\"blocks\": 7}");
  EXPECT_EQ(result.bytes, everyByte());
}

TEST_F(ProjectFileTest, ChangedAndRemovedDocuments) {
  ProjectFile project = good(ProjectFile::create(path()));
  good(project.save(Change().put(DocumentKind::Program, "a", "1").put(DocumentKind::Program, "b", "2")));
  good(project.save(Change().put(DocumentKind::Program, "a", "3").remove(DocumentKind::Program, "b")));
  EXPECT_THAT(good(project.names(DocumentKind::Program)), ElementsAre("a"));
  EXPECT_EQ(good(project.find(DocumentKind::Program, "a")), "3");
  EXPECT_EQ(good(project.save(Change().remove(DocumentKind::Program, "never"))).revision, 2);
}

TEST_F(ProjectFileTest, ASaveWithoutDifferenceWritesNothing) {
  ProjectFile project = good(ProjectFile::create(path()));
  good(project.save(Change().setMachine("m").put(DocumentKind::Program, "a", everyByte())));
  const std::string before = good(readFile(path()));
  EXPECT_EQ(
      good(project.save(Change().setMachine("m").put(DocumentKind::Program, "a", everyByte()))).revision, 1);
  EXPECT_EQ(good(project.save(Change())).revision, 1);
  EXPECT_EQ(good(readFile(path())), before);
}

TEST_F(ProjectFileTest, EveryModelVersionStays) {
  ProjectFile project = good(ProjectFile::create(path()));
  good(project.save(Change().addModel("v1", "measured")));
  good(project.save(Change().addModel("v2", "squareness")));
  good(project.save(Change().selectModel(1)));  // undo
  EXPECT_EQ(project.currentModel(), 1);
  good(project.save(Change().addModel("v3", "another way")));
  EXPECT_EQ(project.currentModel(), 3);

  const ProjectFile again = good(ProjectFile::open(path()));
  EXPECT_EQ(again.currentModel(), 3);
  const std::vector<ModelVersion> history = good(again.modelHistory());
  ASSERT_EQ(history.size(), 3U);
  EXPECT_EQ(history[0].parent, std::nullopt);
  EXPECT_EQ(history[1].parent, 1);
  EXPECT_EQ(history[2].parent, 1) << "made after going back to version 1";
  EXPECT_EQ(history[1].note, "squareness");
  EXPECT_THAT(history[1].saved_at, MatchesRegex("[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:[0-9]{2}Z"));
  EXPECT_EQ(good(again.model(2)), "v2");
  EXPECT_EQ(again.model(4).error().code, "project.no_model");
  EXPECT_EQ(project.save(Change().selectModel(9)).error().code, "project.no_model");
}

TEST_F(ProjectFileTest, UndoAndRedoAreKeptInTheFile) {
  ProjectFile project = good(ProjectFile::create(path()));
  good(project.save(Change().addModel("v1", "").addModel("v2", "")));
  good(project.save(Change().selectModel(1)));
  EXPECT_EQ(good(ProjectFile::open(path())).currentModel(), 1);
  good(project.save(Change().selectModel(2)));
  EXPECT_EQ(good(ProjectFile::open(path())).currentModel(), 2);
}

TEST_F(ProjectFileTest, NumbersOfRemovedResultsAreNotUsedAgain) {
  ProjectFile project = good(ProjectFile::create(path()));
  good(project.save(Change().addResult("a", "1").addResult("b", "2")));
  good(project.save(Change().removeResult(2)));
  EXPECT_THAT(good(project.save(Change().addResult("c", "3"))).results, ElementsAre(3));
  EXPECT_EQ(project.result(2).error().code, "project.no_result");
  EXPECT_EQ(good(project.results()).size(), 2U);
  good(ProjectFile::open(path()));
}

TEST_F(ProjectFileTest, SecretsAreRefused) {
  ProjectFile project = good(ProjectFile::create(path()));
  const auto save = [&](const char* key, const char* value) {
    return project.save(Change().put(DocumentKind::Setting, key, value));
  };
  EXPECT_EQ(save("ftp.password", "x").error().code, "project.secret");
  EXPECT_EQ(save("Link/PassPhrase", "x").error().code, "project.secret");
  EXPECT_EQ(save("send.to", "{\"to\": \"ftps://me:pw@host/x\"}").error().code, "project.secret");
  good(save("send.to", "ftps://me@host:21/x tcp://host:5007 a:b@c"));
  good(save("long", std::string(1 << 20, 'a').c_str()));
  EXPECT_THAT(good(project.names(DocumentKind::Setting)), ElementsAre("send.to", "long"));
}

TEST_F(ProjectFileTest, NamesThatNoListCanShowAreRefused) {
  ProjectFile project = good(ProjectFile::create(path()));
  for (const char* name : {"", "a\nb", "\x7f", "\xff"}) {
    EXPECT_EQ(project.save(Change().put(DocumentKind::Program, name, "x")).error().code, "project.name");
  }
  EXPECT_EQ(project.save(Change().put(DocumentKind::Machine, "m", "x")).error().code, "project.name");
  EXPECT_EQ(project.save(Change().addModel("x", "\xff")).error().code, "project.note");
  EXPECT_EQ(project.save(Change().addResult("", "x")).error().code, "project.name");
  EXPECT_EQ(project.revision(), 0);
}

TEST_F(ProjectFileTest, ACopyIsWholeAndOnItsOwn) {
  ProjectFile project = good(ProjectFile::create(path()));
  good(project.save(Change().setMachine("m").addModel("v1", "n").addResult("k", "r", everyByte())));
  good(writeFile(path("old.nineline"), "something else"));
  good(project.saveCopy(path("old.nineline")));
  good(project.save(Change().setMachine("later")));
  ProjectFile copy = good(ProjectFile::open(path("old.nineline")));
  EXPECT_EQ(good(copy.machine()), "m");
  EXPECT_EQ(good(copy.model(1)), "v1");
  EXPECT_EQ(good(copy.result(1)).bytes, everyByte());
  good(copy.save(Change().setMachine("mine")));
  EXPECT_EQ(good(project.machine()), "later");
  EXPECT_EQ(project.saveCopy(path()).error().code, "project.same");
  EXPECT_EQ(project.saveCopy(path("no/such/folder")).error().code, "file.create");
  EXPECT_EQ(entries(), 2U);
}

TEST_F(ProjectFileTest, CreatingReplacesNothing) {
  good(writeFile(path(), "precious"));
  EXPECT_EQ(ProjectFile::create(path()).error().code, "project.exists");
  EXPECT_EQ(good(readFile(path())), "precious");
  EXPECT_EQ(ProjectFile::create(path("no/such/folder")).error().code, "file.create");
}

TEST_F(ProjectFileTest, AReadOnlyFileOpensWithAWarning) {
  good(good(ProjectFile::create(path())).save(Change().setMachine("m")));
  ASSERT_EQ(chmod(path().c_str(), 0444), 0);
  ProjectFile project = good(ProjectFile::open(path()));
  EXPECT_TRUE(project.isReadOnly());
  ASSERT_EQ(project.warnings().all().size(), 1U);
  EXPECT_EQ(project.warnings().all()[0].code, "project.read_only");
  EXPECT_EQ(good(project.machine()), "m");
  EXPECT_EQ(project.save(Change().setMachine("x")).error().code, "project.read_only");
  good(project.saveCopy(path("copy.nineline")));
  EXPECT_EQ(good(good(ProjectFile::open(path("copy.nineline"))).machine()), "m");
}

TEST_F(ProjectFileTest, MessagesNameTheFile) {
  EXPECT_THAT(ProjectFile::open(path("gone")).error().message(), HasSubstr(path("gone").string()));
  EXPECT_EQ(ProjectFile::open(path("gone")).error().code, "file.missing");
  EXPECT_EQ(ProjectFile::open(folder_).error().code, "file.kind");
}

}  // namespace
}  // namespace nineline::project
