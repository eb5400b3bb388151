#include "core/project/project_file.h"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/file.h"
#include "core/project/database.h"
#include "core/project/rows.h"
#include "core/project/schema.h"

namespace nineline::project {

namespace fs = std::filesystem;

namespace {

/// Which file of the disk a path leads to; other numbers once the file was replaced.
struct Identity {
  dev_t device = 0;
  ino_t number = 0;
  friend bool operator==(const Identity&, const Identity&) = default;
};

Identity identityOf(const fs::path& path) {
  struct stat found {};
  if (stat(path.c_str(), &found) != 0) return {};
  return {found.st_dev, found.st_ino};
}

/// A file without any write permission counts as read-only even for root, who could write it.
bool mayWrite(const fs::path& path) {
  struct stat found {};
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  return stat(path.c_str(), &found) == 0 && (found.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) != 0 &&
         access(path.c_str(), W_OK) == 0 && access(folder.c_str(), W_OK) == 0;
}

/// Runs what may throw SQLite::Exception; its faults become Errors.
template <typename Action>
auto guarded(const fs::path& path, Action action) -> decltype(action()) {
  try {
    return action();
  } catch (const SQLite::Exception& fault) {
    return databaseError(fault, path);
  }
}

/// All checks see one state of the file, whatever another window saves meanwhile.
Result<Seen> check(SQLite::Database& database, const fs::path& path, bool read_only) {
  if (Result<void> origin = checkOrigin(database, path); !origin) return origin.error();
  if (!read_only) migrate(database);
  SQLite::Transaction reading(database);
  if (Result<void> intact = checkIntegrity(database, path); !intact) return intact.error();
  return readSeen(database);
}

}  // namespace

struct ProjectFile::Open {
  fs::path path;
  Identity identity;
  bool read_only;
  Diagnostics warnings;
  mutable SQLite::Database database;
  Seen seen;
};

ProjectFile::ProjectFile(std::unique_ptr<Open> open) : open_(std::move(open)) {}
ProjectFile::ProjectFile(ProjectFile&&) noexcept = default;
ProjectFile& ProjectFile::operator=(ProjectFile&&) noexcept = default;
ProjectFile::~ProjectFile() = default;

Result<ProjectFile> ProjectFile::create(const fs::path& path) {
  std::error_code fault;
  if (fs::exists(path, fault))
    return badInput("project.exists", "A file of this name stands there already.", path.string());
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return file.error();
  const Result<void> made = guarded(path, [&]() -> Result<void> {
    SQLite::Database database = openDatabase(file->temporaryPath(), false);
    makeSchema(database);
    return {};
  });
  if (!made) return made.error();
  if (Result<void> committed = file->commit(); !committed) return committed.error();
  return open(path);
}

Result<ProjectFile> ProjectFile::open(const fs::path& path) {
  std::error_code fault;
  if (!fs::exists(path, fault)) return badInput("file.missing", "The file does not exist.", path.string());
  if (!fs::is_regular_file(path, fault)) return badInput("file.kind", "This is not a file.", path.string());
  const bool read_only = !mayWrite(path);
  Diagnostics warnings;
  if (read_only)
    warnings.warning("project.read_only", "The project may be read only; nothing can be saved in it.");
  return guarded(path, [&]() -> Result<ProjectFile> {
    auto opened = std::make_unique<Open>(
        Open{path, identityOf(path), read_only, warnings, openDatabase(path, read_only), {}});
    Result<Seen> seen = check(opened->database, path, read_only);
    if (!seen) return seen.error();
    opened->seen = *std::move(seen);
    return ProjectFile(std::move(opened));
  });
}

const fs::path& ProjectFile::path() const { return open_->path; }
bool ProjectFile::isReadOnly() const { return open_->read_only; }
const Diagnostics& ProjectFile::warnings() const { return open_->warnings; }
std::int64_t ProjectFile::revision() const { return open_->seen.revision; }
std::optional<std::int64_t> ProjectFile::currentModel() const { return open_->seen.current_model; }

Result<std::vector<std::string>> ProjectFile::names(DocumentKind kind) const {
  return guarded(open_->path, [&]() -> Result<std::vector<std::string>> {
    std::vector<std::string> found;
    SQLite::Statement query(open_->database, "SELECT name FROM document WHERE kind = ? ORDER BY id");
    query.bind(1, static_cast<int>(kind));
    while (query.executeStep()) found.push_back(query.getColumn(0).getString());
    return found;
  });
}

Result<std::optional<std::string>> ProjectFile::find(DocumentKind kind, const std::string& name) const {
  return guarded(open_->path, [&]() -> Result<std::optional<std::string>> {
    SQLite::Statement query(open_->database, "SELECT content FROM document WHERE kind = ? AND name = ?");
    query.bind(1, static_cast<int>(kind));
    query.bind(2, name);
    if (!query.executeStep()) return std::optional<std::string>();
    return std::optional(query.getColumn(0).getString());
  });
}

Result<std::vector<ModelVersion>> ProjectFile::modelHistory() const {
  return guarded(open_->path, [&]() -> Result<std::vector<ModelVersion>> {
    std::vector<ModelVersion> history;
    SQLite::Statement query(open_->database, "SELECT id, parent, saved_at, note FROM model ORDER BY id");
    while (query.executeStep()) history.push_back(readModelRow(query).version);
    return history;
  });
}

Result<std::string> ProjectFile::model(std::int64_t id) const {
  return guarded(open_->path, [&]() -> Result<std::string> {
    SQLite::Statement query(open_->database, "SELECT content FROM model WHERE id = ?");
    query.bind(1, id);
    if (query.executeStep()) return query.getColumn(0).getString();
    return badInput("project.no_model", fmt::format("The error model has no version {}.", id),
                    open_->path.string());
  });
}

Result<std::vector<ResultInfo>> ProjectFile::results() const {
  return guarded(open_->path, [&]() -> Result<std::vector<ResultInfo>> {
    std::vector<ResultInfo> found;
    SQLite::Statement query(open_->database, "SELECT id, model, saved_at, kind FROM result ORDER BY id");
    while (query.executeStep()) found.push_back(readResultRow(query).info);
    return found;
  });
}

Result<StoredResult> ProjectFile::result(std::int64_t id) const {
  return guarded(open_->path, [&]() -> Result<StoredResult> {
    SQLite::Statement query(open_->database,
                            "SELECT id, model, saved_at, kind, record, content FROM result WHERE id = ?");
    query.bind(1, id);
    if (!query.executeStep())
      return badInput("project.no_result", fmt::format("There is no result {}.", id), open_->path.string());
    ResultRow row = readResultRow(query);
    return StoredResult{std::move(row.info), std::move(row.record), std::move(row.bytes)};
  });
}

Result<Saved> ProjectFile::save(const Change& change) {
  const std::string source = open_->path.string();
  if (open_->read_only)
    return badInput("project.read_only", "The project may be read only. Save it under another name.", source);
  if (Result<void> checked = change.check(); !checked) return checked.error();
  if (identityOf(open_->path) != open_->identity)
    return badInput("project.replaced",
                    "The project's file was moved, deleted or replaced. Save the project under another name.",
                    source);
  return guarded(open_->path, [&] { return writeChange(open_->database, change, open_->seen); });
}

Result<std::vector<std::string>> ProjectFile::foreignChanges() const {
  return guarded(open_->path, [&]() -> Result<std::vector<std::string>> {
    SQLite::Transaction reading(open_->database);
    return differences(open_->seen, readSeen(open_->database));
  });
}

Result<void> ProjectFile::reload() {
  return guarded(open_->path, [&]() -> Result<void> {
    SQLite::Transaction reading(open_->database);
    open_->seen = readSeen(open_->database);
    return {};
  });
}

Result<void> ProjectFile::saveCopy(const fs::path& target) const {
  std::error_code fault;
  if (fs::equivalent(target, open_->path, fault))
    return badInput("project.same", "This is the project's own file, which is saved already.",
                    target.string());
  Result<AtomicFile> file = AtomicFile::create(target);
  if (!file) return file.error();
  const Result<void> copied = guarded(target, [&]() -> Result<void> {
    SQLite::Statement copy(open_->database, "VACUUM INTO ?");
    copy.bind(1, file->temporaryPath().string());
    copy.exec();
    return {};
  });
  if (!copied) return copied.error();
  return file->commit();
}

}  // namespace nineline::project
