#include "core/project/schema.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>

#include <random>

#include "core/base/file.h"
#include "core/project/database.h"
#include "tests/core/project/project_folder.h"

namespace nineline::project {
namespace {

using ::testing::HasSubstr;

class SchemaTest : public ProjectFolder {
 protected:
  std::string refusal() {
    const Result<ProjectFile> project = ProjectFile::open(path());
    return project ? "opened" : project.error().code;
  }
  void sql(const std::string& commands) {
    SQLite::Database(path().string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec(commands);
  }
  void makeProject() {
    ProjectFile project = good(ProjectFile::create(path()));
    for (int i = 0; i < 3; ++i) {
      good(project.save(Change()
                            .setMachine("machine " + std::to_string(i))
                            .put(DocumentKind::Program, "p" + std::to_string(i), std::string(5000, 'p'))
                            .addModel(std::string(300, 'm'), "note")
                            .addResult("compensate", "{}", std::string(2000, 'r'))));
    }
    good(project.save(Change().remove(DocumentKind::Program, "p1")));  // leaves free pages
  }
  /// Everything that the project tells, in one text.
  static std::string contents(const ProjectFile& project) {
    std::string all = good(project.machine()).value_or("none");
    for (const auto kind : {DocumentKind::Measurement, DocumentKind::Program, DocumentKind::Setting}) {
      for (const std::string& name : good(project.names(kind))) all += name + *good(project.find(kind, name));
    }
    for (const ModelVersion& version : good(project.modelHistory()))
      all += version.note + version.saved_at + good(project.model(version.id));
    for (const ResultInfo& info : good(project.results()))
      all += info.kind + info.saved_at + good(project.result(info.id)).bytes;
    return all + std::to_string(project.revision()) + std::to_string(project.currentModel().value_or(0));
  }
};

TEST_F(SchemaTest, WhatIsNoProjectIsRefused) {
  good(writeFile(path(), ""));
  EXPECT_EQ(refusal(), "project.foreign") << "an empty file";
  good(writeFile(path(), std::string(100000, 'x')));
  EXPECT_EQ(refusal(), "project.foreign") << "text";
  std::filesystem::remove(path());
  sql("CREATE TABLE t (x)");
  EXPECT_EQ(refusal(), "project.foreign") << "the database of another program";
  const std::string before = good(readFile(path()));
  EXPECT_EQ(refusal(), "project.foreign");
  EXPECT_EQ(good(readFile(path())), before) << "and it is left as it was";
}

TEST_F(SchemaTest, ANewerProjectIsRefusedAndLeftAlone) {
  makeProject();
  sql("PRAGMA user_version = 999");
  const std::string before = good(readFile(path()));
  const Result<ProjectFile> project = ProjectFile::open(path());
  ASSERT_FALSE(project);
  EXPECT_EQ(project.error().code, "project.newer");
  EXPECT_THAT(project.error().text, HasSubstr("999"));
  EXPECT_EQ(good(readFile(path())), before);
}

TEST_F(SchemaTest, AnOlderProjectIsBroughtUpToDate) {
  sql("PRAGMA application_id = " + std::to_string(kApplicationId));  // format 0: nothing but the id
  ProjectFile project = good(ProjectFile::open(path()));
  good(project.save(Change().setMachine("m")));
  SQLite::Database database(path().string());
  EXPECT_EQ(database.execAndGet("PRAGMA user_version").getInt(), kFormat);
}

TEST_F(SchemaTest, AChangedDocumentIsNoticed) {
  for (const char* command :
       {"UPDATE document SET content = 'other' WHERE kind = 0", "UPDATE document SET revision = 9",
        "UPDATE document SET name = 'q' WHERE name = 'p0'", "DELETE FROM document WHERE name = 'p0'",
        "UPDATE model SET note = 'other' WHERE id = 2", "UPDATE model SET parent = 1 WHERE id = 3",
        "DELETE FROM model WHERE id = 1", "UPDATE result SET record = x'00'",
        "DELETE FROM result WHERE id = 2", "UPDATE state SET revision = 7",
        "UPDATE state SET current_model = 1", "DELETE FROM state", "UPDATE state SET next_result = 1"}) {
    std::filesystem::remove(path());
    makeProject();
    ASSERT_EQ(refusal(), "opened");
    sql(command);
    EXPECT_EQ(refusal(), "project.damaged") << command;
  }
}

TEST_F(SchemaTest, AForeignTableOrTriggerIsNoticed) {
  for (const char* command : {"CREATE TABLE t (x)", "CREATE VIEW v AS SELECT 1", "DROP TABLE result",
                              "CREATE TRIGGER g AFTER INSERT ON model BEGIN DELETE FROM document; END",
                              "ALTER TABLE model ADD COLUMN more"}) {
    std::filesystem::remove(path());
    makeProject();
    sql(command);
    EXPECT_EQ(refusal(), "project.damaged") << command;
  }
}

TEST_F(SchemaTest, DamageIsRefusedOrHarmlessNeverHidden) {
  makeProject();
  const std::string whole = good(readFile(path()));
  const std::string expected = contents(good(ProjectFile::open(path())));
  std::mt19937 random(20260310);
  int opened = 0;
  for (int variant = 0; variant < 200; ++variant) {
    std::string bytes = whole;
    if (variant % 4 == 0) {
      bytes.resize(random() % whole.size());
    } else {
      const std::size_t most = variant % 4 == 1 ? 1 : variant % 4 == 2 ? 8 : 200;
      for (std::size_t flips = 0; flips < most; ++flips) {
        const std::size_t place = variant % 8 < 4 ? random() % bytes.size() : random() % 2048;
        bytes[place] = static_cast<char>(bytes[place] ^ (1 << random() % 8));
      }
    }
    good(writeFile(path(), bytes));
    Result<ProjectFile> project = ProjectFile::open(path());
    if (!project) {
      EXPECT_THAT(project.error().code, HasSubstr("project.")) << "variant " << variant;
      continue;
    }
    ++opened;
    EXPECT_EQ(contents(*project), expected) << "variant " << variant;
  }
  EXPECT_LE(opened, 100) << "a flip in unused space is harmless; half the variants hit more than that";
  RecordProperty("opened", opened);
}

TEST_F(SchemaTest, EveryTruncationAtAPageIsRefused) {
  makeProject();
  const std::string whole = good(readFile(path()));
  for (std::size_t length = 0; length < whole.size(); length += 1024) {
    good(writeFile(path(), std::string_view(whole).substr(0, length)));
    EXPECT_THAT(refusal(), HasSubstr("project.")) << length;
  }
}

}  // namespace
}  // namespace nineline::project
